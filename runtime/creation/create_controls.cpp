#include "runtime/creation/building.hpp"
#include "runtime/double_bits.hpp"
#include "runtime/limits.hpp"
#include "runtime/verification/verify_checks.hpp"

namespace axisc::runtime {
namespace {

/// Controls are in ascending order of their axes.
uint32_t index_of_source(ImageView const& view, uint32_t index) {
  uint32_t const source = view.controls[index][field::control::source];
  if (source == view.controls[index][field::control::axis]) return index;
  return find_axis(view.controls, field::control::axis, source);
}

}  // namespace

void build_controls(ImageView const& view, Layout const& layout, Memory memory) {
  auto* const stages = memory.part<Stage>(layout.stages);
  auto* const controls = memory.part<Control>(layout.controls);
  auto* const additive_velocities = memory.part<double>(layout.additive_velocities);
  for (uint32_t i = 0; i < view.controls.count; ++i) {
    Record<record::control> const record = view.controls[i];
    uint32_t const stage_count = record[field::control::stage_count];
    controls[i] = {.first_stage = stage_count > 0 ? record[field::control::first_stage] : 0,
                   .stage_count = stage_count,
                   .axis = record[field::control::axis],
                   .source = index_of_source(view, i),
                   .limit = unless_below(smallest_position, magnitude(record[field::control::limit])),
                   .scale = unless_below(smallest_coefficient, record[field::control::scale])};
    additive_velocities[i] = 0;
    for (uint32_t k = 0; k < stage_count; ++k) {
      uint32_t const stage = controls[i].first_stage + k;
      stages[stage] = {
          .mode = view.stages[stage][field::stage::mode],
          .axis = controls[i].axis,
          .weight = unless_below(smallest_coefficient, view.stages[stage][field::stage::weight])};
    }
  }
}

}  // namespace axisc::runtime
