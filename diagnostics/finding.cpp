#include "diagnostics/finding.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace axisc {

std::string code_text(Code code) {
  std::string text = "AX0000";
  auto number = static_cast<unsigned>(code);
  assert(number <= 9999);
  for (std::size_t digit = text.size(); number > 0 && digit > 2; number /= 10) {
    text[--digit] = static_cast<char>('0' + number % 10);
  }
  return text;
}

void FindingCounts::add(Severity severity) {
  switch (severity) {
    case Severity::error: ++errors; break;
    case Severity::warning: ++warnings; break;
    case Severity::note: ++notes; break;
  }
}

FindingCounts count(std::vector<Finding> const& findings) {
  FindingCounts counts;
  for (Finding const& finding : findings) counts.add(finding.severity);
  return counts;
}

void most_frequent_first(std::vector<CodeCount>& counts) {
  std::sort(counts.begin(), counts.end(), [](CodeCount const& left, CodeCount const& right) {
    return std::pair(right.count, left.code) < std::pair(left.count, right.code);
  });
}

}  // namespace axisc
