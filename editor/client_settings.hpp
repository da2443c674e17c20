// What the settings of an editor say of the control and of the language: `axisc.cycleTime` and its neighbours.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace axisc::editor {

/// As they are written; empty where the program's own options apply.
struct ClientSettings {
  std::string cycle_time;
  std::string build;
  std::string kind;
  std::string language;  ///< "de", "en", or "auto" for the program's own
  /// Where editors lead from the code of a finding: a URI with {code} for it.
  std::string finding_page;

  friend bool operator==(ClientSettings const&, ClientSettings const&) = default;
};

/// Of the section `axisc` of a client's settings; none where they do not have it.
[[nodiscard]] std::optional<ClientSettings> client_settings(nlohmann::json const& all);
/// Of the section itself. What is no text counts as empty.
[[nodiscard]] ClientSettings settings_of_section(nlohmann::json const& section);

}  // namespace axisc::editor
