#include "axisrt.h"
#include "runtime/bounds/change_bound.hpp"
#include "runtime/bounds/claims.hpp"
#include "runtime/control_word.hpp"

namespace axisc::runtime::bounds {
namespace {

/// The first record that does not hold, in `failing`.
axisrt_status check_records(ImageView const& view, uint32_t most_cycles, uint32_t& failing) {
  BoundKeys keys(view);
  BoundKey key{};
  BoundComputation computation(view);
  for (failing = 0; failing < view.bounds.count; ++failing) {
    BoundRecord const claimed = stored_record(view.bounds[failing]);
    if (!keys.next(key) || claimed.cycles > most_cycles) return AXISRT_BOUND_FAILED;
    BoundRecord computed;
    computation.compute(key, computed);
    if (failing_claim(claimed, computed) != Claim::none) return AXISRT_BOUND_FAILED;
    if (key.port != axim_port_setpoint || key.kernel != AXIM_NONE) continue;
    ChangeBound const change = bound_changes(view, key.axis, computed.gain_high);
    if (change.velocity > largest_change || change.acceleration > largest_change) return AXISRT_BOUND_FAILED;
  }
  return keys.next(key) ? AXISRT_BOUND_FAILED : AXISRT_OK;
}

}  // namespace
}  // namespace axisc::runtime::bounds

axisrt_status axisrt_check_bounds(void const* image, size_t size, uint32_t most_cycles, uint32_t* record) {
  using namespace axisc::runtime;
  if (record == nullptr) return AXISRT_BAD_ARGUMENT;
  *record = 0;
  ImageView view;
  axisrt_status const status = verify_image(image, size, view);
  if (status != AXISRT_OK) return status;
  if (view.bounds.first == nullptr) return AXISRT_BOUND_FAILED;
  return in_plain_arithmetic([&] { return bounds::check_records(view, most_cycles, *record); });
}
