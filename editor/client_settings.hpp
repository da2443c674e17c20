// Settings of the editor: `axisc.cycleTime`, `axisc.language` and others.
#pragma once

#include "editor/reading/requests.hpp"

#include <optional>
#include <string>

namespace axisc::editor {

/// As written by the user; empty if the program's own options apply.
struct ClientSettings {
  std::string cycle_time;
  std::string build;
  std::string kind;
  std::string language;  ///< "de", "en", or "auto" for the program's own
  /// The page about a finding: a URI with {code} for its code.
  std::string finding_page;

  friend bool operator==(ClientSettings const&, ClientSettings const&) = default;
};

/// From all settings of a client; none if the section `axisc` is missing.
[[nodiscard]] std::optional<ClientSettings> client_settings(Json const& all);
/// From the section itself. Values that are not strings count as empty.
[[nodiscard]] ClientSettings settings_of_section(Json const& section);

}  // namespace axisc::editor
