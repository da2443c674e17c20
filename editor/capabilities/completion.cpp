#include "editor/capabilities/completion.hpp"

#include "axisc/answers/explain/explain_answer.hpp"
#include "diagnostics/ascii.hpp"
#include "editor/capabilities/completion_items.hpp"
#include "editor/meaning/program_help.hpp"
#include "editor/reading/open_machines.hpp"
#include "presentation/writers.hpp"
#include "schema/descriptions/description.hpp"
#include "schema/indexed_name.hpp"

#include <algorithm>
#include <string_view>

namespace axisc::editor {

namespace {

bool continues_segment(char character) {
  return ascii::is_letter(character) || ascii::is_digit(character) || character == '[' || character == ']' ||
         character == '_';
}

Json complete_program(OpenMachines const& machines, OpenDocument const& asked, std::size_t offset) {
  auto const before = std::string_view(asked.text).substr(0, offset);
  auto const line = before.substr(before.find_last_of("\r\n") + 1);
  auto const word = line.find_last_of(" [=]\t") + 1;
  auto const first = line.rfind('#') == std::string_view::npos ? word : std::max(word, line.rfind('#'));
  CompletionItems items(machines.range(asked, offset - (line.size() - first), offset), machines.language(),
                        {});
  for (auto const& label : command_words(line)) items.add(label, ItemKind::property);
  return items.take();
}

}  // namespace

Json complete(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  bool const is_program = asked.path.ends_with(".nc");
  if (!is_program && !is_list(asked.path)) return Json::array();
  auto const offset = machines.offset(asked, params);
  if (is_program) return complete_program(machines, asked, offset);
  std::string_view const text = asked.text;
  auto begin = offset;
  while (begin > 0 && text[begin - 1] != '\n' && text[begin - 1] != '\r') --begin;
  while (begin < offset && ascii::is_blank(text[begin])) ++begin;
  auto const typed = text.substr(begin, offset - begin);
  if (typed.find_first_of("#(\"") != std::string_view::npos || typed.find("/*") != std::string_view::npos) {
    return Json::array();
  }
  auto const blank = typed.find_first_of(" \t");
  bool const is_value = blank != std::string_view::npos;
  auto end = offset;
  while (end < text.size() && (continues_segment(text[end]) || (is_value && text[end] == '-'))) ++end;
  auto const& list = machines.list_of(asked);
  auto const items_from = [&](std::size_t first) {
    return CompletionItems(machines.range(asked, begin + first, end), machines.language(),
                           machines.client().documents_lazily ? asked.uri : "");
  };
  if (!is_value) {
    auto items = items_from(typed.rfind('.') + 1);
    items.add_names(list, typed);
    return items.take();
  }
  auto const value = std::min(typed.find_first_not_of(" \t", blank), typed.size());
  auto const name = typed.substr(0, blank);
  bool const is_after_value = typed.find_first_of(" \t", value) != std::string_view::npos;
  if (is_after_value || !schema::split_name(name)) return Json::array();
  auto const found = list.find(name);
  if (found.row == nullptr) return Json::array();
  auto items = items_from(value);
  items.add_values(*found.row);
  auto const prefix = typed.substr(value);
  // Numbers are offered after two characters.
  if (prefix.size() >= 2) items.add_references(list.catalogue(), prefix);
  return items.take();
}

Json resolve_completion(OpenMachines& machines, Json const& params) {
  auto item = params;
  if (!params.is_object() || !params.contains("data")) return item;
  auto const& data = params["data"];
  auto const& catalogue = machines.list_of(machines.document(data.at("document"))).catalogue();
  auto const name = data.at("parameter").get<std::string>();
  auto const& rows = catalogue.parameters();
  auto const row =
      std::find_if(rows.begin(), rows.end(), [&name](auto const& known) { return known.name == name; });
  if (row == rows.end()) return item;
  if (machines.client().markdown_in_completion) {
    item["documentation"] = {
        {"kind", "markdown"},
        {"value", write(parameter_answer(catalogue, *row), presentation::Format::markdown,
                        {.language = machines.language()})}};
  } else {
    item["documentation"] = schema::description_of(*row).what.in(machines.language());
  }
  return item;
}

}  // namespace axisc::editor
