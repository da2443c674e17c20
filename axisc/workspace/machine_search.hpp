// The machine that an open file belongs to.
#pragma once

#include "axisc/workspace/asked_files.hpp"
#include "axisc/workspace/buffers.hpp"
#include "validator/options.hpp"

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace axisc {

/// The options with which `lint` checks an input.
using OptionsOf = std::function<validator::CheckOptions(std::string const& path)>;

/// Looks into every list of the folders once, however many files are asked for.
class MachineSearch {
 public:
  /// `options` outlives the search.
  explicit MachineSearch(OptionsOf const& options) : options_(options) {}

  /// The input whose check covers the file: the nearest machine file or start-up list, in the file's folder
  /// or above, that reads it; the file itself where there is none, and where it is a machine. Machine files
  /// come before start-up lists.
  [[nodiscard]] std::string machine_of(Buffers& files, std::string const& path);
  /// What the machines found so far were read from.
  void note_readers(Readers& readers) const;
  /// Where files may have changed.
  void forget() { machines_.clear(); }

 private:
  struct Machine {
    std::string path;
    std::set<std::string> keys;  ///< of the files that it reads
    std::multimap<std::string, std::string> by_name;
    AskedFiles asked;

    [[nodiscard]] bool reads(configuration::Files& files, std::string const& wanted) const;
  };
  [[nodiscard]] std::vector<Machine> const& machines_in(Buffers& files, std::string const& folder);

  OptionsOf const& options_;
  std::map<std::string, std::vector<Machine>> machines_;  ///< by folder
};

/// The same of a single file.
[[nodiscard]] std::string machine_of(configuration::Files& files, std::string const& path,
                                     OptionsOf const& options);

}  // namespace axisc
