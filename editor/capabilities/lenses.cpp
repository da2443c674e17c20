#include "editor/capabilities/lenses.hpp"

#include "editor/capabilities/pages.hpp"
#include "editor/meaning/delay_notes.hpp"
#include "editor/reading/open_machines.hpp"
#include "schema/indexed_name.hpp"

#include <algorithm>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

bool is_of_cascade(std::string_view name) {
  auto const family = schema::take_part(name);
  return family.starts_with("filter[") || family == "filter_fir";
}

bool is_of_feedforward(std::string_view name) {
  return schema::take_part(name) == "vorsteuer";
}

/// The first line whose name is of a family; null if there is none.
grammar::Assignment const* first_line(OpenList const& list, bool (*is_of_family)(std::string_view)) {
  auto const& lines = list.tree().assignments;
  auto const found = std::find_if(lines.begin(), lines.end(), [&](grammar::Assignment const& line) {
    return is_of_family(list.slice(line.name));
  });
  return found == lines.end() ? nullptr : &*found;
}

PageSubject subject_of(OpenMachines& machines, OpenDocument const& document, Buffers& files) {
  auto const* const axis = is_list(document.path) ? machines.list_of(document).axis() : nullptr;
  return {.files = files,
          .machine = machines.machine_of(document),
          .axis = axis == nullptr ? std::nullopt : std::optional(axis->name),
          .words = {},
          .language = machines.language(),
          .options = machines.options()};
}

}  // namespace

Json lenses(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  auto found = Json::array();
  if (!is_list(asked.path)) return found;
  auto const& list = machines.list_of(asked);
  auto const range_of = [&](grammar::Assignment const& line) {
    return machines.range(asked, line.name.begin, line.name.end);
  };
  if (auto const* const line = first_line(list, is_of_cascade)) {
    found.push_back({{"range", range_of(*line)}, {"data", asked.uri}});
  }
  if (auto const* const line = first_line(list, is_of_feedforward)) {
    auto title = lead_line(list, machines.language());
    if (title.empty()) return found;
    found.push_back(
        {{"range", range_of(*line)},
         {"command",
          {{"title", std::move(title)}, {"command", "axisc.plot"}, {"arguments", {asked.uri, "delay"}}}}});
  }
  return found;
}

Json resolve_lens(OpenMachines& machines, Json const& params) {
  auto lens = params;
  auto const& asked = machines.document(params.at("data"));
  auto files = machines.buffers();
  lens["command"] = {{"title", cascade_line(subject_of(machines, asked, files))},
                     {"command", "axisc.plot"},
                     {"arguments", {asked.uri, "response"}}};
  return lens;
}

Json execute(OpenMachines& machines, Json const& params) {
  auto const name = params.at("command").get<std::string>();
  auto const commands = page_commands();
  auto const found = std::find_if(commands.begin(), commands.end(),
                                  [&name](PageCommand const& command) { return command.name == name; });
  if (found == commands.end()) throw std::invalid_argument("unknown command " + name);
  auto const& arguments = params.at("arguments");
  auto files = machines.buffers();
  auto subject = subject_of(machines, machines.document(arguments.at(0)), files);
  for (std::size_t i = 1; i < arguments.size(); ++i) subject.words.push_back(arguments[i].get<std::string>());
  auto page = found->page(subject);
  return {{"title", std::move(page.title)},
          {"html", std::move(page.html)},
          {"scripts", std::move(page.script_digests)}};
}

}  // namespace axisc::editor
