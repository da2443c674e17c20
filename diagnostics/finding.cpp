#include "diagnostics/finding.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace axisc {

std::string code_text(Code code) {
  std::string const digits = std::to_string(static_cast<unsigned>(code));
  return "AX" + std::string(4 - std::min<std::size_t>(4, digits.size()), '0') + digits;
}

FindingCounts count(std::vector<Finding> const& findings) {
  FindingCounts counts;
  for (Finding const& finding : findings) {
    switch (finding.severity) {
      case Severity::error:
        ++counts.errors;
        break;
      case Severity::warning:
        ++counts.warnings;
        break;
      case Severity::note:
        ++counts.notes;
        break;
    }
  }
  return counts;
}

}  // namespace axisc
