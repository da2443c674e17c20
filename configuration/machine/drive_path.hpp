// What delays an axis between its filters and its drive: its position on one way, the velocity that is fed
// forward on another.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace axisc::machine {

enum class DelayKind : std::uint8_t {
  filter,        ///< filter[i], filter_fir, HSC, Vibration Guard
  interpolator,  ///< the cycles between interpolator and position controller while feedforward is used
  shift,         ///< P-AXIS-00165: feedforward goes out earlier
  quantity,      ///< P-AXIS-00389, 00390, 00547: of one quantity
  balancing,     ///< P-AXIS-00361: of the position
  lag,           ///< of the position controller without full velocity feedforward
  drive,         ///< in the drive itself, as the machine file says
};

/// In NC cycles; 0 on the way that it does not delay.
struct DriveDelay {
  DelayKind kind{};
  std::string parameter = {};  ///< "P-AXIS-00165", of the value that decides; none of the drive's own
  double position = 0;
  double velocity = 0;
};

struct DrivePath {
  std::vector<DriveDelay> delays = {};
  bool feeds_velocity = false;         ///< otherwise nothing is on the second way
  bool delays_position_alone = false;  ///< P-AXIS-00513: a time delay that is the last filter[i]
};

/// What delays the position of an axis after its filters, by how it acts. Where each acts is a reading.
struct PositionDelay {
  double cycles = 0;  ///< whole cycles
  double lag = 0;     ///< time constant of a PT1, in cycles: P-AXIS-00361, and the rest of the drive's delay

  friend bool operator==(PositionDelay const&, PositionDelay const&) = default;
};

/// Without the lag, which arises in the position controller.
[[nodiscard]] PositionDelay position_delay(DrivePath const& path);

}  // namespace axisc::machine
