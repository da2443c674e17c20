// The settings of an editor about the control and the language: `axisc.cycleTime` and its neighbours.
#pragma once

#include "editor/reading/requests.hpp"

#include <optional>
#include <string>

namespace axisc::editor {

/// As the user writes them; empty where the options of the program apply.
struct ClientSettings {
  std::string cycle_time;
  std::string build;
  std::string kind;
  std::string language;  ///< "de", "en", or "auto" for the program's own
  /// The page that an editor opens for the code of a finding: a URI with {code} for it.
  std::string finding_page;

  friend bool operator==(ClientSettings const&, ClientSettings const&) = default;
};

/// Of the section `axisc` of all settings of a client; none without the section.
[[nodiscard]] std::optional<ClientSettings> client_settings(Json const& all);
/// Of the section itself. Values that are not texts count as empty.
[[nodiscard]] ClientSettings settings_of_section(Json const& section);

}  // namespace axisc::editor
