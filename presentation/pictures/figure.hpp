// The content of a picture: panels with axes, curves and marks, as plain data. The caller computes the
// numbers; svg.hpp draws them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc::pictures {

enum class Scale : std::uint8_t { linear, logarithmic };

/// Significant digits of numbers in words and tables.
inline constexpr int shown_digits = 4;

/// A quantity along an edge of a panel.
struct Axis {
  std::string quantity = {};  ///< "frequency"
  std::string unit = {};      ///< "Hz"; empty for numbers without one
  Scale scale = Scale::linear;
  double low = 0;  ///< the range of the panel: low < high, above 0 on a logarithmic scale
  double high = 1;
  /// Places of the labels; empty: round numbers.
  std::vector<double> ticks = {};
  std::vector<std::string> names = {};  ///< instead of the numbers of `ticks`, as many
};

struct Point {
  double x = 0;
  double y = 0;  ///< not a number: the curve is interrupted here
};

enum class Role : std::uint8_t {
  whole,     ///< the subject of the picture: bold
  part,      ///< a contribution to it: thin
  before,    ///< an earlier state: thin and dashed
  measured,  ///< from a file: dots
  guide,     ///< for comparison: thin and grey
  bar,       ///< a thick line between its points
};

struct Curve {
  std::string name = {};
  Role role = Role::whole;
  std::size_t colour = 0;  ///< index in the palette; curves of one name in several panels have one colour
  std::vector<Point> points = {};
};

/// A vertical line across all panels.
struct Mark {
  double at = 0;
  std::string label;
};

/// Words at a place of a panel.
struct Label {
  Point at;
  std::string words;
};

inline constexpr double usual_panel_height = 190;

struct Panel {
  Axis y = {};
  std::vector<Curve> curves = {};
  std::vector<Label> labels = {};
  double height = usual_panel_height;  ///< in pixels
  bool is_bare = false;                ///< without frame, grid and numbers
  std::optional<Axis> x = {};          ///< its own horizontal axis, without the figure's marks
};

/// The figures in numbers, for copying.
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// Panels one above the other that share their horizontal axis, as far as they have none of their own.
struct Figure {
  std::string title = {};
  std::string description = {};  ///< the figures in words: alternative text
  Axis x = {};
  std::vector<Panel> panels = {};
  std::vector<Mark> marks = {};
  Table table = {};
  bool shows_table = false;  ///< the picture has it below its legend
  std::string nothing = {};  ///< why there is nothing to draw; then there are no panels
};

}  // namespace axisc::pictures
