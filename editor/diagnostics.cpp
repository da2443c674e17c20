#include "diagnostics/location.hpp"
#include "editor/reading/places.hpp"
#include "editor/server.hpp"

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

/// What these findings point at has no effect.
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

std::string dump(Json const& message) {
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Json Server::diagnostic(Finding const& finding, Places const& places) const {
  auto const say = [this](Message const& message) { return render(message, surroundings_.language); };
  auto message = say(finding.message);
  if (finding.label) message += "\n" + say(*finding.label);
  for (auto const& note : finding.notes) message += "\n" + say(note);
  for (auto const& help : finding.help) message += "\n" + say(help);
  Json diagnostic = {{"code", code_text(finding.code)},
                     {"source", "axisc"},
                     {"severity", static_cast<int>(finding.severity) + 1},
                     {"message", std::move(message)},
                     {"range", finding.place ? places.range(*finding.place) : range_json({}, {})}};
  if (!settings_.finding_page.empty()) {
    diagnostic["codeDescription"] = {{"href", page_of(settings_.finding_page, diagnostic["code"])}};
  }
  if (std::find(without_effect.begin(), without_effect.end(), finding.code) != without_effect.end()) {
    diagnostic["tags"] = {unnecessary};
  } else if (finding.code == superseded) {
    diagnostic["tags"] = {deprecated};
  }
  for (auto const& related : finding.related) {
    diagnostic["relatedInformation"].push_back(
        {{"location", places.location(related.place)}, {"message", say(related.message)}});
  }
  if (finding.fix) diagnostic["data"] = fix_data(*finding.fix, places, surroundings_.language);
  return diagnostic;
}

Json Server::diagnostics(MachineReading& reading, Document const& document) const {
  Places const places(reading.sources(), reading.files(), encoding_);
  Json found = Json::array();
  // Most findings are in the file of the one before.
  std::optional<std::string> file;
  bool is_here = false;
  for (auto const& finding : reading.findings()) {
    if (auto const name = file_of(finding, reading.sources()); file != name) {
      file = name;
      is_here = reading.files().document(*file) == &document;
    }
    if (is_here) found.push_back(diagnostic(finding, places));
  }
  return found;
}

std::vector<std::string> Server::publish() {
  std::vector<std::string> messages;
  auto const add = [&messages](Json const& uri, std::string const& shown,
                               std::optional<std::int64_t> version) {
    messages.push_back(
        R"({"jsonrpc":"2.0","method":"textDocument/publishDiagnostics","params":{"diagnostics":)" + shown +
        R"(,"uri":)" + dump(uri) + (version ? R"(,"version":)" + std::to_string(*version) : "") + "}}");
  };
  for (auto const& uri : std::exchange(closed_, {})) add(uri, "[]", std::nullopt);
  if (changed_.empty()) return messages;
  std::map<std::string, std::vector<Document const*>> documents_of;
  auto const changed = std::exchange(changed_, {});
  for (auto const& uri : changed) documents_of.try_emplace(machine_of(documents_.at(uri)));
  for (auto const& [uri, document] : documents_) {
    auto const found = documents_of.find(machine_of(document));
    if (found != documents_of.end()) found->second.push_back(&document);
  }
  for (auto const& [machine, documents] : documents_of) {
    auto& reading = reading_of(machine);
    for (auto const* const each : documents) {
      auto const& document = *each;
      auto const& uri = document.uri;
      auto shown = dump(diagnostics(reading, document));
      auto& before = published_[uri];
      bool const is_news = before != shown || changed.contains(uri);
      before = std::move(shown);
      if (is_news) add(uri, before, document.version);
    }
  }
  return messages;
}

Json Server::pull(Json const& params) {
  auto const& asked = document(params);
  // Clients that pull need not watch files on disk.
  forget_readings();
  return {{"kind", "full"}, {"items", diagnostics(reading_of(asked), asked)}};
}

}  // namespace axisc::editor
