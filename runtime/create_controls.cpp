#include "runtime/building.hpp"

namespace axisc::runtime {
namespace {

/// Controls stand in ascending order of their axes.
uint32_t index_of_source(ImageView const& view, uint32_t index) {
  uint32_t const source = view.controls[index][field::control::source];
  if (source == view.controls[index][field::control::axis]) return index;
  uint32_t master = 0;
  while (view.controls[master][field::control::axis] != source) ++master;
  return master;
}

}  // namespace

void build_controls(ImageView const& view, Layout const& layout, Memory memory) {
  auto const* const filters = memory.part<Filter>(layout.filters);
  auto* const stages = memory.part<Stage>(layout.stages);
  auto* const stage_states = memory.part<ChainState>(layout.stage_states);
  auto* const controls = memory.part<Control>(layout.controls);
  auto* const additive_velocities = memory.part<double>(layout.additive_velocities);
  for (uint32_t i = 0; i < view.stages.count; ++i) {
    Record<record::stage> const record = view.stages[i];
    stages[i] = {.chain = {.filters = filters + record[field::stage::first_filter],
                           .before = nullptr,
                           .behind = nullptr,
                           .filter_count = record[field::stage::filter_count],
                           .reserved = 0},
                 .mode = record[field::stage::mode],
                 .reserved = 0,
                 .weight = record[field::stage::weight]};
    stage_states[i] = ChainState{};
  }
  for (uint32_t i = 0; i < view.controls.count; ++i) {
    Record<record::control> const record = view.controls[i];
    uint32_t const stage_count = record[field::control::stage_count];
    uint32_t const first_stage = stage_count > 0 ? record[field::control::first_stage] : 0;
    controls[i] = {.stages = stages + first_stage,
                   .stage_states = stage_states + first_stage,
                   .stage_count = stage_count,
                   .axis = record[field::control::axis],
                   .source = index_of_source(view, i),
                   .reserved = 0,
                   .limit = magnitude(record[field::control::limit]),  // -0 too is a limit
                   .scale = record[field::control::scale]};
    additive_velocities[i] = 0;
  }
}

}  // namespace axisc::runtime
