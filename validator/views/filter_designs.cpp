#include "validator/views/filter_designs.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace axisc::validator {

FilterDesigns::FilterDesigns(std::span<FilterView const> filters, design::CycleTime cycle_time)
    : filters_(filters), cycle_time_(cycle_time), entries_(filters.size()) {}

FilterDesigns::Entry& FilterDesigns::entry_of(FilterView const& filter) const {
  auto const known = std::find_if(filters_.begin(), filters_.end(), [&filter](FilterView const& view) {
    return view.port == filter.port && view.index == filter.index;
  });
  assert(known != filters_.end());
  Entry& entry = entries_[static_cast<std::size_t>(known - filters_.begin())];
  if (!entry.looked_at) {
    entry.looked_at = true;
    entry.specification = filter.specification(cycle_time_);
  }
  return entry;
}

std::optional<design::FilterSpecification> const& FilterDesigns::specification(
    FilterView const& filter) const {
  return entry_of(filter).specification;
}

design::FilterDesign const* FilterDesigns::of(FilterView const& filter) const {
  Entry& entry = entry_of(filter);
  if (entry.specification && !entry.design) {
    entry.design = std::make_unique<design::FilterDesign const>(
        design::design_filter(*entry.specification, cycle_time_, design::Precision::quick));
  }
  return entry.design.get();
}

std::vector<ChainLink> FilterDesigns::setpoint_chain() const {
  std::vector<ChainLink> chain;
  for (FilterView const& filter : filters_) {
    if (filter.port != FilterPort::setpoint) continue;
    // It is unknown whether such a filter belongs to the chain.
    if (filter.unusable()) return {};
    // With share 0 the signal bypasses the filter.
    if (!filter.active() || filter.share.value.number == 0) continue;
    design::FilterDesign const* const design = of(filter);
    if (design == nullptr) return {};
    chain.push_back({.filter = &filter, .design = design});
  }
  return chain;
}

std::vector<design::FilterDesign> designs(std::vector<ChainLink> const& chain) {
  std::vector<design::FilterDesign> filters;
  filters.reserve(chain.size());
  for (ChainLink const& link : chain) filters.push_back(*link.design);
  return filters;
}

}  // namespace axisc::validator
