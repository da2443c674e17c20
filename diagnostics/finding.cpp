#include "diagnostics/finding.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <map>
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
    case Severity::error:
      ++errors;
      break;
    case Severity::warning:
      ++warnings;
      break;
    case Severity::note:
      ++notes;
      break;
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

std::vector<CodeCount> count_codes(std::vector<Finding> const& findings) {
  std::map<Code, CodeCount> by_code;
  for (Finding const& finding : findings) {
    CodeCount& row = by_code[finding.code];
    row.code = finding.code;
    row.name = finding.name;
    ++row.count;
    if (finding.fix) ++row.fixable;
  }
  std::vector<CodeCount> counts;
  counts.reserve(by_code.size());
  for (auto const& [code, row] : by_code) counts.push_back(row);
  most_frequent_first(counts);
  return counts;
}

}  // namespace axisc
