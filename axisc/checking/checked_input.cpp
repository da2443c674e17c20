#include "axisc/checking/checked_input.hpp"

namespace axisc {

std::size_t weight_of(CheckedInput const& checked) {
  /// The sentences' arguments, a fix.
  constexpr std::size_t values_of_finding = 1024;
  auto weight = sizeof(checked) + checked.findings.size() * (sizeof(Finding) + values_of_finding);
  for (std::size_t i = 0; i < checked.sources.size(); ++i) {
    weight += checked.sources[static_cast<SourceId>(i)].bytes().size();
  }
  return weight;
}

}  // namespace axisc
