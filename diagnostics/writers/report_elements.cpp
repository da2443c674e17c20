#include "diagnostics/writers/report_elements.hpp"

#include <algorithm>
#include <string>

namespace axisc {

std::string fill_holes(std::string_view element, HoleTexts const& texts) {
  std::string const rule_index = std::to_string(texts.rule_index);
  std::string text;
  text.reserve(element.size() + 32);
  // One search per kind, because searching for a single byte is fast.
  std::size_t next_fingerprint = element.find(fingerprint_hole);
  std::size_t next_rule_index = element.find(rule_index_hole);
  std::size_t begin = 0;
  while (true) {
    std::size_t const hole = std::min(next_fingerprint, next_rule_index);
    text += element.substr(begin, hole - begin);
    if (hole == std::string_view::npos) return text;
    begin = hole + 1;
    if (hole == next_fingerprint) {
      text += texts.fingerprint;
      next_fingerprint = element.find(fingerprint_hole, begin);
    } else {
      text += rule_index;
      next_rule_index = element.find(rule_index_hole, begin);
    }
  }
}

std::set<SourceId> sources_of(Finding const& finding) {
  std::set<SourceId> sources;
  if (finding.place) sources.insert(finding.place->source);
  for (Related const& related : finding.related) sources.insert(related.place.source);
  return sources;
}

}  // namespace axisc
