#include "axisc/interface/call.hpp"

#include "axisc/environment/failure_line.hpp"
#include "axisc/interface/asked.hpp"

#include <new>

namespace axisc::says {

constexpr Sentence bad_argument{"a pointer is null, or a number or the size of a structure is unknown",
                                "ein Zeiger ist null, oder eine Zahl oder Strukturgröße ist unbekannt"};
constexpr Sentence not_opened{"the workspace was not opened", "der Arbeitsbereich wurde nicht geöffnet"};
constexpr Sentence cancelled{"the call was cancelled", "der Aufruf wurde abgebrochen"};

}  // namespace axisc::says

namespace axisc::interface {

void require(bool condition) {
  if (!condition) throw BadArgument({says::bad_argument});
}

void require_usable(axisc_workspace const& object, std::initializer_list<void const*> pointers) {
  if (!object.is_usable) throw BadArgument({says::not_opened});
  for (auto const* const pointer : pointers) require(pointer != nullptr);
}

int result_of_exception(axisc_workspace& object, Now* now) {
  try {
    throw;
  } catch (Cancelled const&) {
    object.error = Failure({says::cancelled}).line(object.language);
    return AXISC_CANCELLED;
  } catch (std::bad_alloc const&) {
    return AXISC_NO_MEMORY;  // a line about it would need some
  } catch (...) {
    object.error += failure_line(object.language);
  }
  try {
    throw;
  } catch (BadArgument const&) {
    return AXISC_BAD_ARGUMENT;
  } catch (Failure const&) {
    bool const is_missing = now != nullptr && !object.input.empty() && !now->has(object.input);
    return is_missing ? AXISC_NOT_FOUND : AXISC_UNUSABLE;
  } catch (configuration::SourceChanged const&) {
    return AXISC_UNUSABLE;
  } catch (...) {
    return AXISC_INTERNAL;
  }
}

}  // namespace axisc::interface
