#include "editor/capabilities/actions.hpp"

#include "diagnostics/fix_batch.hpp"
#include "diagnostics/location.hpp"
#include "editor/capabilities/diagnostics.hpp"
#include "editor/capabilities/line_actions.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace axisc::editor::says {

constexpr Sentence fix_all{"Fix everything that has a safe fix",
                           "Alles beheben, was sich sicher beheben lässt"};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

/// Fixing a finding may lead to another one that has a fix.
constexpr int most_rounds = 8;

std::string utf8(std::string bytes) {
  SourceText const text({}, std::move(bytes));
  return text.utf8({.begin = 0, .end = static_cast<std::uint32_t>(text.bytes().size())});
}

/// A workspace edit.
Json changes(FixBatch const& batch, SourceSet const& sources, Buffers const& files,
             PositionEncoding encoding) {
  Json edits = Json::object();
  for (auto const& edited : batch.apply()) {
    auto const& source = sources[edited.source];
    edits[files.uri(source.name())] = edits_between(utf8(*source.file()), utf8(edited.bytes), encoding);
  }
  return {{"changes", std::move(edits)}};
}

/// A kind includes everything below it: `source` stands for `source.fixAll.axisc`, too.
bool wants(Json const& params, std::string_view kind) {
  auto const only = Json::json_pointer("/context/only");
  if (!params.contains(only) || !params[only].is_array()) return true;
  return std::any_of(params[only].begin(), params[only].end(), [kind](Json const& wanted) {
    if (!wanted.is_string()) return false;
    auto const& prefix = wanted.get_ref<std::string const&>();
    return kind == prefix || prefix.empty() || kind.starts_with(prefix + ".");
  });
}

bool is_fixed_in(Fix const& fix, SourceSet const& sources, Buffers const& files,
                 OpenDocument const& document) {
  return std::all_of(fix.edits.begin(), fix.edits.end(), [&](Edit const& edit) {
    return files.document(sources[edit.place.source].name()) == &document;
  });
}

/// Edits of the document.
Json fix_all(OpenMachines& machines, OpenDocument const& document) {
  auto const machine = machines.machine_of(document);
  auto documents = machines.documents();
  auto& fixed = documents.at(document.uri);
  for (int round = 0; round < most_rounds; ++round) {
    MachineReading reading(machines.buffers(documents), machine, machines.options());
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
  return edits_between(document.text, fixed.text, machines.encoding());
}

void add_fixes(OpenMachines& machines, OpenDocument const& asked, TextPosition begin, TextPosition end,
               Json& actions) {
  auto& reading = machines.reading_of(asked);
  auto const& files = reading.files();
  auto const& sources = reading.sources();
  Places const places(sources, files, machines.encoding());
  for (auto const& finding : reading.findings()) {
    if (!finding.place) continue;
    if (files.document(std::string(file_of(finding, sources))) != &asked) continue;
    auto const range = places.range(*finding.place);
    if (position_in(range["end"]) < begin || end < position_in(range["start"])) continue;
    auto const shown = diagnostic(finding, places, machines.client());
    FixBatch batch(sources);
    if (finding.fix && batch.add(*finding.fix)) {
      actions.push_back({{"title", render(finding.fix->title, machines.language())},
                         {"kind", "quickfix"},
                         {"isPreferred", finding.fix->safety == FixSafety::safe},
                         {"diagnostics", Json::array({shown})},
                         {"edit", changes(batch, sources, files, machines.encoding())}});
    }
    add_finding_actions(actions, machines, asked, finding, shown);
  }
}

}  // namespace

Json code_actions(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  auto const begin = position_in(params.at("range").at("start"));
  auto const end = position_in(params.at("range").at("end"));
  auto actions = Json::array();
  if (wants(params, "quickfix")) add_fixes(machines, asked, begin, end, actions);
  if (wants(params, "refactor.rewrite")) {
    add_rewrites(actions, machines, asked, TextLines(asked.text, machines.encoding()).offset(begin));
  }
  if (wants(params, "source.fixAll.axisc")) {
    auto edits = fix_all(machines, asked);
    if (!edits.empty()) {
      actions.push_back({{"title", machines.say(says::fix_all)},
                         {"kind", "source.fixAll.axisc"},
                         {"edit", {{"changes", {{asked.uri, std::move(edits)}}}}}});
    }
  }
  return actions;
}

}  // namespace axisc::editor
