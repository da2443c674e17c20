#include "editor/capabilities/formatting.hpp"

#include "editor/reading/open_machines.hpp"
#include "editor/reading/places.hpp"
#include "validator/list_layout.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

std::string aligned(OpenMachines const& machines, OpenDocument const& document) {
  return validator::aligned_list(SourceText(document.path, document.text),
                                 machines.options()(document.path).catalogue);
}

}  // namespace

Json format(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  // The layout of other files is up to their authors.
  if (!is_list(asked.path)) return Json::array();
  return edits_between(asked.text, aligned(machines, asked), machines.encoding());
}

Json format_range(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  if (!is_list(asked.path)) return Json::array();
  auto const whole = aligned(machines, asked);
  TextLines const before(asked.text, machines.encoding());
  TextLines const after(whole, machines.encoding());
  auto const first = position_in(params.at("range").at("start")).line;
  auto const last = position_in(params.at("range").at("end"));
  // A range that ends at the beginning of a line does not include that line.
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

}  // namespace axisc::editor
