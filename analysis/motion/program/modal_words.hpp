// The state that the words of a program leave in force for later blocks.
#pragma once

#include "analysis/motion/path_block.hpp"
#include "analysis/motion/point.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace axisc::motion {

inline constexpr double mm_per_inch = 25.4;

enum class MotionKind : std::uint8_t { rapid, line, clockwise, counterclockwise };

struct ModalWords {
  Point position{};  ///< where the path has come to, position units
  MotionKind motion = MotionKind::line;
  bool incremental = false;
  bool inch = false;
  char plane_first = 'X', plane_second = 'Y';
  std::optional<double> feed;  ///< position units per minute, or per revolution
  bool feed_per_revolution = false;
  std::optional<double> speed;                    ///< revolutions per minute
  std::shared_ptr<BlockDynamics const> dynamics;  ///< null: what the lists say
  std::uint8_t weighted_acceleration = 0;         ///< as P-CHAN-00001 says it
  std::uint8_t weighted_ramp = 0;                 ///< as P-CHAN-00073 says it
  bool stops = false;                             ///< at the end of every block: G360
  bool brakes_late = false;                       ///< G901
  bool rounds_corners = false;                    ///< G261, with sharp corners
  double path_deviation = 1;                      ///< PATH_DEV, mm: by how much corners are rounded at most

  /// Position units in the program's unit of length.
  [[nodiscard]] double length_unit() const { return units_per_mm * (inch ? mm_per_inch : 1); }
};

}  // namespace axisc::motion
