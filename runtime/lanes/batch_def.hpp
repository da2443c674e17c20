// A cycle of all groups of a batch: setpoints into lanes, the chain's operations, outputs and statuses back.
#pragma once

#include "axisrt.h"
#include "runtime/lanes/filters_def.hpp"
#include "runtime/lanes/slot_def.hpp"

namespace axisc::runtime::AXISRT_LEVEL {

/// What happened to any lane.
template <uint32_t Width>
struct Happened {
  Bits<Width> bad_input{};
  Bits<Width> not_reset{};
};

/// Setpoints as they come, and the masks that decide what becomes of them.
template <uint32_t Width>
struct Entry {
  Real<Width> setpoint;
  Bits<Width> good, done;
};

template <uint32_t Width>
AXISRT_INLINE Signal<Width> enter(double* parts, Entry<Width> const& entry) {
  auto const previous = load<Real<Width>>(parts + GroupParts::input * Width);
  Real<Width> const setpoint = select<Width>(entry.good & entry.done, entry.setpoint, previous);
  store(parts + GroupParts::input * Width, setpoint);
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
    case OperationKind::shared:
      return run_shared<Width>(operation, constants, states, in);
    case OperationKind::blocking:
      return run_blocking_filter<Width>(operation, constants, states, in);
    case OperationKind::delay:
      return run_delay<Width>(operation, constants, states, in);
    case OperationKind::slot:
      return run_slot<Width>(operation.slots[group], states, in);
  }
  return in;
}

/// After the operations of a group: sections are bounded in turn.
template <uint32_t Width>
AXISRT_INLINE void bound_operation(Operation const& operation, double* parts) {
  if (operation.section_count == 0) return;
  bound_some_sections<Width>(parts + operation.first_state * Width, operation.section_count,
                             operation.state->bounded);
}

/// After all groups: where the next cycle goes on.
AXISRT_INLINE void advance_operation(Operation const& operation) {
  OperationState& state = *operation.state;
  if (operation.kind == OperationKind::delay) {
    state.position = state.position == operation.delay_cycles ? 0 : state.position + 1;
  }
  if (operation.section_count > 0) {
    uint32_t const bounded = (operation.section_count + cycles_of_a_round - 1) / cycles_of_a_round;
    uint32_t const next = state.bounded + bounded;
    state.bounded = next >= operation.section_count ? next - operation.section_count : next;
  }
}

template <uint32_t Width>
AXISRT_INLINE void write_outputs(Real<Width> outputs, uint32_t const* lines, uint32_t used, bool consecutive,
                                 double* out) {
  if constexpr (Width == 1) {
    out[lines[0]] = outputs;
  } else if (consecutive) {
    store(out + lines[0], outputs);
  } else {
    for (uint32_t lane = 0; lane < used; ++lane) out[lines[lane]] = outputs[lane];
  }
}

template <uint32_t Width>
AXISRT_INLINE void write_statuses(Entry<Width> const& entry, uint32_t const* lines, uint32_t used,
                                  bool consecutive, uint8_t* status) {
  constexpr uint64_t bad = AXISRT_BAD_INPUT;
  constexpr uint64_t not_reset = AXISRT_NOT_RESET;
  Bits<Width> const happened = (entry.done & ~entry.good & bad) | (~entry.done & not_reset);
  if constexpr (Width == 1) {
    status[lines[0]] = static_cast<uint8_t>(happened);
  } else if (consecutive) {
    store(status + lines[0], __builtin_convertvector(happened, typename Lanes<Width>::Octets));
  } else {
    for (uint32_t lane = 0; lane < used; ++lane) status[lines[lane]] = static_cast<uint8_t>(happened[lane]);
  }
}

/// What the chains of a batch are known to be: this many passing sections and nothing else, or anything.
inline constexpr uint32_t any_chain = 0;

template <uint32_t Width, uint32_t Sections>
AXISRT_INLINE Signal<Width> run_chain(Batch const& batch, uint32_t group, double* parts, Signal<Width> signal) {
  double const* const* const constants = batch.constants + static_cast<size_t>(group) * batch.operation_count;
  if constexpr (Sections != any_chain) {
    double const* coefficients = constants[0];
    double* const states = parts + GroupParts::operations * Width;
    unrolled<Sections>([&]<uint32_t Section>() __attribute__((always_inline)) {
      CascadeSignal<Width> const added =
          run_section<Width>(coefficients + Section * coefficients_of_section * Width,
                             states + Section * states_of_section * Width, signal.d);
      signal.sum += added.sum;
      signal.d += added.d;
    });
    bound_some_sections<Width>(states, Sections, batch.operations[0].state->bounded);
  } else {
    for (uint32_t i = 0; i < batch.operation_count; ++i) {
      signal = run_operation<Width>(batch.operations[i], group, constants[i], parts, signal);
      bound_operation<Width>(batch.operations[i], parts);
    }
  }
  return signal;
}

template <uint32_t Width, uint32_t Sections>
AXISRT_INLINE void step_groups(Batch const& batch, double const* in, double* out, uint8_t* status,
                               Happened<Width>& happened) {
  for (uint32_t group = 0; group < batch.group_count; ++group) {
    double* const parts = batch.states + static_cast<size_t>(group) * batch.state_stride;
    uint32_t const* const lines = batch.lines + static_cast<size_t>(group) * Width;
    bool const consecutive = batch.consecutive[group] != 0;
    uint32_t const used = group + 1 == batch.group_count ? batch.used_in_last : Width;
    Entry<Width> entry;
    entry.setpoint = consecutive ? load<Real<Width>>(in + lines[0]) : gather<Width>(in, lines);
    entry.good = mask_if_within<Width>(entry.setpoint, largest_position);
    entry.done = load<Bits<Width>>(parts + GroupParts::reset_done * Width);
    happened.bad_input |= ~entry.good;
    happened.not_reset |= ~entry.done;
    Signal<Width> const signal = run_chain<Width, Sections>(batch, group, parts, enter<Width>(parts, entry));
    Real<Width> const output = signal.base + signal.sum;
    store(parts + GroupParts::output * Width, output);
    // A line that was never reset repeats its input, 0 for one that is not finite.
    Bits<Width> const finite = mask_if_within<Width>(entry.setpoint, 0x1.fffffffffffffp1023);
    write_outputs<Width>(select<Width>(entry.done, output, keep<Width>(finite, entry.setpoint)), lines, used,
                         consecutive, out);
    if (status != nullptr) write_statuses<Width>(entry, lines, used, consecutive, status);
  }
}

/// The worst status as a number.
template <uint32_t Width>
AXISRT_INLINE uint64_t worst_of(Happened<Width> const& happened) {
  uint64_t bad = 0;
  uint64_t not_reset = 0;
  if constexpr (Width == 1) {
    bad = happened.bad_input;
    not_reset = happened.not_reset;
  } else {
    for (uint32_t lane = 0; lane < Width; ++lane) {
      bad |= happened.bad_input[lane];
      not_reset |= happened.not_reset[lane];
    }
  }
  uint64_t const worst = opaque(bad) & AXISRT_BAD_INPUT;
  return (worst & ~not_reset) | (opaque(not_reset) & AXISRT_NOT_RESET);
}

/// Chains of sections alone, in the lengths that occur most, are written out.
template <uint32_t Width>
AXISRT_INLINE uint64_t step_batch(Batch const& batch, double const* in, double* out, uint8_t* status) {
  Happened<Width> happened;
  bool const sections_alone =
      batch.operation_count == 1 && batch.operations[0].kind == OperationKind::passing;
  switch (sections_alone ? batch.operations[0].section_count : any_chain) {
    case 1:
      step_groups<Width, 1>(batch, in, out, status, happened);
      break;
    case 2:
      step_groups<Width, 2>(batch, in, out, status, happened);
      break;
    case 4:
      step_groups<Width, 4>(batch, in, out, status, happened);
      break;
    case 6:
      step_groups<Width, 6>(batch, in, out, status, happened);
      break;
    default:
      step_groups<Width, any_chain>(batch, in, out, status, happened);
      break;
  }
  for (uint32_t i = 0; i < batch.operation_count; ++i) advance_operation(batch.operations[i]);
  return worst_of<Width>(happened);
}

}  // namespace axisc::runtime::AXISRT_LEVEL
