#include "validator/views/hsc_view.hpp"

#include <algorithm>
#include <iterator>

namespace axisc::validator {

bool is_configured_hsc(FilterView const& filter) {
  return filter.port == FilterPort::setpoint && filter.is_hsc();
}

std::vector<FilterView> configured_hsc(EffectiveValues const& values) {
  return configured_hsc(touched_filters(values));
}

std::vector<FilterView> configured_hsc(std::span<FilterView const> filters) {
  std::vector<FilterView> found;
  std::copy_if(filters.begin(), filters.end(), std::back_inserter(found), is_configured_hsc);
  return found;
}

std::optional<HscType> hsc_type(FilterView const& filter) {
  if (!is_configured_hsc(filter) || filter.type_unusable()) return std::nullopt;
  auto const* const kind = design::find_hsc_kind(filter.type_number());
  return kind == nullptr ? std::nullopt : std::optional(kind->type);
}

double resulting_hsc_order(FilterView const& filter, design::CycleTime cycle_time) {
  if (filter.order.value.number > 0) return filter.order.value.number;
  if (hsc_type(filter) != HscType::mean) return 0;
  return design::order_of_time({filter.time_constant.value.number}, cycle_time).value_or(0);
}

std::optional<design::KernelSpecification> hsc_kernel(FilterView const& filter,
                                                      design::CycleTime cycle_time) {
  auto const type = hsc_type(filter);
  if (!type || filter.order.unusable || filter.share.unusable) return std::nullopt;
  design::KernelSpecification specification;
  specification.share_percent = filter.share.value.number;
  specification.reading = filter.readings.kernels;
  specification.cycle_time = filter.readings.cycle_time;
  if (specification.share_percent < 0 || specification.share_percent > 100) return std::nullopt;
  double const order = resulting_hsc_order(filter, cycle_time);
  auto const kernel = design::find_hsc_kind(filter.type_number())->kernel;
  if (order > design::longest_order(kernel, filter.readings.kernels)) return std::nullopt;
  if (*type == HscType::mean) {
    if (!(filter.order.value.number > 0) && filter.time_constant.unusable) return std::nullopt;
    specification.type = kernel;
    specification.order = static_cast<std::uint32_t>(order);
    return specification;
  }
  specification.type = kernel;
  design::CycleTime const computed_for = design::as_read(cycle_time, filter.readings.cycle_time);
  specification.frequency = {filter.frequency.value.number};
  bool const fits =
      specification.frequency.value > 0 && specification.frequency < computed_for.nyquist() &&
      design::novib_order(specification.frequency, computed_for) <= design::longest_kernel_order;
  if (order == 0 || filter.frequency.unusable || !fits) return std::nullopt;
  return specification;
}

}  // namespace axisc::validator
