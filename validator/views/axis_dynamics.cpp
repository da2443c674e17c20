#include "validator/views/axis_dynamics.hpp"

#include <algorithm>
#include <string_view>

namespace axisc::validator {
namespace {

class DynamicsReader {
 public:
  explicit DynamicsReader(EffectiveValues const& values) : values_(values) {}

  [[nodiscard]] machine::AxisDynamics read() const {
    machine::AxisDynamics dynamics;
    dynamics.feed = feed();
    dynamics.rapid = rapid();
    dynamics.curve_ramp_time = ramp_time("getriebe[].dynamik.tr_geom");
    dynamics.highest_acceleration = highest_;
    dynamics.shortest_ramp_time = shortest_;
    if (double const weighted = number("getriebe[].dynamik.a_w_max"); weighted > 0) {
      dynamics.weighted_acceleration = std::min(weighted, highest_);
    }
    dynamics.shortest_weighted_ramp_time = ramp_time("getriebe[].dynamik.tr_w_min");
    dynamics.acceleration_transition_weight = number("getriebe[].dynamik.a_trans_weight");
    dynamics.curvature_transition_weight = number("getriebe[].dynamik.r_trans_weight");
    dynamics.corner_jerk = number("getriebe[].dynamik.j_trans_c0");
    dynamics.curvature_jerk = number("getriebe[].dynamik.j_trans_c1");
    dynamics.exact_stop_window = number("getriebe[].window");
    return dynamics;
  }

 private:
  [[nodiscard]] double number(std::string_view pattern) const { return values_.at(pattern).value.number; }
  [[nodiscard]] double acceleration(std::string_view pattern) const {
    return std::min(number(pattern), highest_);
  }
  [[nodiscard]] double ramp_time(std::string_view pattern) const {
    return std::max(number(pattern), shortest_);
  }

  [[nodiscard]] machine::MotionDynamics feed() const {
    machine::MotionDynamics motion;
    motion.velocity = number("getriebe[].dynamik.vb_max");
    motion.step_up = {.first = acceleration("getriebe[].lslope_profil.a_stufe_1"),
                      .second = acceleration("getriebe[].lslope_profil.a_stufe_2"),
                      .changeover = number("getriebe[].lslope_profil.vb_stufe_1_2")};
    motion.step_down = slowing_down(motion.step_up, "getriebe[].lslope_profil.d_stufe_1",
                                    "getriebe[].lslope_profil.d_stufe_2");
    motion.up = {.acceleration = acceleration("getriebe[].slope_profil.a_beschl"),
                 .build_up = ramp_time("getriebe[].slope_profil.tr_beschl_zu"),
                 .take_back = ramp_time("getriebe[].slope_profil.tr_beschl_ab")};
    motion.down = {.acceleration = acceleration("getriebe[].slope_profil.a_brems"),
                   .build_up = ramp_time("getriebe[].slope_profil.tr_brems_zu"),
                   .take_back = ramp_time("getriebe[].slope_profil.tr_brems_ab")};
    return motion;
  }

  [[nodiscard]] machine::MotionDynamics rapid() const {
    machine::MotionDynamics motion;
    motion.velocity = std::min(number("getriebe[].vb_eilgang"), number("getriebe[].dynamik.vb_max"));
    motion.step_up = {.first = acceleration("getriebe[].lslope_profil.a_grenz_stufe_1"),
                      .second = acceleration("getriebe[].lslope_profil.a_grenz_stufe_2"),
                      .changeover = number("getriebe[].lslope_profil.vb_grenz_stufe_1_2")};
    motion.step_down = slowing_down(motion.step_up, "getriebe[].lslope_profil.d_grenz_stufe_1",
                                    "getriebe[].lslope_profil.d_grenz_stufe_2");
    double const time = ramp_time("getriebe[].slope_profil.tr_grenz");
    motion.up = {
        .acceleration = acceleration("getriebe[].slope_profil.a_grenz"), .build_up = time, .take_back = time};
    motion.down = motion.up;
    return motion;
  }

  [[nodiscard]] machine::AccelerationStages slowing_down(machine::AccelerationStages const& up,
                                                         std::string_view first,
                                                         std::string_view second) const {
    machine::AccelerationStages down = up;
    if (number(first) > 0) down.first = acceleration(first);
    if (number(second) > 0) down.second = acceleration(second);
    return down;
  }

  EffectiveValues const& values_;
  double highest_ = number("getriebe[].dynamik.a_max");
  double shortest_ = number("getriebe[].dynamik.tr_min");
};

}  // namespace

machine::AxisDynamics axis_dynamics(EffectiveValues const& values) {
  return DynamicsReader(values).read();
}

}  // namespace axisc::validator
