#include "runtime/creation/building.hpp"

namespace axisc::runtime {

void build_channels(ImageView const& view, Layout const& layout, Memory memory) {
  auto const* const kernels = memory.part<Kernel>(layout.kernels);
  auto const* const slots = memory.part<Slot>(layout.slots);
  auto* const members = memory.part<Slot const*>(layout.members);
  auto* const banks = memory.part<Bank>(layout.banks);
  auto* const choices = memory.part<Kernel const*>(layout.choices);
  auto* const channels = memory.part<Channel>(layout.channels);
  auto* const states = memory.part<ChannelState>(layout.channel_states);
  for (uint32_t i = 0; i < view.members.count; ++i) members[i] = nullptr;
  for (uint32_t i = 0; i < view.slots.count; ++i) {
    uint32_t const member = view.slots[i][field::slot::member];
    if (member != AXIM_NONE) members[member] = slots + i;
  }
  for (uint32_t i = 0; i < view.choices.count; ++i) {
    uint32_t const kernel = view.choices[i][field::choice::kernel];
    choices[i] = kernels + (kernel == AXIM_NONE ? view.kernels.count : kernel);
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
    states[i] = {.bank = 0};
    channels[i] = {.members = members + record[field::group::first_member],
                   .banks = banks + record[field::group::first_bank],
                   .state = states + i,
                   .member_count = record[field::group::member_count],
                   .bank_count = record[field::group::bank_count],
                   .name_offset = record[field::group::name_offset],
                   .name_size = record[field::group::name_size],
                   .off_fade_cycles = record[field::group::off_fade_cycles],
                   .reserved = 0};
  }
}

}  // namespace axisc::runtime
