// What delays cost on the path. Times in s, Kv in 1/s, feeds, accelerations and deviations in one unit of
// length.
#pragma once

namespace axisc::design {

/// The largest deviation of a straight line or a circle between two axes whose delays differ by ΔP:  F ΔP/2,
/// reached at 45°.
[[nodiscard]] constexpr double deviation_of_mismatch(double feed, double mismatch) {
  return feed * mismatch / 2;
}

/// How far an axis is ahead while it accelerates and its velocity leads by L:  a L/Kv.
[[nodiscard]] constexpr double deviation_of_lead(double acceleration, double lead, double gain) {
  return acceleration * lead / gain;
}

/// What a position controller lags behind at constant velocity, w the weight of velocity feedforward:
/// (1 - w)/Kv.
[[nodiscard]] constexpr double position_lag(double weight, double gain) {
  return (1 - weight) / gain;
}

}  // namespace axisc::design
