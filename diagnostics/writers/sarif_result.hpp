// One of the results of a SARIF document.
#pragma once

#include "diagnostics/writers/writers.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace axisc {

/// A result as text, except for the index of its rule, which is known when all results are.
struct SarifResult {
  Code code{};
  std::string text;
  std::size_t rule_index_at = 0;  ///< where it belongs in `text`
};

/// Replaces `result`, reusing its memory. Indented as in a run of the document.
void write_sarif_result(SarifResult& result, Finding const& finding, SourceSet const& sources,
                        std::string_view fingerprint, ReportContext const& context, Language language);

}  // namespace axisc
