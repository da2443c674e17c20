#include "image/checked_bounds.hpp"

#include <algorithm>

namespace axisc::image {

std::size_t CheckedBounds::failures() const {
  auto const false_records = std::count_if(records.begin(), records.end(), [](CheckedBound const& record) {
    return record.failing != Claim::none;
  });
  auto const false_changes = std::count_if(changes.begin(), changes.end(),
                                           [](CheckedChange const& change) { return !change.holds; });
  return static_cast<std::size_t>(false_records + false_changes);
}

std::optional<std::uint32_t> bound_record_count(std::span<std::byte const> image) {
  runtime::ImageView view;
  bool const is_open = runtime::open_image(image.data(), image.size(), view) == AXISRT_OK;
  return is_open && view.bounds.first != nullptr ? std::optional(view.bounds.count) : std::nullopt;
}

CheckedBounds check_bounds(std::span<std::byte const> image) {
  namespace bounds = runtime::bounds;
  runtime::ImageView view;
  CheckedBounds checked;
  if (runtime::open_image(image.data(), image.size(), view) != AXISRT_OK) return checked;
  checked.is_in_image = view.bounds.first != nullptr;
  checked.changes.resize(view.axes.count);
  bounds::BoundKeys keys(view);
  bounds::BoundComputation computation(view);
  for (bounds::BoundKey key{}; keys.next(key);) {
    CheckedBound record;
    computation.compute(key, record.computed);
    auto const index = static_cast<std::uint32_t>(checked.records.size());
    if (checked.is_in_image) {
      record.claimed = bounds::stored_record(view.bounds[index]);
      record.failing = bounds::failing_claim(*record.claimed, record.computed);
    }
    if (key.port == axim_port_setpoint && key.kernel == AXIM_NONE) {
      ChangeBound const bound = bounds::bound_changes(view, key.axis, record.computed.gain_high);
      bool const holds = std::max(bound.velocity, bound.acceleration) <= bounds::largest_change;
      checked.changes[key.axis] = {.bound = bound, .holds = holds};
    }
    checked.records.push_back(record);
  }
  return checked;
}

}  // namespace axisc::image
