#include "validator/rules/hsc_words.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::says {

constexpr Sentence prototype_here{"the prototype is set here", "hier wird der Prototyp gesetzt"};

constexpr Sentence filter_here{"`{filter}` is an HSC filter", "`{filter}` ist ein HSC-Filter"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {

void relate_prototype(Finding& finding, FilterView const& filter) {
  auto const& place = filter.prototype.value_place();
  if (place) finding.related.push_back({*place, {says::prototype_here, {}}});
}

void relate_hsc_filter(Finding& finding, FilterView const& filter) {
  auto const& place = filter.prototype.value_place();
  if (place) {
    finding.related.push_back({*place, {says::filter_here, {{"filter", filter_name(filter)}}}});
  }
}

}  // namespace axisc::validator::checks
