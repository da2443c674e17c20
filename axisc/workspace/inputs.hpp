// Expands the names on the command line to the lists and machine files to check.
#pragma once

#include "axisc/environment/failure.hpp"
#include "diagnostics/message.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

namespace axisc {

/// What is known about an input found in a folder.
struct FoundInput {
  bool is_beside_start_up_list = false;  ///< of which none in this or a folder above names it
};

struct Inputs {
  std::vector<std::string> paths;  ///< lists and machine files, in the order in which they are reported
  std::vector<Failure> failures;   ///< names that cannot be used
  std::vector<Message> notes;  ///< files in folders that are skipped, although they may be lists or machines
  std::string first;           ///< the first name: its settings and its repository are those of the run
  std::vector<std::string> named;  ///< files and folders that the command line or a response file names
  std::vector<std::string>
      sources;  ///< files that may be read: all inputs, the files that machine files name, response files
  std::unordered_map<std::string, FoundInput> found;  ///< those of `paths` that were found in folders
  /// For machines that are checked for the sake of some of their files: the names of these files, as the
  /// machine reads them. All other inputs are shown completely.
  std::unordered_map<std::string, std::vector<std::string>> shown;
};

/// How the names of files are taken.
enum class NamedFiles : std::uint8_t {
  usual,
  /// By a hook that passes all files of a commit: `@x.lis` is a file, and files that a folder would skip are
  /// skipped.
  of_hook,
  literal,  ///< by a program: `@x.lis` is a file
};

/// A folder is replaced by every list and machine file below it, sorted; `@FILE` by the names in it
/// (response_file.hpp). A file that is named twice is checked once, and a list or program that one of the
/// machine files names is checked through it; a machine file is always an input itself. A folder below that
/// cannot be read is a failure of its own.
/// Whether a file named on the command line exists is found out when it is read. Cost: one system call per
/// file, and resolving links once per folder.
/// In folders, only files that `wanted` accepts are considered.
[[nodiscard]] Inputs expand_inputs(
    std::vector<std::string> const& words,
    std::function<bool(std::string const& path)> const& wanted = [](std::string const&) { return true; },
    NamedFiles named_files = NamedFiles::usual);

/// The input itself; for a folder the only machine in it: a machine file, or a start-up list of which no
/// machine file names a list. Failure where there is none, or more than one.
[[nodiscard]] std::string machine_input(std::string const& name);

}  // namespace axisc
