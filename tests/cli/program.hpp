// Runs the built program as a user would.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::test {

struct Outcome {
  int status = -1;  ///< exit status; -1 when the program did not end by itself
  std::string out;
  std::string err;
  std::size_t peak_memory = 0;  ///< bytes of it that were in main memory at most
};

struct Surroundings {
  std::string folder = ".";
  std::string input;                   ///< bytes on standard input
  std::string out;                     ///< where standard output goes, "/dev/full"; empty: it is captured
  std::vector<std::string> variables;  ///< "LANG=de_DE.UTF-8"; nothing else but PATH is set
  bool closed_pipe = false;            ///< standard output is a pipe that nobody reads
};

[[nodiscard]] Surroundings in_folder(std::string path);

/// An answer in JSON is compared with its schema.
[[nodiscard]] Outcome run_axisc(std::vector<std::string> const& arguments,
                                Surroundings const& surroundings = {});

/// Number of lines, the last one with or without its end.
[[nodiscard]] std::size_t lines_of(std::string_view text);

}  // namespace axisc::test
