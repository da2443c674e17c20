// `@FILE` on the command line: a file that names inputs, for more of them than a command line may hold.
#pragma once

#include <string>
#include <vector>

namespace axisc {

struct NamedInput {
  std::string path;
  std::string place =
      {};  ///< "lists.txt:12" for one that a response file names; empty for the command line's own
};

/// The arguments with each `@FILE` replaced by the paths in it, `@-` by those on standard input. One path per
/// line (LF or CRLF, empty lines are left out), in single quotes where it begins and ends with one, as Ninja
/// writes names with blanks; in a file that holds a NUL, one path, taken literally, before each NUL (`find
/// -print0`). Paths are relative to the working folder, wherever the response file is. Failure for a file
/// that cannot be read, is empty, names another response file, or holds a name too long for a path.
[[nodiscard]] std::vector<NamedInput> read_response_files(std::vector<std::string> const& words);

}  // namespace axisc
