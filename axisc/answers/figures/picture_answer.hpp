// A picture of a machine: the figure that a kind and its options describe.
#pragma once

#include "axisc/answers/contour/contour_groups.hpp"
#include "axisc/answers/execution/recorded_scale.hpp"
#include "axisc/answers/figures/plots.hpp"
#include "axisc/checking/machine_input.hpp"
#include "axisc/files/recorded_columns.hpp"
#include "presentation/pictures/figure.hpp"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc {

enum class PictureKind : std::uint8_t {
  response,
  step,
  delay,
  corner,
  circle,
  dynamics,
  robustness,
  path,
  plant,
  compare
};

/// With their words.
inline std::initializer_list<std::pair<std::string_view, PictureKind>> const picture_kinds = {
    {"response", PictureKind::response},     {"step", PictureKind::step},
    {"delay", PictureKind::delay},           {"corner", PictureKind::corner},
    {"circle", PictureKind::circle},         {"dynamics", PictureKind::dynamics},
    {"robustness", PictureKind::robustness}, {"path", PictureKind::path},
    {"plant", PictureKind::plant},           {"compare", PictureKind::compare}};
[[nodiscard]] std::string_view word_of(PictureKind kind);

struct PictureQuestion {
  std::string input;
  PictureKind kind = PictureKind::response;
  bool alone = false;
  std::optional<std::string> before;  ///< an earlier state: all but path, plant, compare
  std::optional<std::string> axis;    ///< none: all, or that of the list
  std::optional<std::string> group;   ///< corner, circle, path; none: the first, or that of the list
  std::vector<std::string> commands;  ///< CYCLE:COMMAND
  std::vector<std::string> marks;     ///< response: "48", "48Hz"
  ResponsePlot response;
  std::optional<std::string> measured;        ///< response: a file
  ContourRequest contour;                     ///< corner, circle
  WantedMove move_at_feed;                    ///< dynamics
  std::optional<std::string> program;         ///< path: a file
  std::optional<std::string> plane;           ///< path: "XY" or "X,Y"
  std::optional<double> tolerance_mm;         ///< path
  std::optional<std::string> plant, move;     ///< plant: a file, and "AXIS:MM[:MM_PER_MIN]"
  std::optional<std::string> recording = {};  ///< compare: a file
  WantedColumns columns;
  PositionUnits units = {};
  Language language = Language::english;
};

struct Picture {
  pictures::Figure figure;
  std::vector<std::string> files;  ///< that the machines were read from, with those of settings
};

/// None after errors in lists or in the program, which `errors` takes. Failure for options that do not fit
/// the machine, and for files that cannot be read.
[[nodiscard]] std::optional<Picture> picture_answer(Workspace& workspace, PictureQuestion question,
                                                    ErrorSink const& errors);

}  // namespace axisc
