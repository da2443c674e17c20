#include "image/proved_bounds.hpp"

#include "runtime/bounds/bound_record.hpp"

#include <algorithm>

namespace axisc::image {
namespace {

using runtime::bounds::BoundRecord;

void add(BoundRecord const& record, ProvedBounds& worst) {
  worst.gain_high = std::max(worst.gain_high, record.gain_high);
  worst.overshoot_high = std::max(worst.overshoot_high, record.overshoot_high);
  if (record.rest_cycles == 0) worst.rest_cycles.reset();
  if (worst.rest_cycles) worst.rest_cycles = std::max(*worst.rest_cycles, record.rest_cycles);
}

}  // namespace

ProvedBounds proved_bounds(std::span<std::byte const> image, std::uint32_t axis) {
  namespace bounds = runtime::bounds;
  runtime::ImageView view;
  ProvedBounds worst;
  if (runtime::open_image(image.data(), image.size(), view) != AXISRT_OK) return worst;
  for (std::uint32_t i = 0; view.bounds.first != nullptr && i < view.bounds.count; ++i) {
    auto const record = bounds::stored_record(view.bounds[i]);
    if (record.axis == axis && record.port == axim_port_setpoint) add(record, worst);
  }
  if (view.bounds.first != nullptr) return worst;
  bounds::BoundKeys keys(view, axis);
  bounds::BoundComputation computation(view);
  for (bounds::BoundKey key{}; keys.next(key) && key.axis == axis && key.port == axim_port_setpoint;) {
    BoundRecord record{};
    computation.compute(key, record);
    add(record, worst);
  }
  return worst;
}

}  // namespace axisc::image
