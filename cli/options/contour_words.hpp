// Options that say which contours are predicted.
#pragma once

#include "axisc/answers/contour/contour_groups.hpp"
#include "cli/options/command_line.hpp"

#include <optional>
#include <string>

namespace axisc::cli {

/// --feed, --order, --angle, --radius, --tolerance as given.
struct ContourWords {
  std::optional<std::string> feeds, orders, angle, radius, tolerance;
};

// `words` must outlive the command line's answers.
void declare_feeds(CommandLine& command_line, ContourWords& words);
void declare_orders(CommandLine& command_line, ContourWords& words);
void declare_angle(CommandLine& command_line, ContourWords& words);
void declare_radius(CommandLine& command_line, ContourWords& words);
void declare_tolerance(CommandLine& command_line, ContourWords& words);

/// Failure for a value that none of the options takes.
[[nodiscard]] ContourRequest read_contour_words(ContourWords const& words);

}  // namespace axisc::cli
