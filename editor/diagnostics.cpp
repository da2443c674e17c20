#include "diagnostics/location.hpp"
#include "editor/buffers.hpp"
#include "editor/server.hpp"
#include "editor/uri.hpp"
#include "validator/check.hpp"

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

using Json = nlohmann::json;

class DiagnosticWriter {
 public:
  DiagnosticWriter(SourceSet const& sources, Language language, PositionEncoding encoding)
      : sources_(sources), language_(language), encoding_(encoding) {}

  [[nodiscard]] Json write(Finding const& finding, bool is_here) const {
    auto message = say(finding.message);
    if (finding.label) message += "\n" + say(*finding.label);
    for (auto const& note : finding.notes) message += "\n" + say(note);
    for (auto const& help : finding.help) message += "\n" + say(help);
    Json diagnostic = {{"code", code_text(finding.code)},
                       {"source", "axisc"},
                       {"severity", static_cast<int>(finding.severity) + 1},
                       {"message", std::move(message)},
                       {"range", nothing()}};
    if (finding.place && is_here) diagnostic["range"] = range(*finding.place);
    for (auto const& related : finding.related) add(diagnostic, related.place, say(related.message));
    // A finding of another file is shown at the beginning, with its place.
    if (finding.place && !is_here) add(diagnostic, *finding.place, say(finding.message));
    if (finding.fix) {
      Json edits = Json::array();
      for (auto const& edit : finding.fix->edits) {
        edits.push_back({{"uri", uri(edit.place)}, {"range", range(edit.place)}, {"newText", edit.text}});
      }
      diagnostic["data"] = {{"title", say(finding.fix->title)},
                            {"safe", finding.fix->safety == FixSafety::safe},
                            {"edits", std::move(edits)}};
    }
    return diagnostic;
  }

 private:
  static Json nothing() {
    Json const start = {{"line", 0}, {"character", 0}};
    return {{"start", start}, {"end", start}};
  }
  [[nodiscard]] std::string say(Message const& message) const { return render(message, language_); }
  [[nodiscard]] std::string uri(Place const& place) const { return uri_of(sources_[place.source].name()); }
  void add(Json& diagnostic, Place const& place, std::string message) const {
    diagnostic["relatedInformation"].push_back(
        {{"location", {{"uri", uri(place)}, {"range", range(place)}}}, {"message", std::move(message)}});
  }
  [[nodiscard]] Json position(SourceText const& source, Position at) const {
    auto const line = source.utf8(source.shown_line(at.line));
    return {{"line", at.line - 1}, {"character", units(line, at.column - 1, encoding_)}};
  }
  [[nodiscard]] Json range(Place const& place) const {
    auto const& source = sources_[place.source];
    auto const location = locate(place, sources_);
    return {{"start", position(source, location.begin)}, {"end", position(source, location.end)}};
  }

  SourceSet const& sources_;
  Language language_;
  PositionEncoding encoding_;
};

}  // namespace

Json Server::diagnostics(Document const& document) {
  Buffers files(documents_, surroundings_.disk);
  SourceSet sources;
  DiagnosticWriter const writer(sources, surroundings_.language, encoding_);
  auto const result = validator::check(files, document.path, surroundings_.options(document.path), sources);
  Json found = Json::array();
  for (auto const& finding : result.findings) {
    found.push_back(writer.write(finding, file_of(finding, sources) == document.path));
  }
  return found;
}

std::vector<std::string> Server::publish() {
  std::vector<std::string> messages;
  for (auto const& [uri, is_open] : changed_) {
    Json params = {{"uri", uri}, {"diagnostics", Json::array()}};
    if (is_open) {
      auto const& document = documents_.at(uri);
      params["diagnostics"] = diagnostics(document);
      if (document.version) params["version"] = *document.version;
    }
    Json const message = {
        {"jsonrpc", "2.0"}, {"method", "textDocument/publishDiagnostics"}, {"params", std::move(params)}};
    messages.push_back(message.dump(-1, ' ', false, Json::error_handler_t::replace));
  }
  changed_.clear();
  return messages;
}

Json Server::pull(Json const& params) {
  return {{"kind", "full"}, {"items", diagnostics(document(params))}};
}

}  // namespace axisc::editor
