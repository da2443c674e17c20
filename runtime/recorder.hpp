// The ring of a recorder: inputs and outputs of every call, and a second runtime that has executed what fell
// out of the ring. So the recording always begins with a known state, no cycle copies one, and each costs the
// same: its own entry, and another cycle of the runtime that lags behind.
#pragma once

#include "axisrt.h"
#include "runtime/format/recording_format.h"
#include "runtime/runtime_object.hpp"

#include <stdint.h>

namespace axisc::runtime {

/// Words of a cycle's entry at each port; 0 for ports that are not recorded, because the image has no filters
/// there.
struct EntrySizes {
  uint64_t step, step_interface, step_velocity;
};
[[nodiscard]] EntrySizes entry_sizes(axisrt const& runtime);

}  // namespace axisc::runtime

struct axisrt_recorder {
  axisrt* runtime;       ///< that is recorded; null when the recording has ended
  axisrt* past;          ///< in the state before the oldest entry
  uint64_t* words;       ///< the ring
  double* values;        ///< of one entry: as many as it has at most
  uint64_t memory_size;  ///< of everything, from this object on
  uint64_t capacity;
  uint64_t first;  ///< where the oldest entry begins
  uint64_t used;
  uint64_t entries;
  axisc::runtime::EntrySizes sizes;
};

namespace axisc::runtime {

/// The head of an entry.
struct EntryHead {
  uint32_t kind;
  uint32_t flags;
  uint32_t status;
  uint32_t index;  ///< of an axis or a group
};
[[nodiscard]] uint64_t packed(EntryHead const& head);
[[nodiscard]] EntryHead unpacked(uint64_t word);

/// Writes one entry: the inputs of the call before it works, since it may overwrite them, and then its
/// outputs. Does nothing without a recorder.
class Entry {
 public:
  Entry(axisrt_recorder* recorder, uint32_t kind, uint32_t index, uint64_t words);
  /// Null: as many zeros.
  void put(double const* values, uint32_t count);
  void put(uint8_t const* status, uint32_t count);
  void put(uint64_t word);
  void finish(uint32_t flags, axisrt_status status);

 private:
  axisrt_recorder* recorder_;
  uint32_t kind_;
  uint32_t index_;
  uint64_t next_ = 0;
};

/// An entry of a call between the cycles.
void record_call(axisrt const& runtime, EntryHead const& head, double const* values, uint32_t count);

/// Executes entry `head` on a runtime; `values` are its words after the head, and the runtime's outputs are
/// written over the recorded ones.
axisrt_status execute(axisrt& runtime, EntryHead const& head, double* values);

}  // namespace axisc::runtime
