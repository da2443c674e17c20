// What a picture shows: panels with axes, curves and marks, as plain data. Who fills it has computed the numbers; svg.hpp
// draws it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace axisc::pictures {

enum class Scale : std::uint8_t { linear, logarithmic };

/// A quantity along an edge of a panel.
struct Axis {
  std::string quantity = {};  ///< "frequency"
  std::string unit = {};      ///< "Hz"; empty for numbers without one
  Scale scale = Scale::linear;
  double low = 0;  ///< what the panel shows: low < high, above 0 on a logarithmic scale
  double high = 1;
  /// Where a label stands; empty: round numbers.
  std::vector<double> ticks = {};
};

struct Point {
  double x = 0;
  double y = 0;  ///< not a number: the curve is interrupted here
};

enum class Role : std::uint8_t {
  whole,     ///< what the picture is about: bold
  part,      ///< a contribution to it: thin
  before,    ///< an earlier state: thin and dashed
  measured,  ///< from a file: dots
};

struct Curve {
  std::string name = {};
  Role role = Role::whole;
  std::size_t colour = 0;  ///< which of the palette; curves of one name in several panels have one colour
  std::vector<Point> points = {};
};

/// A vertical line across all panels.
struct Mark {
  double at = 0;
  std::string label;
};

struct Panel {
  Axis y;
  std::vector<Curve> curves;
};

/// Panels one above the other that share their horizontal axis.
struct Figure {
  std::string title;
  std::string description;  ///< the figures in words, for who does not see the picture
  Axis x;
  std::vector<Panel> panels;
  std::vector<Mark> marks;
  std::string nothing;  ///< says why there is nothing to draw; then there are no panels
};

}  // namespace axisc::pictures
