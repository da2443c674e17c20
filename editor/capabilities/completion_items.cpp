#include "editor/capabilities/completion_items.hpp"

#include "diagnostics/ascii.hpp"
#include "schema/descriptions/description.hpp"
#include "schema/indexed_name.hpp"
#include "schema/value.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace axisc::editor::says {

constexpr Sentence usual{"default", "Standard"};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

std::string_view bare(std::string_view segment) {
  return segment.substr(0, segment.find('['));
}

/// The indices that a list uses after `prefix`, such as `filter[`.
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

/// Segments that can follow what is typed, each with the parameter whose name it completes, or null.
class Segments {
 public:
  Segments(OpenList const& list, std::string_view typed)
      : list_(list), before_(typed.substr(0, typed.rfind('.') + 1)) {
    for (auto const& row : list.catalogue().parameters()) add(row);
  }

  [[nodiscard]] std::map<std::string, schema::Parameter const*> const& found() const { return found_; }

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
    auto const* const ended = rest.empty() ? &row : nullptr;
    if (!part.ends_with(']') || indices >= row.array.size()) {
      found_.try_emplace(std::string(bare(part)), ended);
      return;
    }
    auto const begin = std::string(bare(part)) + "[";
    if (!known_arrays_.insert(begin).second) return;
    auto used = used_indices(list_, std::string(before_) + begin);
    std::uint32_t next = 0;
    while (used.contains(next)) ++next;
    used.insert(next);
    for (auto const index : used) {
      if (index < row.array.at(indices)) found_.try_emplace(begin + std::to_string(index) + "]", ended);
    }
  }

  OpenList const& list_;
  std::string_view before_;  ///< complete segments, with their dots
  std::map<std::string, schema::Parameter const*> found_;
  std::set<std::string> known_arrays_;
};

}  // namespace

Json& CompletionItems::add(std::string const& label, ItemKind kind) {
  items_.push_back({{"label", label},
                    {"kind", static_cast<int>(kind)},
                    {"textEdit", {{"range", range_}, {"newText", label}}}});
  return items_.back();
}

void CompletionItems::document(Json& item, schema::Parameter const& row) const {
  auto const what = schema::description_of(row).what.in(language_);
  if (what.empty()) return;
  if (uri_.empty()) {
    item["documentation"] = what;
  } else {
    item["data"] = {{"document", uri_}, {"parameter", row.name}};
  }
}

void CompletionItems::add_names(OpenList const& list, std::string_view typed) {
  Segments const segments(list, typed);
  for (auto const& [label, row] : segments.found()) {
    auto& item = add(label, row != nullptr ? ItemKind::property : ItemKind::module);
    if (row == nullptr) continue;
    std::string detail = row->p_axis == 0 ? "" : schema::number_text(row->kind, row->p_axis);
    auto const unit = validator::raw_unit_name(row->unit_translatory);
    if (!unit.empty()) detail += (detail.empty() ? "" : ", ") + unit;
    if (!detail.empty()) item["detail"] = std::move(detail);
    document(item, *row);
  }
}

void CompletionItems::add_values(schema::Parameter const& row) {
  std::set<std::string> known;
  auto const standard = schema::default_value(row);
  auto const add_value = [&](std::string const& label, std::string detail, std::string_view meaning) {
    if (!known.insert(label).second) return;
    auto& item = add(label, ItemKind::enumeration_member);
    if (!detail.empty()) item["detail"] = std::move(detail);
    if (!meaning.empty()) item["documentation"] = meaning;
    auto const number = schema::read_real(label);
    bool const is_number = number.status == schema::NumberStatus::good;
    if (standard && (is_number ? number.number == standard->number : label == standard->text)) {
      item["preselect"] = true;
    }
  };
  auto const description = schema::description_of(row);
  auto const meaning_of = [&](std::string const& value) {
    auto const found = std::find_if(description.values.begin(), description.values.end(),
                                    [&value](auto const& known_value) { return known_value.value == value; });
    return found == description.values.end() ? std::string_view() : found->meaning.in(language_);
  };
  for (auto const& symbol : row.symbols) {
    auto const number = symbol.number ? std::to_string(*symbol.number) : "";
    auto const meaning = meaning_of(std::string(symbol.word));
    add_value(std::string(symbol.word), number, meaning.empty() ? meaning_of(number) : meaning);
  }
  for (auto const& name : row.number_names) {
    if (!name.number) continue;
    auto const number = std::to_string(*name.number);
    add_value(number, std::string(name.word), meaning_of(number));
  }
  for (auto const& [value, meaning] : description.values) {
    bool const is_symbol =
        std::any_of(row.symbols.begin(), row.symbols.end(), [value = value](auto const& symbol) {
          return symbol.number && std::to_string(*symbol.number) == value;
        });
    if (!is_symbol) add_value(std::string(value), "", meaning.in(language_));
  }
  if (row.has_default) add_value(validator::default_text(row), say(says::usual, language_), "");
}

void CompletionItems::add_references(schema::Catalogue const& catalogue, std::string_view typed) {
  for (auto const& row : catalogue.parameters()) {
    if (row.p_axis == 0) continue;
    auto const label = schema::number_text(row.kind, row.p_axis);
    if (!ascii::equal_ignoring_case(std::string_view(label).substr(0, typed.size()), typed)) continue;
    auto& item = add(label, ItemKind::reference);
    item["detail"] = row.name;
    document(item, row);
  }
}

}  // namespace axisc::editor
