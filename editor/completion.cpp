#include "axisc/answers/explain/explain_answer.hpp"
#include "diagnostics/ascii.hpp"
#include "editor/meaning/program_help.hpp"
#include "editor/reading/open_list.hpp"
#include "editor/reading/places.hpp"
#include "editor/reading/requests.hpp"
#include "editor/server.hpp"
#include "presentation/writers.hpp"
#include "schema/descriptions/description.hpp"
#include "schema/indexed_name.hpp"
#include "schema/value.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

namespace axisc::editor::says {

constexpr Sentence usual{"default", "Standard"};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

enum class ItemKind : int { property = 10, module = 9, enumeration_member = 20, reference = 18 };

std::string_view bare(std::string_view segment) {
  return segment.substr(0, segment.find('['));
}

/// The indices that a list gives the names that begin with `prefix`, `filter[`.
std::set<std::uint32_t> used_indices(OpenList const& list, std::string_view prefix) {
  std::set<std::uint32_t> used;
  for (auto const& line : list.tree().assignments) {
    auto const name = list.slice(line.name);
    if (name.size() <= prefix.size() || !ascii::equal_ignoring_case(name.substr(0, prefix.size()), prefix)) {
      continue;
    }
    auto const part = schema::split_name(name.substr(0, name.find(']', prefix.size()) + 1));
    if (part && !part->parts.empty() && part->parts.back().index) used.insert(*part->parts.back().index);
  }
  return used;
}

/// What a parameter is, at an item of a completion: at once, or the name by which the client asks for it.
struct Documentation {
  std::string const& uri;
  Language language;
  bool is_asked_for;

  void add(Json& item, schema::Parameter const& row) const {
    auto const what = schema::description_of(row).what.in(language);
    if (what.empty()) return;
    if (is_asked_for) {
      item["data"] = {{"document", uri}, {"parameter", row.name}};
    } else {
      item["documentation"] = what;
    }
  }
};

class NameItems {
 public:
  NameItems(OpenList const& list, Documentation const& documentation, std::string_view typed)
      : list_(list), documentation_(documentation), before_(typed.substr(0, typed.rfind('.') + 1)) {}

  /// The segments that can follow what is typed.
  [[nodiscard]] Json items(Json const& range) {
    for (auto const& row : list_.catalogue().parameters()) add(row);
    auto items = Json::array();
    for (auto& [label, item] : items_) {
      item["label"] = label;
      item["textEdit"] = {{"range", range}, {"newText", label}};
      items.push_back(std::move(item));
    }
    return items;
  }

 private:
  void add(schema::Parameter const& row) {
    auto rest = row.name;
    std::size_t indices = 0;
    for (auto typed = before_; !typed.empty();) {
      auto const part = schema::take_part(rest);
      if (!ascii::equal_ignoring_case(bare(part), bare(schema::take_part(typed)))) return;
      if (part.ends_with(']')) ++indices;
    }
    if (rest.empty()) return;
    auto const part = schema::take_part(rest);
    if (!part.ends_with(']') || indices >= row.array.size()) {
      return add(row, std::string(bare(part)), rest.empty());
    }
    auto const begin = std::string(bare(part)) + "[";
    if (!known_arrays_.insert(begin).second) return;
    auto used = used_indices(list_, std::string(before_) + begin);
    std::uint32_t next = 0;
    while (used.contains(next)) ++next;
    used.insert(next);
    for (auto const index : used) {
      if (index < row.array.at(indices)) add(row, begin + std::to_string(index) + "]", rest.empty());
    }
  }
  void add(schema::Parameter const& row, std::string label, bool is_last) {
    auto& item = items_[std::move(label)];
    if (!item.is_null()) return;
    item["kind"] = static_cast<int>(is_last ? ItemKind::property : ItemKind::module);
    if (!is_last) return;
    std::string detail = row.p_axis == 0 ? "" : schema::number_text(row.kind, row.p_axis);
    auto const unit = validator::raw_unit_name(row.unit_translatory);
    if (!unit.empty()) detail += (detail.empty() ? "" : ", ") + unit;
    if (!detail.empty()) item["detail"] = std::move(detail);
    documentation_.add(item, row);
  }

  OpenList const& list_;
  Documentation const& documentation_;
  std::string_view before_;  ///< complete segments, with their dots
  std::map<std::string, Json> items_;
  std::set<std::string> known_arrays_;
};

Json value_items(schema::Parameter const& row, Language language, Json const& range) {
  auto items = Json::array();
  std::set<std::string> known;
  auto const standard = schema::default_value(row);
  auto const add = [&](std::string const& label, std::string detail, std::string_view meaning) {
    if (!known.insert(label).second) return;
    Json item = {{"label", label},
                 {"kind", static_cast<int>(ItemKind::enumeration_member)},
                 {"textEdit", {{"range", range}, {"newText", label}}}};
    if (!detail.empty()) item["detail"] = std::move(detail);
    if (!meaning.empty()) item["documentation"] = meaning;
    auto const number = schema::read_real(label);
    bool const is_number = number.status == schema::NumberStatus::good;
    if (standard && (is_number ? number.number == standard->number : label == standard->text)) {
      item["preselect"] = true;
    }
    items.push_back(std::move(item));
  };
  auto const description = schema::description_of(row);
  auto const meaning_of = [&](std::string const& value) {
    auto const found = std::find_if(description.values.begin(), description.values.end(),
                                    [&value](auto const& known_value) { return known_value.value == value; });
    return found == description.values.end() ? std::string_view() : found->meaning.in(language);
  };
  for (auto const& symbol : row.symbols) {
    auto const number = symbol.number ? std::to_string(*symbol.number) : "";
    auto const meaning = meaning_of(std::string(symbol.word));
    add(std::string(symbol.word), number, meaning.empty() ? meaning_of(number) : meaning);
  }
  for (auto const& name : row.number_names) {
    if (name.number) {
      add(std::to_string(*name.number), std::string(name.word), meaning_of(std::to_string(*name.number)));
    }
  }
  for (auto const& [value, meaning] : description.values) {
    bool const is_symbol =
        std::any_of(row.symbols.begin(), row.symbols.end(), [value = value](auto const& symbol) {
          return symbol.number && std::to_string(*symbol.number) == value;
        });
    if (!is_symbol) add(std::string(value), "", meaning.in(language));
  }
  if (row.has_default) {
    add(validator::default_text(row), render({.sentence = says::usual, .arguments = {}}, language), "");
  }
  return items;
}

/// `P-AXIS-00212`: the value of another parameter.
void add_references(Json& items, schema::Catalogue const& catalogue, std::string_view typed,
                    Json const& range, Documentation const& documentation) {
  for (auto const& row : catalogue.parameters()) {
    if (row.p_axis == 0) continue;
    auto const label = schema::number_text(row.kind, row.p_axis);
    if (!ascii::equal_ignoring_case(std::string_view(label).substr(0, typed.size()), typed)) continue;
    items.push_back({{"label", label},
                     {"kind", static_cast<int>(ItemKind::reference)},
                     {"detail", row.name},
                     {"textEdit", {{"range", range}, {"newText", label}}}});
    documentation.add(items.back(), row);
  }
}

bool continues_segment(char character) {
  return ascii::is_letter(character) || ascii::is_digit(character) || character == '[' || character == ']' ||
         character == '_';
}

}  // namespace

Json Server::complete(Json const& params) {
  auto const& asked = document(params);
  auto items = Json::array();
  std::string_view const text = asked.text;
  if (asked.path.ends_with(".nc")) {
    auto const at = offset_of(text, position_in(params.at("position")), encoding_);
    auto const before = text.substr(0, at);
    auto const line = before.substr(before.find_last_of("\r\n") + 1);
    auto const word = line.find_last_of(" [=]\t") + 1;
    auto const first = line.rfind('#') == std::string_view::npos ? word : std::max(word, line.rfind('#'));
    for (auto& label : command_words(line)) {
      auto const range = range_json(position_of(text, at - (line.size() - first), encoding_),
                                    position_of(text, at, encoding_));
      items.push_back({{"label", label},
                       {"kind", static_cast<int>(ItemKind::property)},
                       {"textEdit", {{"range", range}, {"newText", label}}}});
    }
    return items;
  }
  if (!is_list(asked.path)) return items;
  auto const offset = offset_of(text, position_in(params.at("position")), encoding_);
  auto begin = offset;
  while (begin > 0 && text[begin - 1] != '\n' && text[begin - 1] != '\r') --begin;
  while (begin < offset && ascii::is_blank(text[begin])) ++begin;
  auto const typed = text.substr(begin, offset - begin);
  if (typed.find_first_of("#(\"") != std::string_view::npos || typed.find("/*") != std::string_view::npos) {
    return items;
  }
  auto end = offset;
  bool const is_value = typed.find_first_of(" \t") != std::string_view::npos;
  while (end < text.size() && (continues_segment(text[end]) || (is_value && text[end] == '-'))) ++end;
  auto const range_from = [&](std::size_t first) {
    return range_json(position_of(text, first, encoding_), position_of(text, end, encoding_));
  };
  auto const& list = list_of(asked);
  Documentation const documentation{
      .uri = asked.uri, .language = surroundings_.language, .is_asked_for = documents_lazily_};
  auto const blank = typed.find_first_of(" \t");
  if (blank == std::string_view::npos) {
    return NameItems(list, documentation, typed).items(range_from(begin + typed.rfind('.') + 1));
  }
  auto const value = std::min(typed.find_first_not_of(" \t", blank), typed.size());
  if (typed.find_first_of(" \t", value) != std::string_view::npos) return items;
  auto const name = typed.substr(0, blank);
  if (!schema::split_name(name)) return items;
  auto const found = list.find(name);
  if (found.row == nullptr) return items;
  auto const range = range_from(begin + value);
  items = value_items(*found.row, surroundings_.language, range);
  auto const prefix = typed.substr(value);
  // Numbers are offered after two characters.
  if (prefix.size() >= 2) add_references(items, list.catalogue(), prefix, range, documentation);
  return items;
}

// The page that a hover shows; an item without a parameter is complete already.
Json Server::resolve_completion(Json const& params) {
  auto item = params;
  if (!params.is_object() || !params.contains("data")) return item;
  auto const& data = params["data"];
  auto const& asked = documents_.at(data.at("document").get<std::string>());
  auto const& catalogue = list_of(asked).catalogue();
  auto const name = data.at("parameter").get<std::string>();
  auto const& rows = catalogue.parameters();
  auto const row =
      std::find_if(rows.begin(), rows.end(), [&name](auto const& known) { return known.name == name; });
  if (row == rows.end()) return item;
  if (markdown_in_completion_) {
    item["documentation"] = {
        {"kind", "markdown"},
        {"value", write(parameter_answer(catalogue, *row), presentation::Format::markdown,
                        {.language = surroundings_.language})}};
  } else {
    item["documentation"] = schema::description_of(*row).what.in(surroundings_.language);
  }
  return item;
}

}  // namespace axisc::editor
