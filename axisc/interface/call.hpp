// What every function of axisc.h does around its work: one call at a time, and no exception leaves the
// library.
#pragma once

#include "axisc/interface/workspace_object.hpp"

#include <initializer_list>
#include <optional>

namespace axisc::interface {

/// BadArgument where the caller's program does not keep to axisc.h.
void require(bool condition);
/// That the workspace was opened, and that no pointer is null.
void require_usable(axisc_workspace const& object, std::initializer_list<void const*> pointers);

/// An axisc_result for the exception that is being handled; its words become the workspace's error. `now`:
/// the files of the call, where it came to them. Throws where it is cancelled while it looks for them.
[[nodiscard]] int result_of_exception(axisc_workspace& object, Now* now);

/// `work(object, now)` gives an axisc_result and fills in its files. `pointers` must not be null; `result` is
/// emptied first, and may be null.
template <typename Work>
int call(axisc_workspace* object, std::initializer_list<void const*> pointers, axisc_bytes* result,
         Work const& work) {
  if (result != nullptr) *result = {.data = nullptr, .size = 0};
  if (object == nullptr) return AXISC_BAD_ARGUMENT;
  if (object->is_in_call.exchange(true)) return AXISC_BUSY;
  object->is_cancelled = false;
  object->error.clear();
  object->input.clear();
  int status = AXISC_INTERNAL;
  std::optional<Now> now;
  try {
    try {
      require_usable(*object, pointers);
      status = work(*object, now);
    } catch (...) {
      status = result_of_exception(*object, now ? &*now : nullptr);
    }
  } catch (Cancelled const&) {
    status = AXISC_CANCELLED;
  } catch (...) {
    status = AXISC_NO_MEMORY;  // while words for another failure were sought
  }
  object->is_in_call = false;
  return status;
}

}  // namespace axisc::interface
