// Windows of recordings in which an axis moves one way: means of its motion in them.
#pragma once

#include "analysis/tuning/rigid_model/window.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace axisc::tuning {

/// Samples of one recording.
struct MotionRecord {
  std::vector<double> position;  ///< m or rad
  std::vector<double> force;     ///< N, Nm, or what the drive shows; as many as positions
};

/// Where an axis moves forwards (1) or backwards (-1), and where it does not move or may turn back (0).
class Directions {
 public:
  Directions(std::span<MotionRecord const> records, double T);

  /// 1 or -1 if all samples of the window have it, else 0.
  [[nodiscard]] int of(std::size_t record, std::size_t first, std::size_t count) const;
  /// Samples that move forwards, or backwards, of all recordings.
  [[nodiscard]] std::size_t forwards() const { return forwards_; }
  [[nodiscard]] std::size_t backwards() const { return backwards_; }
  /// Standard deviation of a moving axis' position, from its fourth differences; 0 where nothing moves.
  [[nodiscard]] double noise() const { return noise_; }

 private:
  /// Samples up to each one that move forwards, and backwards.
  struct Counts {
    std::vector<std::uint32_t> forwards, backwards;
  };
  std::vector<Counts> counts_;
  std::size_t forwards_ = 0, backwards_ = 0;
  double noise_ = 0;
};

/// Means over one window.
struct WindowMotion {
  std::size_t record = 0, first = 0;
  double velocity = 0, acceleration = 0;
  double fourth = 0;  ///< derivative of the position
  int direction = 0;
};

/// Windows in which the axis moves one way, and whose force lies within the recording for every dead time.
[[nodiscard]] std::vector<WindowMotion> motion_windows(std::span<MotionRecord const> records,
                                                       Directions const& directions, Window const& window);

/// Mean of the force, `dead_time` samples later than the motion.
[[nodiscard]] double window_force(MotionRecord const& record, std::size_t first, int dead_time,
                                  Window const& window);

/// Σ w², times the variance of noise of `noise`, as a share of the variance of what the weights measure in
/// the recordings; 1 where nothing varies.
[[nodiscard]] double noise_share(std::span<MotionRecord const> records, std::span<double const> weights,
                                 double noise);

}  // namespace axisc::tuning
