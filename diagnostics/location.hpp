// What every writer needs to name: where a finding stands and how severe it is.
#pragma once

#include "diagnostics/finding.hpp"

#include <string_view>

namespace axisc {

/// A place as tools name it. The end is the column behind the last character (equal to the begin for an empty
/// span).
struct Location {
  std::string_view file;  ///< the name of the source; lives as long as the set
  Position begin;
  Position end;
};

[[nodiscard]] Location locate(Place const& place, SourceSet const& sources);

/// The file a finding is about: that of its place, else `finding.file`; empty where neither is known.
[[nodiscard]] std::string_view file_of(Finding const& finding, SourceSet const& sources);

/// "error", "warning" or "note": the word of the machine-readable formats, the same in every language.
[[nodiscard]] std::string_view severity_name(Severity severity);

}  // namespace axisc
