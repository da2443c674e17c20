#include "editor/capabilities/diagnostics.hpp"

#include "diagnostics/location.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

constexpr int unnecessary = 1;
constexpr int deprecated = 2;

/// The text that these findings mark has no effect.
constexpr std::array without_effect = {Code{1007}, Code{1008}, Code{1013},
                                       Code{1016}, Code{2006}, Code{3009}};
/// The manual recommends something else.
constexpr Code superseded{4007};

Json fix_data(Fix const& fix, Places const& places, Language language) {
  Json edits = Json::array();
  for (auto const& edit : fix.edits) {
    auto written = places.location(edit.place);
    written["newText"] = edit.text;
    edits.push_back(std::move(written));
  }
  return {{"title", render(fix.title, language)},
          {"safe", fix.safety == FixSafety::safe},
          {"edits", std::move(edits)}};
}

std::string page_of(std::string page, std::string const& code) {
  constexpr std::string_view place = "{code}";
  if (auto const at = page.find(place); at != std::string::npos) page.replace(at, place.size(), code);
  return page;
}

}  // namespace

Json diagnostic(Finding const& finding, Places const& places, Client const& client) {
  auto const text = [&client](Message const& message) { return render(message, client.language); };
  auto message = text(finding.message);
  if (finding.label) message += "\n" + text(*finding.label);
  for (auto const& note : finding.notes) message += "\n" + text(note);
  for (auto const& help : finding.help) message += "\n" + text(help);
  Json shown = {{"code", code_text(finding.code)},
                {"source", "axisc"},
                {"severity", static_cast<int>(finding.severity) + 1},
                {"message", std::move(message)},
                {"range", finding.place ? places.range(*finding.place) : range_json({}, {})}};
  if (!client.finding_page.empty()) {
    shown["codeDescription"] = {{"href", page_of(client.finding_page, shown["code"])}};
  }
  if (std::find(without_effect.begin(), without_effect.end(), finding.code) != without_effect.end()) {
    shown["tags"] = {unnecessary};
  } else if (finding.code == superseded) {
    shown["tags"] = {deprecated};
  }
  for (auto const& related : finding.related) {
    shown["relatedInformation"].push_back(
        {{"location", places.location(related.place)}, {"message", text(related.message)}});
  }
  if (finding.fix) shown["data"] = fix_data(*finding.fix, places, client.language);
  return shown;
}

Json diagnostics(OpenMachines& machines, OpenDocument const& document) {
  auto& reading = machines.reading_of(document);
  Places const places(reading.sources(), reading.files(), machines.encoding());
  Json found = Json::array();
  // Most findings are in the same file as the one before.
  std::optional<std::string> file;
  bool is_here = false;
  for (auto const& finding : reading.findings()) {
    if (auto const name = file_of(finding, reading.sources()); file != name) {
      file = name;
      is_here = reading.files().document(*file) == &document;
    }
    if (is_here) found.push_back(diagnostic(finding, places, machines.client()));
  }
  return found;
}

Json pull(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  // Clients that pull need not watch files on disk.
  machines.forget_readings();
  return {{"kind", "full"}, {"items", diagnostics(machines, asked)}};
}

}  // namespace axisc::editor
