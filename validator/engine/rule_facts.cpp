#include "validator/engine/rule_facts.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace axisc::validator {

namespace {

struct Manual {
  std::string_view key;
  Page name;
};

/// Manuals with sections.
constexpr std::array manuals{
    Manual{"axis-filters", {"Axis filters", "Achsfilter"}},
    Manual{"fir-filters", {"FIR filters", "FIR-Filter"}},
    Manual{"position-control", {"Improved Position Control", "Optimierte Lageregelung"}},
};

/// Manuals online, by their part of the address.
constexpr std::array online_manuals{
    Manual{"tccncaxisparameter", {"Axis parameters of TwinCAT 2", "Achsparameter von TwinCAT 2"}},
    Manual{"tf5200_axis_parameter", {"Axis parameters", "Achsparameter"}},
    Manual{"tf5200_channel_parameter", {"Channel parameters", "Kanalparameter"}},
    Manual{"tf5200_diagnosis", {"Diagnosis", "Diagnose"}},
    Manual{"tf5200_dynamic_param", {"Dynamic parameters", "Dynamikparameter"}},
    Manual{"tf5200_external_variables", {"External variables", "Externe Variablen"}},
    Manual{"tf5200_feedforward_control", {"Feedforward control", "Vorsteuerung"}},
    Manual{"tf5200_gantry_operation", {"Gantry operation", "Gantrybetrieb"}},
    Manual{"tf5200_programming_manual", {"Programming manual", "Programmieranleitung"}},
    Manual{"tf5200_startup_list", {"Start-up list", "Hochlaufliste"}},
    Manual{"tf5200_vibration_guard", {"Vibration Guard", "Vibration Guard"}},
    Manual{"tf5250_vibration_guard", {"Vibration Guard", "Vibration Guard"}},
};

/// What the vendor publishes besides manuals.
constexpr std::array others{
    Manual{"vendor-lists", {"lists that the vendor ships", "Listen, die der Hersteller mitliefert"}},
    Manual{"vendor-metadata",
           {"the vendor's machine-readable descriptions of parameters",
            "maschinenlesbare Parameterbeschreibungen des Herstellers"}},
};

template <std::size_t size>
std::optional<Wording> name_of(std::array<Manual, size> const& known, std::string_view key) {
  auto const found =
      std::find_if(known.begin(), known.end(), [key](Manual const& manual) { return manual.key == key; });
  return found == known.end() ? std::nullopt : std::optional(Wording(found->name));
}

Wording both(std::string_view english, std::string_view german, std::string_view rest) {
  return {std::string(english) + std::string(rest), std::string(german) + std::string(rest)};
}

bool is_number(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), ascii::is_digit);
}

/// "message 50663: https://…", or the name of the manual where the page has no other.
Wording online_page(std::string_view place, std::string_view about) {
  auto const manual = name_of(online_manuals, place.substr(0, place.find('/')));
  if (!manual) return {};
  Wording const address(": https://infosys.beckhoff.com/content/1033/" + std::string(place) + ".html");
  if (about.empty()) return *manual + address;
  return (is_number(about) ? both("message ", "Meldung ", about) : Wording(about)) + address;
}

}  // namespace

Wording source_text(std::string_view source) {
  auto const blank = source.find(' ');
  auto const key = source.substr(0, blank);
  auto const rest = blank == std::string_view::npos ? std::string_view() : source.substr(blank + 1);
  bool const is_online = std::find(key.begin(), key.end(), '/') != key.end();
  if (is_online) return online_page(key, rest);
  if (key == "message" && is_number(rest)) return both("text of message ", "Text der Meldung ", rest);
  if (auto const other = name_of(others, source)) return *other;
  auto const manual = name_of(manuals, key);
  if (!manual || rest.empty()) return {};
  return *manual + both(", section ", ", Abschnitt ", rest);
}

}  // namespace axisc::validator
