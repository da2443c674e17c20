// Options that say which contours are predicted.
#pragma once

#include "axisc/answers/contour/contour_groups.hpp"
#include "cli/options/command_line.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace axisc::cli {

/// --feed, --order, --angle, --radius, --tolerance as given.
struct ContourWords {
  enum class Shown : std::uint8_t {
    all,
    paths,   ///< without --tolerance
    shapes,  ///< nor --order
  };
  std::optional<std::string> feeds, orders, angle, radius, tolerance;
};

/// `words` must outlive the command line's answers.
void declare_contour_words(CommandLine& command_line, ContourWords& words,
                           ContourWords::Shown shown = ContourWords::Shown::all);

/// Failure for a value that none of the options takes.
[[nodiscard]] ContourRequest read_contour_words(ContourWords const& words);

}  // namespace axisc::cli
