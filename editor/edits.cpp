#include "diagnostics/fix_batch.hpp"
#include "diagnostics/location.hpp"
#include "editor/open_list.hpp"
#include "editor/places.hpp"
#include "editor/requests.hpp"
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
  Buffers files(documents_, surroundings_.disk);
  auto actions = Json::array();
  if (wants(params, "quickfix")) {
    auto const checked = check(files, machine_of(asked));
    Places const places(checked.sources, files, encoding_);
    for (auto const& finding : checked.findings) {
      if (!finding.fix || !finding.place) continue;
      if (files.document(std::string(file_of(finding, checked.sources))) != &asked) continue;
      auto const range = places.range(*finding.place);
      if (position_in(range["end"]) < begin || end < position_in(range["start"])) continue;
      FixBatch batch(checked.sources);
      if (!batch.add(*finding.fix)) continue;
      actions.push_back({{"title", render(finding.fix->title, surroundings_.language)},
                         {"kind", "quickfix"},
                         {"isPreferred", finding.fix->safety == FixSafety::safe},
                         {"diagnostics", Json::array({diagnostic(finding, places)})},
                         {"edit", changes(batch, checked.sources, files, encoding_)}});
    }
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
    Buffers files(documents, surroundings_.disk);
    auto const checked = check(files, machine);
    FixBatch batch(checked.sources);
    for (auto const& finding : checked.findings) {
      bool const is_safe = finding.fix && finding.fix->safety == FixSafety::safe;
      if (is_safe && is_fixed_in(*finding.fix, checked.sources, files, fixed)) batch.add(*finding.fix);
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
  auto const aligned = validator::aligned_list(SourceText(unaligned.path, unaligned.text),
                                               surroundings_.options(unaligned.path).catalogue);
  return edits_between(unaligned.text, aligned, encoding_);
}

}  // namespace axisc::editor
