#include "diagnostics/report_elements.hpp"

#include <algorithm>

namespace axisc {

std::string fill_holes(std::string_view element, Numbers const& numbers) {
  std::string text;
  text.reserve(element.size() + 16);
  constexpr std::string_view holes{"\x01\x02"};
  while (true) {
    std::size_t const hole = std::min(element.find_first_of(holes), element.size());
    text += element.substr(0, hole);
    if (hole == element.size()) return text;
    text += element[hole] == occurrence_hole ? std::to_string(numbers.occurrence)
                                             : std::to_string(numbers.rule_index);
    element.remove_prefix(hole + 1);
  }
}

std::string with_occurrence_hole(std::string_view element, std::string_view zeroth) {
  // Quotes inside strings are escaped, so this stands only where it is the end of a whole string.
  std::string const end = std::string(zeroth) + '"';
  std::string text;
  while (true) {
    std::size_t const found = element.find(end);
    if (found == std::string_view::npos) return text.append(element);
    text.append(element.substr(0, found)).append(zeroth.substr(0, zeroth.size() - 1));
    text += occurrence_hole;
    element.remove_prefix(found + zeroth.size());
  }
}

std::set<SourceId> sources_of(Finding const& finding) {
  std::set<SourceId> sources;
  if (finding.place) sources.insert(finding.place->source);
  for (Related const& related : finding.related) sources.insert(related.place.source);
  return sources;
}

}  // namespace axisc
