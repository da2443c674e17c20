#include "codegen/velocity_scaling.hpp"

#include <algorithm>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace axisc::codegen {
namespace {

namespace mp = boost::multiprecision;
using Exact = mp::number<mp::cpp_bin_float<50>, mp::et_off>;

constexpr double largest_weight = 7;

/// Seconds of the time base, as a quotient.
Exact time_base(machine::DriveScaling const& scaling, design::CycleTime cycle_time) {
  constexpr int seconds_per_minute = 60;
  constexpr int nanoseconds_per_second = 1'000'000'000;
  switch (scaling.time_base) {
    case 0: return {seconds_per_minute};
    case 1: return {1};
    default: return Exact(cycle_time.nanoseconds) / nanoseconds_per_second;
  }
}

}  // namespace

double stage_weight(machine::PositionControlStage const& stage) {
  return std::min(stage.weight_numerator / stage.weight_denominator, largest_weight);
}

double velocity_limit(machine::PositionControl const& control, double v_max) {
  return control.limit_factor * v_max / 1000;
}

double increments_per_velocity(machine::DriveScaling const& scaling, design::CycleTime cycle_time) {
  switch (scaling.controller) {
    case machine::PositionController::drive:
      return static_cast<double>(
          Exact(Exact(scaling.v_reso_num) / Exact(scaling.v_reso_denom) * time_base(scaling, cycle_time)));
    case machine::PositionController::cnc:
      return static_cast<double>(
          Exact(Exact(6) * Exact(scaling.multi_gain_z) / (Exact(scaling.multi_gain_n) * 100'000)));
    case machine::PositionController::unknown: break;
  }
  return 0;
}

}  // namespace axisc::codegen
