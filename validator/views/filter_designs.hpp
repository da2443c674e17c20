// The standard filters of one axis, designed in double precision for analysis.
#pragma once

#include "design/filter_design.hpp"
#include "validator/views/filter_view.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace axisc::validator {

/// An active filter[i] of an axis with a share above 0, and its design. Both live as long as the
/// FilterDesigns.
struct ChainLink {
  FilterView const* filter;
  design::FilterDesign const* design;
};

/// Specifications and designs of the filters that a list touches, each computed once, on first access:
/// several rules use the same one, and the machine is built from them. One FilterDesigns serves one thread at
/// a time.
class FilterDesigns {
 public:
  /// `filters` must outlive this object and must not move.
  FilterDesigns(std::span<FilterView const> filters, design::CycleTime cycle_time);

  /// FilterView::specification() of one of the filters.
  [[nodiscard]] std::optional<design::FilterSpecification> const& specification(
      FilterView const& filter) const;
  /// The design of one of the filters; null if it is not active or a value is out of range.
  [[nodiscard]] design::FilterDesign const* of(FilterView const& filter) const;
  /// The chain that the setpoint passes; empty if no filter is active, or if one of them cannot be designed,
  /// so that no statement is made about an incomplete chain.
  [[nodiscard]] std::vector<ChainLink> setpoint_chain() const;

 private:
  struct Entry {
    bool looked_at = false;
    std::optional<design::FilterSpecification> specification;
    std::unique_ptr<design::FilterDesign const> design;
  };

  /// The entry of a filter, with its specification filled in.
  [[nodiscard]] Entry& entry_of(FilterView const& filter) const;

  std::span<FilterView const> filters_;
  design::CycleTime cycle_time_;
  mutable std::vector<Entry> entries_;  ///< one per filter
};

/// For figures of the whole chain.
[[nodiscard]] std::vector<design::FilterDesign> designs(std::vector<ChainLink> const& chain);

}  // namespace axisc::validator
