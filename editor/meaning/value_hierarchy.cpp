#include "editor/meaning/value_hierarchy.hpp"

#include "editor/meaning/parameter_number.hpp"
#include "editor/reading/open_list.hpp"
#include "editor/reading/places.hpp"
#include "editor/reading/requests.hpp"
#include "validator/loading/loader.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace axisc::editor::says {

constexpr Sentence value_in_file{"{value} in {file}", "{value} in {file}"};
constexpr Sentence value_by_default{"{value}, the default", "{value}, der Standardwert"};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

constexpr int property = 7;

}  // namespace

ValueHierarchy::ValueHierarchy(MachineReading& reading, Document const& asked, PositionEncoding encoding,
                               Language language)
    : reading_(reading), asked_(asked), encoding_(encoding), language_(language) {}

validator::LoadedList const* ValueHierarchy::list_of(std::string const& uri) const {
  auto const* const machine = reading_.machine();
  if (machine == nullptr) return nullptr;
  for (auto const* const lists : {&machine->lists, &machine->other_lists}) {
    auto const found = std::find_if(lists->begin(), lists->end(), [&](validator::NamedList const& named) {
      return reading_.files().uri(reading_.sources()[named.list.source].name()) == uri;
    });
    if (found != lists->end()) return &found->list;
  }
  return nullptr;
}

std::vector<ValueHierarchy::Line> ValueHierarchy::lines_in(validator::LoadedList const& list,
                                                           schema::Slot slot) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < list.tree.assignments.size(); ++i) {
    if (list.readings.slot(i) == slot) lines.push_back({.list = &list, .assignment = i});
  }
  return lines;
}

Json ValueHierarchy::items_at(std::size_t offset) const {
  auto items = Json::array();
  auto const& open = reading_.list(asked_);
  auto const* const list = list_of(asked_.uri);
  if (list == nullptr) return nullptr;
  auto const add = [&](schema::Slot slot) {
    auto const* const machine = reading_.machine();
    bool const is_of_axis = list->kind == schema::ListKind::axis && !list->is_default_list;
    for (auto const* const each : {is_of_axis ? machine->list_of_defaults() : nullptr, list}) {
      if (each == nullptr) continue;
      for (auto const& line : lines_in(*each, slot)) items.push_back(item_of(line));
    }
  };
  if (auto const number = parameter_number_at(asked_.text, offset)) {
    if (number->kind != open.catalogue().kind()) return nullptr;
    auto const& catalogue = open.catalogue();
    for (auto const id : catalogue.find_number(number->number)) {
      auto const& row = catalogue.parameter(id);
      for (std::uint32_t i = 0; i < row.slots; ++i) {
        add(static_cast<schema::Slot>(static_cast<std::uint32_t>(row.first_slot) + i));
      }
      if (!items.empty()) continue;
      Json const at = {{"uri", asked_.uri},
                       {"range", range_json(position_of(asked_.text, number->begin, encoding_),
                                            position_of(asked_.text, number->end, encoding_))}};
      auto item = default_item(row, std::string(row.name), at);
      if (!item.is_null()) items.push_back(std::move(item));
    }
    return items.empty() ? Json() : items;
  }
  auto const* const line = open.line_at(offset);
  if (line == nullptr || offset < line->name.begin || line->value.end < offset) return nullptr;
  for (std::size_t i = 0; i < list->tree.assignments.size(); ++i) {
    bool const is_here = list->tree.assignments[i].line == line->line;
    if (is_here && list->readings.slot(i)) items.push_back(item_of({.list = list, .assignment = i}));
  }
  return items.empty() ? Json() : items;
}

Json ValueHierarchy::item_of(Line const& line) const {
  auto const& source = reading_.sources()[line.list->source];
  auto const& assignment = line.list->tree.assignments[line.assignment];
  Places const places(reading_.sources(), reading_.files(), encoding_);
  Place const name{.source = line.list->source, .span = assignment.name};
  Place const whole{.source = line.list->source,
                    .span = {.begin = assignment.name.begin, .end = assignment.value.end}};
  auto const written = source.utf8(assignment.name);
  auto const detail = render({.sentence = says::value_in_file,
                              .arguments = {{"value", source.utf8(assignment.value)},
                                            {"file", std::string(validator::file_name(source.name()))}}},
                             language_);
  return {{"name", written},
          {"detail", detail},
          {"kind", property},
          {"uri", places.uri(name)},
          {"range", places.range(whole)},
          {"selectionRange", places.range(name)},
          {"data", {{"document", asked_.uri}, {"parameter", written}, {"default", false}}}};
}

Json ValueHierarchy::default_item(schema::Parameter const& row, std::string const& name,
                                  Json const& at) const {
  auto const value = validator::default_text(row);
  if (!row.has_default || value.empty()) return nullptr;
  return {
      {"name", name},
      {"detail", render({.sentence = says::value_by_default, .arguments = {{"value", value}}}, language_)},
      {"kind", property},
      {"uri", at.at("uri")},
      {"range", at.at("range")},
      {"selectionRange", at.at("range")},
      {"data", {{"document", asked_.uri}, {"parameter", name}, {"default", true}}}};
}

ValueHierarchy::Chain ValueHierarchy::chain_of(Json const& item, validator::LoadedList const& list,
                                               schema::Slot slot) const {
  Chain chain;
  auto const& machine = *reading_.machine();
  bool const is_default = item.at("data").at("default").get<bool>();
  auto const* const defaults = list.kind == schema::ListKind::axis ? machine.list_of_defaults() : nullptr;
  auto const add_all = [&](std::vector<Line>& to, validator::LoadedList const& from) {
    for (auto const& line : lines_in(from, slot)) to.push_back(line);
  };
  if (defaults != nullptr && &list != defaults) add_all(is_default ? chain.after : chain.before, *defaults);
  auto const begin = position_in(item.at("selectionRange").at("start"));
  Places const places(reading_.sources(), reading_.files(), encoding_);
  for (auto const& line : lines_in(list, slot)) {
    Place const name{.source = list.source, .span = list.tree.assignments[line.assignment].name};
    auto const at = position_in(places.range(name).at("start"));
    if (is_default || begin < at) chain.after.push_back(line);
    if (!is_default && at < begin) chain.before.push_back(line);
  }
  if (&list != defaults) return chain;
  for (auto const& named : machine.lists) {
    if (&named.list != defaults) add_all(chain.after, named.list);
  }
  return chain;
}

Json ValueHierarchy::overridden(Json const& item) const {
  auto items = Json::array();
  auto const* const list = list_of(item.at("uri").get<std::string>());
  auto const name = item.at("data").at("parameter").get<std::string>();
  if (list == nullptr || item.at("data").at("default").get<bool>()) return items;
  auto const found = list->catalogue.find(name);
  if (found.status != schema::NameLookup::Status::found) return items;
  for (auto const& line : chain_of(item, *list, found.slot).before) items.push_back(item_of(line));
  auto last = default_item(*found.row, name, {{"uri", item.at("uri")}, {"range", item.at("range")}});
  if (!last.is_null()) items.push_back(std::move(last));
  return items;
}

Json ValueHierarchy::overriding(Json const& item) const {
  auto items = Json::array();
  auto const* const list = list_of(item.at("uri").get<std::string>());
  if (list == nullptr) return items;
  auto const found = list->catalogue.find(item.at("data").at("parameter").get<std::string>());
  if (found.status != schema::NameLookup::Status::found) return items;
  for (auto const& line : chain_of(item, *list, found.slot).after) items.push_back(item_of(line));
  return items;
}

}  // namespace axisc::editor
