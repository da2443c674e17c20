// The table of an instruction set. Calls between here and the rest of the runtime go through it alone.
#pragma once

#include "runtime/instructions.hpp"
#include "runtime/lanes/batch_def.hpp"

// Pieces of a group are some thousand doubles: offsets in them fit into 32 bits.
// NOLINTBEGIN(bugprone-implicit-widening-of-multiplication-result)
namespace axisc::runtime::AXISRT_LEVEL {

/// Calls call.template operator()<Width>() for the width of the batch.
template <class Call>
AXISRT_INLINE void with_width(uint32_t width, Call const& call) {
  if (width == 1) call.template operator()<1>();
  if constexpr (AXISRT_LANES >= 2) {
    if (width == 2) call.template operator()<2>();
  }
  if constexpr (AXISRT_LANES >= 4) {
    if (width == 4) call.template operator()<4>();
  }
  if constexpr (AXISRT_LANES >= 8) {
    if (width == 8) call.template operator()<8>();
  }
}

AXISRT_INLINE uint64_t step_one(Batch const& batch, Call const& call) {
  uint64_t worst = AXISRT_OK;
  with_width(batch.width,
             [&]<uint32_t Width>() AXISRT_INLINE_LAMBDA { worst = step_batch<Width>(batch, call); });
  return worst;
}

static uint64_t step(Port const& port, double const* in, double* out, uint8_t* status) {
  // As on most machines: nothing is kept while it is computed.
  if (port.batch_count == 1) return step_one(port.batches[0], {in, out, status});
  uint64_t worst = AXISRT_OK;
  for (uint32_t i = 0; i < port.batch_count; ++i) {
    uint64_t const happened = step_one(port.batches[i], {in, out, status});
    worst = happened > worst ? happened : worst;
  }
  return worst;
}

static void run_one_operation(Batch const& batch, uint32_t operation, uint32_t group, double* signal) {
  Operation const& one = batch.operations[operation];
  double const* const constants =
      batch.constants[static_cast<size_t>(group) * batch.operation_count + operation];
  double* const parts = batch.states + static_cast<size_t>(group) * batch.state_stride;
  with_width(batch.width, [&]<uint32_t Width>() AXISRT_INLINE_LAMBDA {
    Signal<Width> const in{load_real<Width>(signal), load_real<Width>(signal + Width),
                           load_real<Width>(signal + 2 * Width)};
    Signal<Width> const out = run_operation<Width>(one, group, constants, parts, in);
    store<Width>(signal, out.base);
    store<Width>(signal + Width, out.sum);
    store<Width>(signal + 2 * Width, out.d);
    advance_operation<Width>(batch, one);
  });
}

extern Instructions const instructions;
// NOLINTNEXTLINE(misc-definitions-in-headers): included by one source of each level
Instructions const instructions{AXISRT_LEVEL_NUMBER, AXISRT_LANES, step, run_one_operation};

}  // namespace axisc::runtime::AXISRT_LEVEL
// NOLINTEND(bugprone-implicit-widening-of-multiplication-result)
