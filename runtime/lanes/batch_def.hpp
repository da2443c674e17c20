// A cycle of all groups of a batch: setpoints into lanes, the chain's operations, outputs and statuses back.
#pragma once

#include "axisrt.h"
#include "runtime/lanes/filters_def.hpp"
#include "runtime/lanes/slot_def.hpp"

// Pieces of a group are some thousand doubles: offsets in them fit into 32 bits.
// NOLINTBEGIN(bugprone-implicit-widening-of-multiplication-result)
namespace axisc::runtime::AXISRT_LEVEL {

/// Events of any lane: statuses, joined bit by bit. The worse of two contains the other's bits.
template <uint32_t Width>
using Happened = Bits<Width>;

inline constexpr uint64_t bad_input = AXISRT_BAD_INPUT;
inline constexpr uint64_t not_reset = AXISRT_NOT_RESET;
inline constexpr uint64_t implausible = AXISRT_IMPLAUSIBLE;
static_assert((bad_input | not_reset) == not_reset && bad_input < not_reset);
static_assert((not_reset | implausible) == implausible && not_reset < implausible);

constexpr double beyond_position = 0x1.0000000000001p53;  ///< the next number after the largest position
static_assert(beyond_position > largest_position);

/// Setpoints as they come, and the masks that decide how they are used.
template <uint32_t Width>
struct Entry {
  Real<Width> setpoint;
  Bits<Width> good;
  Bits<Width> done;  ///< ignored where every line was reset
};

template <uint32_t Width, bool AllReset>
AXISRT_INLINE Signal<Width> enter(double* parts, Entry<Width> const& entry) {
  auto const previous = load_real<Width>(parts + GroupParts::input * Width);
  Bits<Width> const taken = AllReset ? entry.good : entry.good & entry.done;
  Bits<Width> const is_zero = mask_if_below<Width>(entry.setpoint, smallest_position);
  Real<Width> const setpoint = select<Width>(taken, keep<Width>(~is_zero, entry.setpoint), previous);
  store<Width>(parts + GroupParts::input * Width, setpoint);
  return {setpoint, Real<Width>{}, setpoint - previous};
}

template <uint32_t Width>
AXISRT_INLINE Signal<Width> run_operation(Operation const& operation, uint32_t group, double const* constants,
                                          double* parts, Signal<Width> const& in) {
  double* const states = parts + operation.first_state * Width;
  switch (operation.kind) {
    case OperationKind::passing: {
      CascadeSignal<Width> const out =
          run_passing<Width>(constants, states, operation.section_count, {in.sum, in.d});
      return {in.base, out.sum, out.d};
    }
    case OperationKind::shared: return run_shared<Width>(operation, constants, states, in);
    case OperationKind::blocking: return run_blocking_filter<Width>(operation, constants, states, in);
    case OperationKind::delay: return run_delay<Width>(operation, constants, states, in);
    case OperationKind::slot: return run_slot<Width>(operation.slots[group], states, in);
  }
  return in;
}

inline constexpr uint32_t cycles_of_a_round = 6;

/// After all groups: the next sixth of a batch's sections is bounded, apart from the groups, so that none has
/// to wait for it.
template <uint32_t Width>
AXISRT_INLINE void bound_some_sections(Batch const& batch, Operation const& operation) {
  OperationState state = *operation.state;
  uint32_t const all_sections = batch.group_count * operation.section_count;
  double* const first = batch.states + static_cast<size_t>(operation.first_state) * Width;
  for (uint32_t done = 0; done < all_sections; done += cycles_of_a_round) {
    bound_section<Width>(first + static_cast<size_t>(state.group) * batch.state_stride +
                         static_cast<size_t>(state.section) * states_of_section * Width);
    state.section += 1;
    if (state.section < operation.section_count) continue;
    state.section = 0;
    state.group = state.group + 1 == batch.group_count ? 0 : state.group + 1;
  }
  *operation.state = state;
}

/// After all groups: moves on to the place of the next cycle.
template <uint32_t Width>
AXISRT_INLINE void advance_operation(Batch const& batch, Operation const& operation) {
  if (operation.section_count > 0) bound_some_sections<Width>(batch, operation);
  if (operation.kind == OperationKind::delay) {
    OperationState& state = *operation.state;
    state.position = state.position == operation.delay_cycles ? 0 : state.position + 1;
  }
}

template <uint32_t Width>
AXISRT_INLINE void write_outputs(Real<Width> outputs, uint32_t const* lines, uint32_t used, bool consecutive,
                                 double* out) {
  if constexpr (Width == 1) {
    out[lines[0]] = lane_of(outputs, 0);
  } else if (consecutive) {
    store<Width>(out + lines[0], outputs);
  } else {
    for (uint32_t lane = 0; lane < used; ++lane) out[lines[lane]] = outputs[lane];
  }
}

template <uint32_t Width>
AXISRT_INLINE void write_statuses(Bits<Width> happened, uint32_t const* lines, uint32_t used,
                                  bool consecutive, uint8_t* status) {
  if constexpr (Width == 1) {
    status[lines[0]] = static_cast<uint8_t>(lane_of(happened, 0));
  } else if (consecutive) {
    auto const octets = AXISRT_CONVERT(happened, typename Lanes<Width>::Octets);
    AXISRT_COPY(status + lines[0], &octets, sizeof octets);
  } else {
    for (uint32_t lane = 0; lane < used; ++lane) status[lines[lane]] = static_cast<uint8_t>(happened[lane]);
  }
}

constexpr uint32_t sections_of(ChainKind kind) {
  switch (kind) {
    case ChainKind::sections_1: return 1;
    case ChainKind::sections_2: return 2;
    case ChainKind::sections_4: return 4;
    case ChainKind::sections_6: return 6;
    default: return 0;
  }
}

/// The arguments of a call.
struct Call {
  double const* in;
  double* out;
  uint8_t* status;  ///< may be null
};

/// A group in its batch.
template <uint32_t Width>
class Place {
 public:
  Place(Batch const& batch, uint32_t group)
      : group_(group),
        parts_(batch.states + static_cast<size_t>(group) * batch.state_stride),
        constants_(batch.constants + static_cast<size_t>(group) * batch.operation_count),
        lines_(batch.lines + static_cast<size_t>(group) * Width),
        used_(group + 1 == batch.group_count ? batch.used_in_last : Width),
        consecutive_(batch.consecutive != 0) {}

  template <bool AllReset>
  [[nodiscard]] AXISRT_INLINE Signal<Width> begin(Call const& call, Happened<Width>& happened) {
    entry_.setpoint = consecutive_ ? load_real<Width>(call.in + lines_[0]) : gather<Width>(call.in, lines_);
    entry_.good = mask_if_below<Width>(entry_.setpoint, beyond_position);
    happened |= ~entry_.good & bad_input;
    if constexpr (AllReset) {
      entry_.done = ~Bits<Width>{};
    } else {
      entry_.done = load_bits<Width>(parts_ + GroupParts::reset_done * Width);
      happened |= ~entry_.done & not_reset;
    }
    return enter<Width, AllReset>(parts_, entry_);
  }

  template <bool AllReset>
  AXISRT_INLINE void end(Call const& call, Signal<Width> const& signal, Happened<Width>& happened) const {
    Real<Width> const output = signal.base + signal.sum;
    Real<Width> const increment = output - load_real<Width>(parts_ + GroupParts::output * Width);
    Bits<Width> const plausible = mask_if_at_most<Width>(
        magnitude<Width>(increment), load_real<Width>(parts_ + GroupParts::largest_increment * Width));
    Bits<Width> const beyond = entry_.done & ~plausible & implausible;
    happened |= beyond;
    store<Width>(parts_ + GroupParts::output * Width, output);
    if constexpr (AllReset) {
      write_outputs<Width>(output, lines_, used_, consecutive_, call.out);
    } else {
      // A line that was never reset repeats its input, 0 for a bad one.
      Real<Width> const repeated = keep<Width>(entry_.good, entry_.setpoint);
      write_outputs<Width>(select<Width>(entry_.done, output, repeated), lines_, used_, consecutive_,
                           call.out);
    }
    if (call.status == nullptr) return;
    Bits<Width> const entered = (entry_.done & ~entry_.good & bad_input) | (~entry_.done & not_reset);
    write_statuses<Width>(entered | beyond, lines_, used_, consecutive_, call.status);
  }

  [[nodiscard]] uint32_t group() const { return group_; }
  [[nodiscard]] double* parts() const { return parts_; }
  [[nodiscard]] double* states() const { return parts_ + GroupParts::operations * Width; }
  [[nodiscard]] double const* constants(uint32_t operation) const { return constants_[operation]; }

 private:
  uint32_t group_;
  double* parts_;
  double const* const* constants_;
  uint32_t const* lines_;
  uint32_t used_;
  bool consecutive_;
  Entry<Width> entry_{};
};

/// Chains of `Sections` sections in `Groups` neighbouring groups at once: one group's sections wait for each
/// other, those of several do not.
template <uint32_t Width, uint32_t Sections, uint32_t Groups, bool AllReset>
AXISRT_INLINE void step_sections(Batch const& batch, uint32_t first, Call const& call,
                                 Happened<Width>& happened) {
  [&]<uint32_t... Member>(Members<Member...>) AXISRT_INLINE_LAMBDA {
    Place<Width> places[] = {Place<Width>(batch, first + Member)...};
    Signal<Width> signals[] = {places[Member].template begin<AllReset>(call, happened)...};
    unrolled<Sections>([&]<uint32_t Section>() AXISRT_INLINE_LAMBDA {
      unrolled<Groups>([&]<uint32_t One>() AXISRT_INLINE_LAMBDA {
        CascadeSignal<Width> const added =
            run_section<Width>(places[One].constants(0) + Section * coefficients_of_section * Width,
                               places[One].states() + Section * states_of_section * Width, signals[One].d);
        signals[One].sum += added.sum;
        signals[One].d += added.d;
        if constexpr ((Section + 1) % sections_between_grids == 0) {
          signals[One].d = on_grid<Width>(signals[One].d);
        }
      });
    });
    unrolled<Groups>([&]<uint32_t One>() AXISRT_INLINE_LAMBDA {
      places[One].template end<AllReset>(call, signals[One], happened);
    });
  }
  (FirstMembers<Groups>{});
}

/// Half of the lanes, in registers.
template <uint32_t First, uint32_t Width, uint32_t... Member>
AXISRT_INLINE Happened<Width / 2> half_of(Happened<Width> const& happened, Members<Member...> /*lanes*/) {
  return AXISRT_LANES_OF(happened, (First + Member)...);
}

/// The worst status as a number.
template <uint32_t Width>
AXISRT_INLINE uint64_t worst_of(Happened<Width> const& happened) {
  if constexpr (Width > 2) {
    FirstMembers<Width / 2> const lanes{};
    return worst_of<Width / 2>(half_of<0, Width>(happened, lanes) |
                               half_of<Width / 2, Width>(happened, lanes));
  } else {
    return lane_of(happened, 0) | lane_of(happened, Width - 1);
  }
}

/// Slots from group `first` on. Pointers one by one, as registers hold them.
template <uint32_t Width, bool AllReset>
AXISRT_APART uint64_t step_slots(Batch const& batch, uint32_t first, double const* in, double* out,
                                 uint8_t* status) {
  Call const call{in, out, status};
  Happened<Width> happened{};
  for (uint32_t group = first; group < batch.group_count; ++group) {
    Place<Width> place(batch, group);
    Signal<Width> const signal = place.template begin<AllReset>(call, happened);
    Signal<Width> const filtered = run_slot<Width>(batch.operations[0].slots[group], place.states(), signal);
    place.template end<AllReset>(call, filtered, happened);
  }
  return worst_of<Width>(happened);
}

/// Slots with moving averages, as long as they come first: as no call interrupts them, they have all
/// registers for themselves.
template <uint32_t Width, bool AllReset>
AXISRT_INLINE uint32_t step_ramps(Batch const& batch, Call const& call, Happened<Width>& happened) {
  SlotGroup* const slots = batch.operations[0].slots;
  uint32_t const groups = batch.group_count;
  uint32_t group = 0;
  for (; group < groups && slots[group].mode == SlotMode::ramp; ++group) {
    Place<Width> place(batch, group);
    Signal<Width> const in = place.template begin<AllReset>(call, happened);
    place.template end<AllReset>(call, run_ramp_slot<Width>(slots[group], place.states(), in), happened);
  }
  return group;
}

/// A function of its own for each kind, so that each has all registers for itself.
template <uint32_t Width, ChainKind Kind, bool AllReset>
AXISRT_APART uint64_t step_groups(Batch const& batch, double const* in, double* out, uint8_t* status) {
  Call const call{in, out, status};
  Happened<Width> happened{};
  uint32_t group = 0;
  if constexpr (Kind == ChainKind::slot) {
    group = step_ramps<Width, AllReset>(batch, call, happened);
    if (group < batch.group_count) {
      return worst_of<Width>(happened) | step_slots<Width, AllReset>(batch, group, in, out, status);
    }
  } else if constexpr (sections_of(Kind) > 0) {
    for (; group + 2 <= batch.group_count; group += 2) {
      step_sections<Width, sections_of(Kind), 2, AllReset>(batch, group, call, happened);
    }
    if (group < batch.group_count) {
      step_sections<Width, sections_of(Kind), 1, AllReset>(batch, group, call, happened);
    }
    bound_some_sections<Width>(batch, batch.operations[0]);
  } else {
    for (; group < batch.group_count; ++group) {
      Place<Width> place(batch, group);
      Signal<Width> signal = place.template begin<AllReset>(call, happened);
      for (uint32_t i = 0; i < batch.operation_count; ++i) {
        signal = run_operation<Width>(batch.operations[i], group, place.constants(i), place.parts(), signal);
      }
      place.template end<AllReset>(call, signal, happened);
    }
    for (uint32_t i = 0; i < batch.operation_count; ++i) {
      advance_operation<Width>(batch, batch.operations[i]);
    }
  }
  return worst_of<Width>(happened);
}

template <uint32_t Width, ChainKind Kind>
AXISRT_INLINE uint64_t step_kind(Batch const& batch, Call const& call) {
  return batch.state->never_reset == 0
             ? step_groups<Width, Kind, true>(batch, call.in, call.out, call.status)
             : step_groups<Width, Kind, false>(batch, call.in, call.out, call.status);
}

template <uint32_t Width>
AXISRT_INLINE uint64_t step_batch(Batch const& batch, Call const& call) {
  switch (batch.kind) {
    case ChainKind::sections_1: return step_kind<Width, ChainKind::sections_1>(batch, call);
    case ChainKind::sections_2: return step_kind<Width, ChainKind::sections_2>(batch, call);
    case ChainKind::sections_4: return step_kind<Width, ChainKind::sections_4>(batch, call);
    case ChainKind::sections_6: return step_kind<Width, ChainKind::sections_6>(batch, call);
    case ChainKind::slot: return step_kind<Width, ChainKind::slot>(batch, call);
    case ChainKind::any: break;
  }
  return step_kind<Width, ChainKind::any>(batch, call);
}

}  // namespace axisc::runtime::AXISRT_LEVEL
// NOLINTEND(bugprone-implicit-widening-of-multiplication-result)
