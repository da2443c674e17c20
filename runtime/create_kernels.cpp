#include "runtime/building.hpp"

namespace axisc::runtime {
namespace {

/// Kernel of an index in the image; the one that lets the signal pass for AXIM_NONE.
Kernel const* kernel_at(ImageView const& view, Kernel const* kernels, uint32_t index) {
  return kernels + (index == AXIM_NONE ? view.kernels.count : index);
}

}  // namespace

void build_kernels(ImageView const& view, Layout const& layout, Memory memory) {
  auto* const tails = memory.part<double>(layout.tails);
  for (uint32_t i = 0; i < view.tails.count; ++i) tails[i] = view.tails[i][field::tail::value];
  auto* const kernels = memory.part<Kernel>(layout.kernels);
  for (uint32_t i = 0; i < view.kernels.count; ++i) {
    Record<record::kernel> const record = view.kernels[i];
    kernels[i] = {.tails = tails + record[field::kernel::first_tail],
                  .tail_count = record[field::kernel::tail_count],
                  .reserved = 0};
  }
  kernels[view.kernels.count] = {.tails = tails, .tail_count = 0, .reserved = 0};
}

void build_slots(ImageView const& view, Layout const& layout, Memory memory) {
  auto const* const kernels = memory.part<Kernel>(layout.kernels);
  auto* const slots = memory.part<Slot>(layout.slots);
  auto* const states = memory.part<SlotState>(layout.slot_states);
  auto* const chains = memory.part<Chain>(layout.setpoint_chains);
  auto* history = memory.part<double>(layout.history);
  for (uint32_t i = 0; i < view.slots.count; ++i) {
    Record<record::slot> const record = view.slots[i];
    slots[i] = {.state = states + i,
                .history = history,
                .history_length = static_cast<uint32_t>(history_length(record)),
                .family = record[field::slot::family],
                .listed = kernel_at(view, kernels, record[field::slot::kernel]),
                .on_at_start = record[field::slot::on_at_start],
                .reserved = 0};
    history += size_t{2} * slots[i].history_length;
    states[i] = SlotState{};
    states[i].to = slots[i].on_at_start != 0 ? slots[i].listed : kernel_at(view, kernels, AXIM_NONE);
    states[i].on = slots[i].on_at_start;
    reset_slot(slots[i]);
    Chain& chain = chains[record[field::slot::axis]];
    (slots[i].family == axim_family_hsc ? chain.before : chain.behind) = slots + i;
  }
}

void build_groups(ImageView const& view, Layout const& layout, Memory memory) {
  auto const* const kernels = memory.part<Kernel>(layout.kernels);
  auto const* const slots = memory.part<Slot>(layout.slots);
  auto* const members = memory.part<Slot const*>(layout.members);
  auto* const banks = memory.part<Bank>(layout.banks);
  auto* const choices = memory.part<Kernel const*>(layout.choices);
  auto* const groups = memory.part<Group>(layout.groups);
  for (uint32_t i = 0; i < view.members.count; ++i) members[i] = nullptr;
  for (uint32_t i = 0; i < view.slots.count; ++i) {
    uint32_t const member = view.slots[i][field::slot::member];
    if (member != AXIM_NONE) members[member] = slots + i;
  }
  for (uint32_t i = 0; i < view.choices.count; ++i) {
    choices[i] = kernel_at(view, kernels, view.choices[i][field::choice::kernel]);
  }
  for (uint32_t i = 0; i < view.banks.count; ++i) {
    Record<record::bank> const record = view.banks[i];
    banks[i] = {.keywords = record[field::bank::keywords],
                .order = record[field::bank::order],
                .share = record[field::bank::share],
                .frequency = record[field::bank::frequency],
                .quality = record[field::bank::quality],
                .choices = choices + record[field::bank::first_choice],
                .fade_cycles = record[field::bank::fade_cycles],
                .reserved = 0};
  }
  for (uint32_t i = 0; i < view.groups.count; ++i) {
    Record<record::group> const record = view.groups[i];
    groups[i] = {.members = members + record[field::group::first_member],
                 .banks = banks + record[field::group::first_bank],
                 .member_count = record[field::group::member_count],
                 .bank_count = record[field::group::bank_count],
                 .name_offset = record[field::group::name_offset],
                 .name_size = record[field::group::name_size],
                 .off_fade_cycles = record[field::group::off_fade_cycles],
                 .reserved = 0};
  }
}

}  // namespace axisc::runtime
