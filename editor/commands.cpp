#include "editor/reading/open_list.hpp"
#include "editor/server.hpp"
#include "schema/indexed_name.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

using Json = nlohmann::json;

bool is_of_cascade(std::string_view name) {
  auto const family = schema::take_part(name);
  return family.starts_with("filter[") || family == "filter_fir";
}

}  // namespace

Json Server::execute(Json const& params) {
  auto const name = params.at("command").get<std::string>();
  auto const commands = page_commands();
  auto const found = std::find_if(commands.begin(), commands.end(),
                                  [&name](PageCommand const& command) { return command.name == name; });
  if (found == commands.end()) throw std::invalid_argument("unknown command " + name);
  auto const& arguments = params.at("arguments");
  auto const& asked = documents_.at(arguments.at(0).get<std::string>());
  auto files = buffers();
  PageSubject subject{.files = files,
                      .machine = machine_of(asked),
                      .axis = axis_of(asked),
                      .words = {},
                      .language = surroundings_.language,
                      .options = surroundings_.options};
  for (std::size_t i = 1; i < arguments.size(); ++i) subject.words.push_back(arguments[i].get<std::string>());
  auto page = found->page(subject);
  return {{"title", std::move(page.title)},
          {"html", std::move(page.html)},
          {"scripts", std::move(page.script_digests)}};
}

std::optional<std::string> Server::axis_of(Document const& document) {
  if (!is_list(document.path)) return std::nullopt;
  auto const* const axis = list_of(document).axis();
  return axis == nullptr ? std::nullopt : std::optional(axis->name);
}

// What it says is computed where it is seen.
Json Server::lenses(Json const& params) {
  auto const& asked = document(params);
  auto lenses = Json::array();
  if (!is_list(asked.path)) return lenses;
  auto const& list = list_of(asked);
  auto const& lines = list.tree().assignments;
  auto const first = std::find_if(lines.begin(), lines.end(), [&list](grammar::Assignment const& line) {
    return is_of_cascade(list.slice(line.name));
  });
  if (first == lines.end()) return lenses;
  auto const begin = position_of(asked.text, first->name.begin, encoding_);
  auto const end = position_of(asked.text, first->name.end, encoding_);
  lenses.push_back({{"range",
                     {{"start", {{"line", begin.line}, {"character", begin.character}}},
                      {"end", {{"line", end.line}, {"character", end.character}}}}},
                    {"data", asked.uri}});
  return lenses;
}

Json Server::resolve_lens(Json const& params) {
  auto lens = params;
  auto const& asked = documents_.at(params.at("data").get<std::string>());
  auto files = buffers();
  lens["command"] = {{"title", cascade_line({.files = files,
                                             .machine = machine_of(asked),
                                             .axis = axis_of(asked),
                                             .words = {},
                                             .language = surroundings_.language,
                                             .options = surroundings_.options})},
                     {"command", "axisc.plot"},
                     {"arguments", {asked.uri, "response"}}};
  return lens;
}

}  // namespace axisc::editor
