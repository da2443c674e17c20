#include "diagnostics/fix_batch.hpp"
#include "diagnostics/location.hpp"
#include "editor/reading/open_list.hpp"
#include "editor/reading/places.hpp"
#include "editor/reading/requests.hpp"
#include "editor/server.hpp"
#include "validator/list_layout.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace axisc::editor::says {

constexpr Sentence fix_all{"Fix everything that has a safe fix",
                           "Alles beheben, was sich sicher beheben lässt"};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

/// A fix may lead to a finding that has another one.
constexpr int most_rounds = 8;

std::string utf8(std::string bytes) {
  SourceText const text({}, std::move(bytes));
  return text.utf8({.begin = 0, .end = static_cast<std::uint32_t>(text.bytes().size())});
}

/// A workspace edit.
Json changes(FixBatch const& batch, SourceSet const& sources, Buffers const& files,
             PositionEncoding encoding) {
  Json changes = Json::object();
  for (auto const& edited : batch.apply()) {
    auto const& source = sources[edited.source];
    changes[files.uri(source.name())] = edits_between(utf8(*source.file()), utf8(edited.bytes), encoding);
  }
  return {{"changes", std::move(changes)}};
}

/// Editors ask for a kind and mean everything below it: `source` for `source.fixAll.axisc`.
bool wants(Json const& params, std::string_view kind) {
  auto const only = Json::json_pointer("/context/only");
  if (!params.contains(only) || !params[only].is_array()) return true;
  return std::any_of(params[only].begin(), params[only].end(), [kind](Json const& wanted) {
    if (!wanted.is_string()) return false;
    auto const& prefix = wanted.get_ref<std::string const&>();
    return kind == prefix || prefix.empty() || kind.starts_with(prefix + ".");
  });
}

bool is_fixed_in(Fix const& fix, SourceSet const& sources, Buffers const& files, Document const& document) {
  return std::all_of(fix.edits.begin(), fix.edits.end(), [&](Edit const& edit) {
    return files.document(sources[edit.place.source].name()) == &document;
  });
}

}  // namespace

Json Server::code_actions(Json const& params) {
  auto const& asked = document(params);
  auto const begin = position_in(params.at("range").at("start"));
  auto const end = position_in(params.at("range").at("end"));
  auto actions = Json::array();
  if (wants(params, "quickfix")) {
    auto& reading = reading_of(asked);
    auto const& files = reading.files();
    auto const& sources = reading.sources();
    Places const places(sources, files, encoding_);
    for (auto const& finding : reading.findings()) {
      if (!finding.place) continue;
      if (files.document(std::string(file_of(finding, sources))) != &asked) continue;
      auto const range = places.range(*finding.place);
      if (position_in(range["end"]) < begin || end < position_in(range["start"])) continue;
      auto const shown = diagnostic(finding, places);
      FixBatch batch(sources);
      if (finding.fix && batch.add(*finding.fix)) {
        actions.push_back({{"title", render(finding.fix->title, surroundings_.language)},
                           {"kind", "quickfix"},
                           {"isPreferred", finding.fix->safety == FixSafety::safe},
                           {"diagnostics", Json::array({shown})},
                           {"edit", changes(batch, sources, files, encoding_)}});
      }
      add_finding_actions(actions, finding, shown, asked);
    }
  }
  if (wants(params, "refactor.rewrite")) {
    auto const offset = offset_of(asked.text, begin, encoding_);
    add_value_action(actions, asked, offset);
    add_unit_action(actions, asked, offset);
  }
  if (wants(params, "source.fixAll.axisc")) {
    auto edits = fix_all(asked);
    if (!edits.empty()) {
      actions.push_back(
          {{"title", render({.sentence = says::fix_all, .arguments = {}}, surroundings_.language)},
           {"kind", "source.fixAll.axisc"},
           {"edit", {{"changes", {{asked.uri, std::move(edits)}}}}}});
    }
  }
  return actions;
}

Json Server::fix_all(Document const& document) {
  auto const machine = machine_of(document);
  auto documents = documents_;
  auto& fixed = documents.at(document.uri);
  for (int round = 0; round < most_rounds; ++round) {
    MachineReading reading({documents, surroundings_.disk}, machine, surroundings_.options);
    FixBatch batch(reading.sources());
    for (auto const& finding : reading.findings()) {
      bool const is_safe = finding.fix && finding.fix->safety == FixSafety::safe;
      bool const is_here = is_safe && is_fixed_in(*finding.fix, reading.sources(), reading.files(), fixed);
      if (is_here) batch.add(*finding.fix);
    }
    auto const edited = batch.apply();
    if (edited.empty() || edited.front().bytes == fixed.text) break;
    fixed.text = edited.front().bytes;
  }
  return edits_between(document.text, fixed.text, encoding_);
}

Json Server::format(Json const& params) {
  auto const& unaligned = document(params);
  // The layout of other files is up to their authors.
  if (!is_list(unaligned.path)) return Json::array();
  return edits_between(unaligned.text, aligned(unaligned), encoding_);
}

// Lines keep their number: those of the range come from the whole list as `fmt` aligns it.
Json Server::format_range(Json const& params) {
  auto const& unaligned = document(params);
  if (!is_list(unaligned.path)) return Json::array();
  auto const whole = aligned(unaligned);
  TextLines const before(unaligned.text, encoding_);
  TextLines const after(whole, encoding_);
  auto const first = position_in(params.at("range").at("start")).line;
  auto const last = position_in(params.at("range").at("end"));
  // An end at the beginning of a line leaves that line out.
  auto const end = std::min(before.count(), last.line + (last.character > 0 || last.line == first ? 1 : 0));
  auto edits = Json::array();
  for (auto line = first; line < end && before.count() == after.count(); ++line) {
    if (before.line(line) == after.line(line)) continue;
    edits.push_back({{"range", range_json({.line = line, .character = 0},
                                          {.line = line, .character = before.units_of(before.line(line))})},
                     {"newText", after.line(line)}});
  }
  return edits;
}

std::string Server::aligned(Document const& document) const {
  return validator::aligned_list(SourceText(document.path, document.text),
                                 surroundings_.options(document.path).catalogue);
}

}  // namespace axisc::editor
