#include "axisrt.h"
#include "runtime/change.hpp"
#include "runtime/control_word.hpp"
#include "runtime/double_bits.hpp"
#include "runtime/format/image_format.h"
#include "runtime/lane.hpp"
#include "runtime/recorder.hpp"

namespace axisc::runtime {
namespace {

static_assert(AXISRT_KEYWORD_ORDER == axim_keyword_order && AXISRT_KEYWORD_SHARE == axim_keyword_share &&
              AXISRT_KEYWORD_FCUT == axim_keyword_fcut && AXISRT_KEYWORD_QUALITY == axim_keyword_quality &&
              AXISRT_KEYWORD_HSC == axim_keyword_hsc && AXISRT_KEYWORD_GUARD == axim_keyword_guard);

bool has(uint32_t keywords, uint32_t keyword) {
  return (keywords & keyword) != 0;
}

bool is_meant(Bank const& bank, axisrt_filter_command const& command) {
  uint32_t const keywords = command.keywords;
  return bank.keywords == keywords && (!has(keywords, axim_keyword_order) || bank.order == command.order) &&
         (!has(keywords, axim_keyword_share) || bank.share == command.share) &&
         (!has(keywords, axim_keyword_fcut) || bank.frequency == command.fcut) &&
         (!has(keywords, axim_keyword_quality) || bank.quality == command.quality);
}

Bank const* find_bank(Channel const& channel, axisrt_filter_command const& command) {
  for (uint32_t i = 0; i < channel.bank_count; ++i) {
    if (is_meant(channel.banks[i], command)) return channel.banks + i;
  }
  return nullptr;
}

/// SET keeps the parameters of earlier commands that it does not name; those of the other command are none.
axisrt_filter_command with_earlier(Channel const& channel, axisrt_filter_command command) {
  if (command.action != AXISRT_ACTION_SET || has(command.keywords, axim_keyword_hsc)) return command;
  Bank const& earlier = channel.banks[channel.state->bank];
  if (has(command.keywords ^ earlier.keywords, axim_keyword_guard)) return command;
  if (!has(command.keywords, axim_keyword_order)) command.order = earlier.order;
  if (!has(command.keywords, axim_keyword_share)) command.share = earlier.share;
  if (!has(command.keywords, axim_keyword_fcut)) command.fcut = earlier.frequency;
  if (!has(command.keywords, axim_keyword_quality)) command.quality = earlier.quality;
  command.keywords |= earlier.keywords;
  return command;
}

/// The effect of a command on the slots of a channel.
struct Switching {
  uint32_t action;
  bool guard;        ///< #VIB GUARD
  Bank const* bank;  ///< for SET and ON
  Kernel const* pass;
};

bool reaches(Switching const& change, Slot const& slot) {
  if (change.action == AXISRT_ACTION_PROGRAM_END) return true;
  if (change.guard || slot.family == axim_family_guard) {
    return change.guard && slot.family == axim_family_guard;
  }
  if (change.bank == nullptr) return true;
  bool const hsc = has(change.bank->keywords, axim_keyword_hsc);
  return slot.family == (hsc ? axim_family_hsc : axim_family_fir);
}

struct Target {
  Kernel const* kernel;
  uint32_t on;
};

Target target_of(Switching const& change, Slot const& slot, uint32_t member) {
  uint32_t const on_before = slot.state->on;
  switch (change.action) {
    case AXISRT_ACTION_OFF: return {.kernel = change.pass, .on = 0};
    case AXISRT_ACTION_PROGRAM_END:
      return {.kernel = slot.on_at_start != 0 ? slot.listed : change.pass, .on = slot.on_at_start};
    case AXISRT_ACTION_ON: return {.kernel = change.bank->choices[member], .on = 1};
    default: return {.kernel = on_before != 0 ? change.bank->choices[member] : change.pass, .on = on_before};
  }
}

/// Calls `visit(slot, target)` for every slot of the channel that the command reaches.
template <class Visit>
void for_each_slot(Channel const& channel, Switching const& change, Visit visit) {
  for (uint32_t member = 0; member < channel.member_count; ++member) {
    Slot const* const slot = channel.members[member];
    if (slot != nullptr && reaches(change, *slot)) visit(*slot, target_of(change, *slot, member));
  }
}

/// 0 where only standstill allows it.
uint32_t fade_cycles(Channel const& channel, Switching const& change) {
  switch (change.action) {
    case AXISRT_ACTION_OFF: return channel.off_fade_cycles;
    case AXISRT_ACTION_PROGRAM_END: {
      uint32_t const on = channel.banks[0].fade_cycles;
      uint32_t const off = channel.off_fade_cycles;
      if (on == 0 || off == 0) return 0;
      return on > off ? on : off;
    }
    default: return change.bank->fade_cycles;
  }
}

void remember(Channel const& channel, Switching const& change) {
  if (change.action == AXISRT_ACTION_PROGRAM_END) channel.state->bank = 0;
  if (change.bank == nullptr || has(change.bank->keywords, axim_keyword_hsc)) return;
  channel.state->bank = static_cast<uint32_t>(change.bank - channel.banks);
}

axisrt_status apply(Channel const& channel, Switching const& change) {
  bool busy = false;
  bool changes = false;
  bool rests = true;
  for (uint32_t member = 0; member < channel.member_count; ++member) {
    Slot const* const slot = channel.members[member];
    if (slot == nullptr) continue;
    busy = busy || is_fading(*slot);
    rests = rests && is_at_rest(*slot);
  }
  if (busy) return AXISRT_BUSY;
  for_each_slot(channel, change, [&](Slot const& slot, Target target) {
    changes = changes || slot.group->kernel[slot.lane] != target.kernel;
  });
  // All slots of the channel change over the same cycles, so that its axes stay together.
  uint32_t const fade = fade_cycles(channel, change);
  if (changes && !rests && fade == 0) return AXISRT_NEEDS_STANDSTILL;
  for_each_slot(channel, change, [&](Slot const& slot, Target target) {
    if (slot.group->kernel[slot.lane] != target.kernel) switch_slot(slot, target.kernel, rests ? 0 : fade);
    slot.state->on = target.on;
  });
  remember(channel, change);
  return AXISRT_OK;
}

axisrt_status execute(axisrt const& runtime, uint32_t group, axisrt_filter_command const& command) {
  if (changes_from(runtime) != nullptr) return AXISRT_BUSY;
  Switching change{.action = command.action,
                   .guard = has(command.keywords, axim_keyword_guard),
                   .bank = nullptr,
                   .pass = runtime.kernels + runtime.kernel_count};
  if (command.action == AXISRT_ACTION_ON || command.action == AXISRT_ACTION_SET) {
    Channel const& channel = runtime.channels[group];
    change.bank = find_bank(channel, with_earlier(channel, command));
    if (change.bank == nullptr) return AXISRT_NO_BANK;
  }
  return apply(runtime.channels[group], change);
}

void record(axisrt const& runtime, uint32_t group, axisrt_filter_command const& command,
            axisrt_status status) {
  double const values[axrd_command_words] = {
      std::bit_cast<double>(command.action | uint64_t{command.keywords} << 32U),
      std::bit_cast<double>(uint64_t{command.order}), command.share, command.fcut, command.quality};
  record_call(runtime,
              {.kind = axrd_command, .flags = 0, .status = static_cast<uint32_t>(status), .index = group},
              values, axrd_command_words);
}

}  // namespace
}  // namespace axisc::runtime

axisrt_status axisrt_command(axisrt* runtime, uint32_t group, axisrt_filter_command const* command) {
  using namespace axisc::runtime;
  if (runtime == nullptr || command == nullptr || command->size != sizeof(axisrt_filter_command)) {
    return AXISRT_BAD_ARGUMENT;
  }
  if (group >= runtime->channel_count || command->action > AXISRT_ACTION_PROGRAM_END) {
    return AXISRT_BAD_ARGUMENT;
  }
  axisrt_status const status = in_plain_arithmetic([&] { return execute(*runtime, group, *command); });
  record(*runtime, group, *command, status);
  return status;
}

uint32_t axisrt_order_of_time(axisrt const* runtime, double time_us) {
  using namespace axisc::runtime;
  if (runtime == nullptr || !is_finite(time_us)) return 0;
  return in_plain_arithmetic([&]() -> uint32_t {
    double const volatile time = time_us;  // a function without effects might be called too early
    double const cycles = time * 1000 / runtime->cycle_time_ns;
    constexpr double longest = 1e6;
    if (!(cycles >= 1)) return 0;
    double const half_up = (cycles < longest ? cycles : longest) + 0.5;
    return static_cast<uint32_t>(half_up);
  });
}
