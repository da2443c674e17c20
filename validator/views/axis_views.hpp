// The filters of one axis as its lists configure them, each evaluated once, for the rules and for building
// the machine.
#pragma once

#include "validator/views/filter_designs.hpp"
#include "validator/views/filter_view.hpp"
#include "validator/views/fir_view.hpp"
#include "validator/views/guard_view.hpp"
#include "validator/views/position_control_view.hpp"

#include <vector>

namespace axisc::validator {

/// Not movable, because its parts refer to each other. The EffectiveValues must outlive it.
struct AxisViews {
  std::vector<FilterView> filters;  ///< those that a list touches: see touched_filters()
  FilterDesigns designs;            ///< of `filters`
  FirView fir;
  GuardView guard;
  PositionControlView position_control;

  AxisViews(EffectiveValues const& values, design::CycleTime cycle_time)
      : filters(touched_filters(values)),
        designs(filters, cycle_time),
        fir(values),
        guard(values),
        position_control(values) {}
  AxisViews(AxisViews const&) = delete;
  AxisViews(AxisViews&&) = delete;
  AxisViews& operator=(AxisViews const&) = delete;
  AxisViews& operator=(AxisViews&&) = delete;
  ~AxisViews() = default;
};

}  // namespace axisc::validator
