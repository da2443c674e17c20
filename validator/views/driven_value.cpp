#include "validator/views/driven_value.hpp"

#include <algorithm>
#include <array>

namespace axisc::validator {
namespace {

using machine::AxisDynamics;

/// A parameter of gear 0 with the value that counts, what caps it, and the acceleration that a ramp time
/// belongs to.
struct DrivenParameter {
  std::string_view pattern;
  double (*counts)(AxisDynamics const&);
  std::string_view cap;
  double (*acceleration)(AxisDynamics const&) = nullptr;
};

constexpr std::string_view of_a_max = "P-AXIS-00008";
constexpr std::string_view of_tr_min = "P-AXIS-00201";
constexpr std::string_view of_vb_max = "P-AXIS-00212";

double up(AxisDynamics const& axis) {
  return axis.feed.up.acceleration;
}
double down(AxisDynamics const& axis) {
  return axis.feed.down.acceleration;
}
double rapid(AxisDynamics const& axis) {
  return axis.rapid.up.acceleration;
}
double weaker(AxisDynamics const& axis) {
  return std::min(up(axis), down(axis));
}

constexpr std::array parameters = {
    DrivenParameter{"getriebe[].vb_eilgang", [](AxisDynamics const& d) { return d.rapid.velocity; },
                    of_vb_max},
    DrivenParameter{"getriebe[].lslope_profil.a_stufe_1",
                    [](AxisDynamics const& d) { return d.feed.step_up.first; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.a_stufe_2",
                    [](AxisDynamics const& d) { return d.feed.step_up.second; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.d_stufe_1",
                    [](AxisDynamics const& d) { return d.feed.step_down.first; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.d_stufe_2",
                    [](AxisDynamics const& d) { return d.feed.step_down.second; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.a_grenz_stufe_1",
                    [](AxisDynamics const& d) { return d.rapid.step_up.first; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.a_grenz_stufe_2",
                    [](AxisDynamics const& d) { return d.rapid.step_up.second; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.d_grenz_stufe_1",
                    [](AxisDynamics const& d) { return d.rapid.step_down.first; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.d_grenz_stufe_2",
                    [](AxisDynamics const& d) { return d.rapid.step_down.second; }, of_a_max},
    DrivenParameter{"getriebe[].slope_profil.a_beschl", up, of_a_max},
    DrivenParameter{"getriebe[].slope_profil.a_brems", down, of_a_max},
    DrivenParameter{"getriebe[].slope_profil.a_grenz", rapid, of_a_max},
    DrivenParameter{"getriebe[].slope_profil.tr_beschl_zu",
                    [](AxisDynamics const& d) { return d.feed.up.build_up; }, of_tr_min, up},
    DrivenParameter{"getriebe[].slope_profil.tr_beschl_ab",
                    [](AxisDynamics const& d) { return d.feed.up.take_back; }, of_tr_min, up},
    DrivenParameter{"getriebe[].slope_profil.tr_brems_zu",
                    [](AxisDynamics const& d) { return d.feed.down.build_up; }, of_tr_min, down},
    DrivenParameter{"getriebe[].slope_profil.tr_brems_ab",
                    [](AxisDynamics const& d) { return d.feed.down.take_back; }, of_tr_min, down},
    DrivenParameter{"getriebe[].slope_profil.tr_grenz",
                    [](AxisDynamics const& d) { return d.rapid.up.build_up; }, of_tr_min, rapid},
    DrivenParameter{"getriebe[].dynamik.tr_geom", [](AxisDynamics const& d) { return d.curve_ramp_time; },
                    of_tr_min, weaker},
    DrivenParameter{"getriebe[].dynamik.tr_w_min",
                    [](AxisDynamics const& d) { return d.shortest_weighted_ramp_time; }, of_tr_min},
    DrivenParameter{"getriebe[].dynamik.a_w_max",
                    [](AxisDynamics const& d) { return d.weighted_acceleration.value_or(0); }, of_a_max}};

}  // namespace

std::optional<DrivenValue> driven_value(AxisDynamics const& dynamics, std::string_view pattern) {
  auto const* const known =
      std::find_if(parameters.begin(), parameters.end(),
                   [pattern](DrivenParameter const& parameter) { return parameter.pattern == pattern; });
  if (known == parameters.end()) return std::nullopt;
  DrivenValue value{.counts = known->counts(dynamics), .cap = known->cap};
  constexpr double seconds_per_us = 1e-6;
  if (known->acceleration != nullptr && value.counts > 0) {
    value.jerk = known->acceleration(dynamics) / (value.counts * seconds_per_us);
  }
  return value;
}

}  // namespace axisc::validator
