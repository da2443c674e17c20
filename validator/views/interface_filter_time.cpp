#include "validator/views/interface_filter_time.hpp"

#include "design/filter_kinds.hpp"

namespace axisc::validator {

std::optional<design::FilterSpecification> interface_filter_time(EffectiveValues const& values,
                                                                 design::CycleTime cycle_time) {
  EffectiveValue const& time = values.at(interface_filter_time_name);
  if (time.unusable || !(time.value.number > 0)) return std::nullopt;
  design::FilterSpecification specification;
  specification.type = design::FilterType::pt2;
  specification.time_constant = {time.value.number};
  specification.reading = values.readings().filters;
  specification.cycle_time = values.readings().cycle_time;
  specification.reading = design::applied_reading(specification);
  return design::is_in_range(specification, cycle_time) ? std::optional(specification) : std::nullopt;
}

}  // namespace axisc::validator
