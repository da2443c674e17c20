// How axes are executed side by side.
//
// A *line* is one signal with its chain of filters: an axis' setpoint, its additional interface, or a stage
// of Improved Position Control. Lines whose chains do the same things one after the other form a *group*,
// each in a *lane* of it; groups of the same shape and width are a *batch*. Everything of a group is stored
// lane by lane, so that one vector instruction serves all of them. How many lanes a group has is decided by
// the processor that executes it.
//
// These are plain structures without functions: code for several instruction sets includes them.
#pragma once

#include <stdint.h>

namespace axisc::runtime {

inline constexpr uint32_t most_lanes = 8;
inline constexpr uint32_t most_operations = 4;
/// Cycles in a block of a linear-phase filter's history.
inline constexpr uint32_t block_cycles = 8;

/// Up to this many lanes with a linear-phase filter are done over time, one by one; more of them side by
/// side.
inline constexpr uint32_t widest_by_one = 2;

enum class OperationKind : uint32_t {
  passing,   ///< sections with H(1) = 1, all of the signal goes through them
  shared,    ///< sections with H(1) = 1, and a part that bypasses them
  blocking,  ///< sections with H(1) = 0
  delay,
  slot  ///< a linear-phase kernel, or none at present
};

/// A linear-phase kernel as tail sums. S_j = zero[-j]; zeros precede S_0 and follow the last one, as many as
/// are needed to apply whole blocks.
struct Kernel {
  double const* zero;
  uint32_t tail_count;
  uint32_t block_count;  ///< blocks of the history that the tails reach into
  double ramp;           ///< S_j = ramp (tail_count - j) for a moving average, 0 for every other kernel
  double length;         ///< tail_count as a factor
};

enum class SlotMode : uint32_t {
  direct,   ///< every lane applies its own tails to the whole history; while kernels change over
  blocked,  ///< all but the latest increments were applied ahead
  ramp      ///< all lanes have the same moving average
};

/// Linear-phase filters of the lanes of a group, except what is in the group's state.
struct SlotGroup {
  SlotMode mode;
  uint32_t gathers;      ///< 1: `ahead` of the next block is being summed up
  uint32_t block;        ///< of the history, that is being filled
  uint32_t phase;        ///< in the block, where the next increment goes
  uint32_t ramp_phase;   ///< cycles of the present window that are done
  uint32_t fading;       ///< lanes that change over
  uint32_t block_count;  ///< of the history
  uint32_t next_ahead;   ///< which of the two halves of `ahead` is for the next block
  uint32_t used;         ///< lanes that have a line
  uint32_t reserved;
  Kernel const* common;  ///< kernel of all lanes; null if they differ or change over
  double* to;            ///< tails of the lanes' kernels, side by side: S_j of lane l at to[-j width + l]
  double* from;          ///< of those they change over from
  Kernel const* kernel[most_lanes];    ///< in use, or beginning to be
  Kernel const* before[most_lanes];    ///< in use before the fade
  uint32_t fade_position[most_lanes];  ///< cycles of the fade that are done; fade_length when none runs
  uint32_t fade_length[most_lanes];
};

/// Where the parts of a slot are in its piece of the group's state, in units of one double per lane.
struct SlotParts {
  static constexpr uint32_t removed = 0;  ///< taken from the signal by the filter in the latest cycle
  static constexpr uint32_t ramp = 1;     ///< C, P, G, Q
  static constexpr uint32_t ahead = 5;    ///< two halves of a block
  static constexpr uint32_t history =
      ahead + 2 * block_cycles;  ///< increments in the order of time, block by block
};

/// State that changes in a cycle and is the same for all groups of a batch.
struct OperationState {
  uint32_t position;  ///< in the ring of a delay, where the next signal goes
  uint32_t group;     ///< of the section that is bounded next
  uint32_t section;
};

/// One step of the chains of a batch.
///
/// Its piece of a group's state, one double per lane each:
///   sections  e, r + 2^-567 of each
///   delay     delay_cycles + 1 times base, sum, d
///   slot      see SlotParts
/// Its piece of a group's constants:
///   passing                  p, g, k, b of each section
///   shared, blocking, delay  s, 1 - s, the rest of 1 - s, then the sections
struct Operation {
  OperationKind kind;
  uint32_t section_count;  ///< of the longest lane; the others have sections in between that change nothing
  uint32_t delay_cycles;
  uint32_t first_state;  ///< of its piece of the group's state, in doubles per lane
  SlotGroup* slots;      ///< of a slot: one for each group
  OperationState* state;
};

/// Pieces that begin every group's state, one double per lane each.
struct GroupParts {
  static constexpr uint32_t input = 0;              ///< the last good setpoint
  static constexpr uint32_t output = 1;             ///< 0 before the first reset
  static constexpr uint32_t reset_done = 2;         ///< all bits set after a reset
  static constexpr uint32_t largest_increment = 3;  ///< that is plausible; never changes
  static constexpr uint32_t operations = 4;
};

/// State that calls between the cycles change for a whole batch.
struct BatchState {
  uint32_t never_reset;  ///< lines that were never reset
};

/// The known form of the chains of a batch, so that a cycle needs no decisions.
enum class ChainKind : uint32_t {
  any,
  sections_1,  ///< this many passing sections and nothing else
  sections_2,
  sections_4,
  sections_6,
  slot  ///< a linear-phase filter and nothing else
};

struct Batch {
  uint32_t width;  ///< lanes of a group: 1, 2, 4 or 8
  uint32_t group_count;
  uint32_t used_in_last;  ///< lanes of the last group that have a line; the others repeat its first line
  uint32_t operation_count;
  uint32_t state_stride;  ///< doubles of a group's state
  uint32_t consecutive;   ///< 1: its lanes are neighbouring lines, group after group
  ChainKind kind;
  Operation operations[most_operations];
  BatchState* state;
  double* states;                  ///< of all groups
  double const* const* constants;  ///< [group][operation]; equal ones of neighbours are stored once
  uint32_t const* lines;           ///< [group][lane]
};

/// Lines that one call executes.
struct Port {
  Batch const* batches;
  uint32_t batch_count;
  uint32_t line_count;
};

}  // namespace axisc::runtime
