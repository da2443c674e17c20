// Facts that every writer needs: the location and the severity of a finding.
#pragma once

#include "diagnostics/finding.hpp"

#include <string_view>

namespace axisc {

/// A place as tools name it. The end is the column after the last character (equal to the begin for an empty
/// span).
struct Location {
  std::string_view file;  ///< the name of the source; lives as long as the set
  Position begin;
  Position end;
};

[[nodiscard]] Location locate(Place const& place, SourceSet const& sources);

/// The file of a finding: that of its place, otherwise `finding.file`; empty if neither is known.
[[nodiscard]] std::string_view file_of(Finding const& finding, SourceSet const& sources);

/// "error", "warning" or "note": the word of the machine-readable formats, the same in every language.
[[nodiscard]] std::string_view severity_name(Severity severity);

}  // namespace axisc
