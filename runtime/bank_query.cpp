#include "axisrt.h"
#include "runtime/change.hpp"
#include "runtime/lane.hpp"
#include "runtime/runtime_object.hpp"

uint32_t axisrt_busy_cycles(axisrt const* runtime, uint32_t group) {
  using namespace axisc::runtime;
  if (runtime == nullptr || group >= runtime->channel_count) return 0;
  if (changes_from(*runtime) != nullptr) return runtime->change->length - runtime->change->position;
  Channel const& channel = runtime->channels[group];
  uint32_t most = 0;
  for (uint32_t member = 0; member < channel.member_count; ++member) {
    Slot const* const slot = channel.members[member];
    if (slot == nullptr || !is_fading(*slot)) continue;
    uint32_t const left = slot->group->fade_length[slot->lane] - slot->group->fade_position[slot->lane];
    most = left > most ? left : most;
  }
  return most;
}

uint32_t axisrt_bank_count(axisrt const* runtime, uint32_t group) {
  return runtime == nullptr || group >= runtime->channel_count ? 0 : runtime->channels[group].bank_count;
}

axisrt_status axisrt_get_bank(axisrt const* runtime, uint32_t group, uint32_t bank,
                              axisrt_filter_command* command) {
  if (command == nullptr || command->size != sizeof(axisrt_filter_command)) return AXISRT_BAD_ARGUMENT;
  if (bank >= axisrt_bank_count(runtime, group)) return AXISRT_BAD_ARGUMENT;
  axisc::runtime::Bank const& found = runtime->channels[group].banks[bank];
  command->action = AXISRT_ACTION_ON;
  command->keywords = found.keywords;
  command->order = found.order;
  command->share = found.share;
  command->fcut = found.frequency;
  command->quality = found.quality;
  return AXISRT_OK;
}
