// The standard filters of one axis, designed in double for whoever looks at what they do.
#pragma once

#include "design/filter_design.hpp"
#include "validator/views/filter_view.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace axisc::validator {

/// An active filter[i] of an axis, through which some of the signal passes, with its design. Both live as long as the
/// FilterDesigns.
struct ChainLink {
  FilterView const* filter;
  design::FilterDesign const* design;
};

/// Specifications and designs of the filters that a list touches, each made when it is first asked for and once: several
/// rules look at the same one, and the machine is built of them. One FilterDesigns serves one thread at a time.
class FilterDesigns {
 public:
  /// `filters` live longer and stay where they are.
  FilterDesigns(std::span<FilterView const> filters, design::CycleTime cycle_time);

  /// Of one of the filters: FilterView::specification().
  [[nodiscard]] std::optional<design::FilterSpecification> const& specification(
      FilterView const& filter) const;
  /// Of one of the filters; null where it is not active or a value is out of range.
  [[nodiscard]] design::FilterDesign const* of(FilterView const& filter) const;
  /// The chain that the setpoint passes; empty where no filter is active, or where one of them cannot be
  /// designed, so that nothing is said about a chain that is not the real one.
  [[nodiscard]] std::vector<ChainLink> setpoint_chain() const;

 private:
  struct Entry {
    bool looked_at = false;
    std::optional<design::FilterSpecification> specification;
    std::unique_ptr<design::FilterDesign const> design;
  };

  /// With its specification.
  [[nodiscard]] Entry& entry_of(FilterView const& filter) const;

  std::span<FilterView const> filters_;
  design::CycleTime cycle_time_;
  mutable std::vector<Entry> entries_;  ///< one per filter
};

/// For figures of the whole chain.
[[nodiscard]] std::vector<design::FilterDesign> designs(std::vector<ChainLink> const& chain);

}  // namespace axisc::validator
