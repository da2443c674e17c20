#include "runtime/lane.hpp"

#include "runtime/limits.hpp"
#include "runtime/twofold.hpp"

namespace axisc::runtime {
namespace {

/// base' = (1 - s) base, sum' = s e + (1 - s) sum, without losing the product's rounding error.
Value join_blocking(Lane const& lane, Filter const& filter, Value const& in, double e) {
  double const share = lane.share(filter, 0);
  double const direct = lane.share(filter, 1);
  Twofold const base = exact_product(direct, in.base);
  double const low = base.low + lane.share(filter, 2) * in.base;
  return {.base = on_grid(base.high, grid), .sum = on_grid(share * e + (direct * in.sum + low), grid)};
}

Value join_delay(Lane const& lane, Filter const& filter, Value const& in, Value const& delayed) {
  double const distance = (in.base - delayed.base) + in.sum;
  return {.base = delayed.base,
          .sum = on_grid(lane.share(filter, 0) * delayed.sum + lane.share(filter, 1) * distance, grid)};
}

Value join_shared(Lane const& lane, Filter const& filter, Value const& in, double sum) {
  return {.base = in.base,
          .sum = on_grid(lane.share(filter, 0) * sum + lane.share(filter, 1) * in.sum, grid)};
}

ptrdiff_t tails_of(SlotGroup const& group) {
  return static_cast<ptrdiff_t>(group.block_count) * static_cast<ptrdiff_t>(block_cycles);
}

/// Puts a kernel's tails into a lane of `zero`.
void write_tails(double* zero, SlotGroup const& group, ptrdiff_t lane, ptrdiff_t width,
                 Kernel const& kernel) {
  auto const tails = static_cast<ptrdiff_t>(kernel.tail_count);
  for (ptrdiff_t j = 0; j < tails_of(group); ++j) zero[lane - j * width] = j < tails ? kernel.zero[-j] : 0;
}

void copy_tails_to_before(Slot const& slot) {
  auto const width = static_cast<ptrdiff_t>(slot.width);
  for (ptrdiff_t j = 0; j < tails_of(*slot.group); ++j) {
    ptrdiff_t const at = slot.lane - j * width;
    slot.group->from[at] = slot.group->to[at];
  }
}

void end_fade(Slot const& slot) {
  SlotGroup& group = *slot.group;
  if (is_fading(slot)) group.fading -= 1;
  group.before[slot.lane] = group.kernel[slot.lane];
  group.fade_position[slot.lane] = group.fade_length[slot.lane];
}

}  // namespace

bool is_at_rest(Slot const& slot) {
  SlotGroup const& group = *slot.group;
  uint32_t const length = group.block_count * block_cycles;
  uint32_t const next = group.block * block_cycles + group.phase;
  for (uint32_t age = 1; age <= slot.history_length; ++age) {
    uint32_t const place = next >= age ? next - age : next + length - age;
    if (!is_within(slot_part(slot, SlotParts::history + place), largest_increment_at_rest)) return false;
  }
  return true;
}

void reset_slot(Slot const& slot) {
  end_fade(slot);
  uint32_t const end = SlotParts::history + slot.group->block_count * block_cycles;
  for (uint32_t i = 0; i < end; ++i) slot_part(slot, i) = 0;
}

void write_tails_of_lane(SlotGroup& group, uint32_t lane, uint32_t width) {
  write_tails(group.to, group, lane, width, *group.kernel[lane]);
  write_tails(group.from, group, lane, width, *group.before[lane]);
}

void switch_slot(Slot const& slot, Kernel const* kernel, uint32_t fade_cycles) {
  SlotGroup& group = *slot.group;
  copy_tails_to_before(slot);
  write_tails(group.to, group, slot.lane, slot.width, *kernel);
  group.before[slot.lane] = fade_cycles > 0 ? group.kernel[slot.lane] : kernel;
  group.kernel[slot.lane] = kernel;
  group.fade_length[slot.lane] = fade_cycles;
  group.fade_position[slot.lane] = 0;
  group.fading += fade_cycles > 0 ? 1 : 0;
  group.mode = SlotMode::direct;
  group.gathers = 0;
  group.common = nullptr;
}

void start_at_rest(SlotGroup& group, uint32_t width) {
  group.block = 0;
  group.phase = 0;
  group.ramp_phase = 0;
  group.next_ahead = 0;
  group.common = group.kernel[0];
  for (uint32_t lane = 1; lane < group.used; ++lane) {
    if (group.kernel[lane] != group.kernel[0]) group.common = nullptr;
  }
  bool const ramp = group.common != nullptr && group.common->ramp != 0;
  group.gathers = !ramp && width > widest_by_one ? 1 : 0;
  group.mode = ramp ? SlotMode::ramp : group.gathers != 0 ? SlotMode::blocked : SlotMode::direct;
}

Value steady_output(Lane const& lane, Filter const& filter, Value const& in) {
  switch (filter.kind) {
    case FilterKind::shared: return join_shared(lane, filter, in, in.sum);
    case FilterKind::blocking: return join_blocking(lane, filter, in, 0);
    case FilterKind::delay: return join_delay(lane, filter, in, in);
    default: return in;
  }
}

Value latest_output(Lane const& lane, Filter const& filter, Value const& in) {
  double sum = in.sum;
  switch (filter.kind) {
    case FilterKind::passing:
    case FilterKind::shared:
      for (uint32_t i = 0; i < filter.section_count; ++i) sum += lane.e(filter, i);
      if (filter.kind == FilterKind::shared) return join_shared(lane, filter, in, sum);
      return {.base = in.base, .sum = sum};
    case FilterKind::blocking:
      return join_blocking(lane, filter, in, lane.e(filter, filter.section_count - 1));
    case FilterKind::delay: {
      // The output is where the next input goes.
      uint32_t const place = 3 * lane.operation(filter).state->position;
      return join_delay(lane, filter, in,
                        {.base = lane.state(filter, place), .sum = lane.state(filter, place + 1)});
    }
    case FilterKind::pass_through: break;
  }
  return in;
}

}  // namespace axisc::runtime
