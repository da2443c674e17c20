#include "validator/rules/hsc_words.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {

void relate_prototype(Finding& finding, FilterView const& filter) {
  auto const& place = filter.prototype.value_place();
  if (place) finding.related.push_back({*place, {Text::hsc_prototype_here, {}}});
}

void relate_hsc_filter(Finding& finding, FilterView const& filter) {
  auto const& place = filter.prototype.value_place();
  if (place) {
    finding.related.push_back({*place, {Text::hsc_filter_here, {{"filter", filter_name(filter)}}}});
  }
}

}  // namespace axisc::validator::checks
