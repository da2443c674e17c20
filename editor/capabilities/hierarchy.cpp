#include "editor/capabilities/hierarchy.hpp"

#include "editor/meaning/parameter_number.hpp"
#include "editor/reading/open_machines.hpp"
#include "editor/reading/places.hpp"
#include "validator/loading/loader.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::editor::says {

constexpr Sentence value_in_file{"{value} in {file}", "{value} in {file}"};
constexpr Sentence value_by_default{"{value}, the default", "{value}, der Standardwert"};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

using validator::LoadedList;

constexpr int property_symbol = 7;

struct Line {
  LoadedList const* list;
  std::size_t assignment;

  [[nodiscard]] Place name() const { return place(list->tree.assignments[assignment].name); }
  [[nodiscard]] Place place(Span span) const { return {.source = list->source, .span = span}; }
};

std::vector<Line> lines_in(LoadedList const& list, schema::Slot slot) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < list.tree.assignments.size(); ++i) {
    if (list.line_values.slot(i) == slot) lines.push_back({.list = &list, .assignment = i});
  }
  return lines;
}

/// The lines that set a parameter, as items: each overrides the default and the lines read before it.
class ValueHierarchy {
 public:
  /// `asked` is the document that the request came from. Both outlive this object.
  ValueHierarchy(OpenMachines& machines, OpenDocument const& asked)
      : machines_(machines),
        asked_(asked),
        reading_(machines.reading_of(asked)),
        places_(reading_.sources(), reading_.files(), machines.encoding()) {}

  /// The lines that set a parameter for the document, or its default if there are none: the parameter at a
  /// byte, or the one whose number a reference or comment there names.
  [[nodiscard]] Json items_at(std::size_t offset) const {
    auto items = Json::array();
    auto const* const list = list_of(asked_.uri);
    if (list == nullptr) return nullptr;
    auto const& open = reading_.list(asked_);
    if (auto const number = parameter_number_at(asked_.text, offset)) {
      auto const& catalogue = open.catalogue();
      if (number->kind != catalogue.kind()) return nullptr;
      for (auto const id : catalogue.find_number(number->number)) {
        auto const& row = catalogue.parameter(id);
        for (std::uint32_t i = 0; i < row.slots; ++i) {
          add_all(items, *list, static_cast<schema::Slot>(static_cast<std::uint32_t>(row.first_slot) + i));
        }
        if (!items.empty()) continue;
        add_default(items, row, std::string(row.name), asked_.uri,
                    machines_.range(asked_, number->begin, number->end));
      }
    } else {
      auto const* const line = open.line_at(offset);
      if (line == nullptr || offset < line->name.begin || line->value.end < offset) return nullptr;
      for (std::size_t i = 0; i < list->tree.assignments.size(); ++i) {
        bool const is_here = list->tree.assignments[i].line == line->line;
        if (is_here && list->line_values.slot(i)) items.push_back(item_of({.list = list, .assignment = i}));
      }
    }
    return items.empty() ? Json() : items;
  }

  /// The lines that an item overrides, in the order in which the control reads them; the default is last.
  [[nodiscard]] Json overridden(Json const& item) const {
    auto items = Json::array();
    auto const* const list = list_of(item.at("uri").get<std::string>());
    auto const name = item.at("data").at("parameter").get<std::string>();
    if (list == nullptr || item.at("data").at("default").get<bool>()) return items;
    auto const found = list->catalogue.find(name);
    if (found.status != schema::NameLookup::Status::found) return items;
    for (auto const& line : chain_of(item, *list, found.slot).before) items.push_back(item_of(line));
    add_default(items, *found.row, name, item.at("uri"), item.at("range"));
    return items;
  }

  /// The lines that override an item, in that order; for a default list, lines of all axes.
  [[nodiscard]] Json overriding(Json const& item) const {
    auto items = Json::array();
    auto const* const list = list_of(item.at("uri").get<std::string>());
    if (list == nullptr) return items;
    auto const found = list->catalogue.find(item.at("data").at("parameter").get<std::string>());
    if (found.status != schema::NameLookup::Status::found) return items;
    for (auto const& line : chain_of(item, *list, found.slot).after) items.push_back(item_of(line));
    return items;
  }

 private:
  struct Chain {
    std::vector<Line> before;  ///< the control reads these first
    std::vector<Line> after;
  };

  [[nodiscard]] LoadedList const* list_of(std::string const& uri) const {
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

  /// Null for lists that have no default list.
  [[nodiscard]] LoadedList const* defaults_of(LoadedList const& list) const {
    return list.kind == schema::ListKind::axis ? reading_.machine()->list_of_defaults() : nullptr;
  }

  [[nodiscard]] Chain chain_of(Json const& item, LoadedList const& list, schema::Slot slot) const {
    Chain chain;
    bool const is_default = item.at("data").at("default").get<bool>();
    auto const* const defaults = defaults_of(list);
    auto const add = [slot](std::vector<Line>& lines, LoadedList const& from) {
      for (auto const& line : lines_in(from, slot)) lines.push_back(line);
    };
    if (defaults != nullptr && &list != defaults) add(is_default ? chain.after : chain.before, *defaults);
    auto const begin = position_in(item.at("selectionRange").at("start"));
    for (auto const& line : lines_in(list, slot)) {
      auto const at = position_in(places_.range(line.name()).at("start"));
      if (is_default || begin < at) chain.after.push_back(line);
      if (!is_default && at < begin) chain.before.push_back(line);
    }
    if (&list != defaults) return chain;
    for (auto const& named : reading_.machine()->lists) {
      if (&named.list != defaults) add(chain.after, named.list);
    }
    return chain;
  }

  [[nodiscard]] Json item_of(Line const& line) const {
    auto const& source = reading_.sources()[line.list->source];
    auto const& assignment = line.list->tree.assignments[line.assignment];
    auto const written = source.utf8(assignment.name);
    auto const detail =
        machines_.say(says::value_in_file, {{"value", source.utf8(assignment.value)},
                                            {"file", std::string(validator::file_name(source.name()))}});
    Span const whole{.begin = assignment.name.begin, .end = assignment.value.end};
    return {{"name", written},
            {"detail", detail},
            {"kind", property_symbol},
            {"uri", places_.uri(line.name())},
            {"range", places_.range(line.place(whole))},
            {"selectionRange", places_.range(line.name())},
            {"data", {{"document", asked_.uri}, {"parameter", written}, {"default", false}}}};
  }

  void add_all(Json& items, LoadedList const& list, schema::Slot slot) const {
    auto const* const defaults = list.is_default_list ? nullptr : defaults_of(list);
    for (auto const* const each : {defaults, &list}) {
      if (each == nullptr) continue;
      for (auto const& line : lines_in(*each, slot)) items.push_back(item_of(line));
    }
  }

  /// Nothing for a parameter without a default.
  void add_default(Json& items, schema::Parameter const& row, std::string const& name, Json const& uri,
                   Json const& range) const {
    auto const value = validator::default_text(row);
    if (!row.has_default || value.empty()) return;
    items.push_back({{"name", name},
                     {"detail", machines_.say(says::value_by_default, {{"value", value}})},
                     {"kind", property_symbol},
                     {"uri", uri},
                     {"range", range},
                     {"selectionRange", range},
                     {"data", {{"document", asked_.uri}, {"parameter", name}, {"default", true}}}});
  }

  OpenMachines& machines_;
  OpenDocument const& asked_;
  MachineReading& reading_;
  Places places_;
};

/// For the document that the item was requested from.
ValueHierarchy hierarchy_of(OpenMachines& machines, Json const& item) {
  return {machines, machines.document(item.at("data").at("document"))};
}

}  // namespace

Json prepare_hierarchy(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  if (!is_list(asked.path)) return nullptr;
  return ValueHierarchy(machines, asked).items_at(machines.offset(asked, params));
}

Json supertypes(OpenMachines& machines, Json const& params) {
  auto const& item = params.at("item");
  return hierarchy_of(machines, item).overridden(item);
}

Json subtypes(OpenMachines& machines, Json const& params) {
  auto const& item = params.at("item");
  return hierarchy_of(machines, item).overriding(item);
}

}  // namespace axisc::editor
