// The machine that a file belongs to: the one answer for every face.
#pragma once

#include "axisc/workspace/asked_files.hpp"
#include "axisc/workspace/buffers.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// The input whose check covers a file, and the name by which that input reads it.
struct Belonging {
  std::string machine;  ///< the file itself where no machine reads it
  std::string name;     ///< of the file, as findings of the machine name it
};

/// Looks into every list of the folders once, however many files are asked for. Which files a machine reads
/// depends on no settings: a neighbour's must not be in the way.
class MachineSearch {
 public:
  /// The nearest machine file, project or start-up list, in the file's folder or above, that reads it; the
  /// file itself where there is none, and where it is a machine. Machine files come before start-up lists.
  /// With `from`, a folder ("" or with `/` at the end), only folders above it are searched.
  [[nodiscard]] Belonging machine_of(Buffers& files, std::string const& path,
                                     std::optional<std::string> const& from = std::nullopt);
  /// Adds the files that the machines found so far were read from.
  void note_readers(Readers& readers) const;
  /// To be called when files may have changed.
  void forget() { machines_.clear(); }

 private:
  struct Machine {
    std::string path;
    std::map<std::string, std::string> names;  ///< of the files that it reads, by their keys
    std::multimap<std::string, std::string> by_name;
    AskedFiles asked;

    /// The name by which it reads the file.
    [[nodiscard]] std::optional<std::string> name_of(configuration::Files& files,
                                                     std::string const& wanted) const;
  };
  [[nodiscard]] std::vector<Machine> const& machines_in(Buffers& files, std::string const& folder);

  std::map<std::string, std::vector<Machine>> machines_;  ///< by folder
};

/// The machine of a single file.
[[nodiscard]] Belonging machine_of(configuration::Files& files, std::string const& path);

}  // namespace axisc
