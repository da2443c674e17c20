#include "lists/generator.hpp"

#include "lists/values.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace axisc::bench {
namespace {

constexpr std::size_t entries_per_list = 800;
constexpr std::size_t value_column = 34;
constexpr unsigned comment_percent = 30;
/// Of a hundred slots so many, by the type of their parameter.
constexpr std::array<unsigned, 4> wanted_percent = {0, 25, 8, 17};  // integer: the rest, real, boolean, text

struct Row {
  schema::Parameter const* parameter;
  schema::Slot slot;
};

std::size_t type_class(schema::Parameter const& parameter) {
  if (parameter.type == schema::DataType::boolean) return 2;
  if (parameter.type == schema::DataType::string || parameter.is_enumeration()) return 3;
  return parameter.type == schema::DataType::real64 ? 1 : 0;
}

using RowsByType = std::array<std::vector<Row>, wanted_percent.size()>;

RowsByType free_rows() {
  RowsByType rows;
  for (schema::Parameter const& parameter : schema::parameters()) {
    if (!is_free(parameter)) continue;
    for (std::uint16_t i = 0; i < parameter.slots; ++i) {
      auto const slot = static_cast<schema::Slot>(static_cast<unsigned>(parameter.first_slot) + i);
      rows[type_class(parameter)].push_back({.parameter = &parameter, .slot = slot});
    }
  }
  return rows;
}

/// Different ones for every list, in the order of the catalogue, as a list is written.
std::vector<Row> choose_rows(Random& random) {
  static RowsByType const rows = free_rows();
  std::vector<Row> chosen;
  for (std::size_t type = rows.size(); type-- > 0;) {
    std::vector<Row> pool = rows[type];
    std::size_t const wanted =
        type == 0 ? entries_per_list - chosen.size() : entries_per_list * wanted_percent[type] / 100;
    std::size_t const count = std::min(pool.size(), wanted);
    for (std::size_t i = 0; i < count; ++i) {
      std::swap(pool[i], pool[i + random.below(pool.size() - i)]);
      chosen.push_back(pool[i]);
    }
  }
  std::sort(chosen.begin(), chosen.end(), [](Row const& a, Row const& b) { return a.slot < b.slot; });
  return chosen;
}

/// Two filters, as axes have them. A band-stop always overshoots, which is worth a warning, so not every list
/// has one.
void add_filters(std::vector<Entry>& entries, bool bandstop, Random& random) {
  auto const add = [&entries](std::string name, std::string value, EntryKind kind) {
    entries.push_back({.name = std::move(name), .value = std::move(value), .kind = kind});
  };
  auto const number = [&random](std::size_t first, std::size_t count) {
    return std::to_string(first + random.below(count));
  };
  add("filter[0].enable", "1", EntryKind::boolean);
  add("filter[0].order", bandstop ? number(1, 3) : "2", EntryKind::integer);
  if (bandstop) {
    add("filter[0].prototype", "CRIT_DAMPING", EntryKind::text);
    add("filter[0].type", "BANDSTOP", EntryKind::text);
    add("filter[0].fg_f0", number(20, 60), EntryKind::real);
    add("filter[0].guete", number(2, 2), EntryKind::real);
  } else {
    add("filter[0].type", "PT2", EntryKind::text);
    add("filter[0].time_constant", number(2000, 30000), EntryKind::real);
  }
  add("filter[1].enable", "TRUE", EntryKind::boolean);
  add("filter[1].order", number(1, 6), EntryKind::integer);
  add("filter[1].prototype", "CRIT_DAMPING", EntryKind::text);
  add("filter[1].type", "LOWPASS", EntryKind::text);
  add("filter[1].fg_f0", number(60, 100), EntryKind::real);
}

void add_line(Entry const& entry, Random& random, std::string_view line_end, std::string& text) {
  constexpr std::array<std::string_view, 5> comments = {"( Vorgabe des Herstellers", "( [0.1 um]",
                                                        "( gemessen am Tisch )", "# siehe Datenblatt",
                                                        "( Wert fuer v_max"};
  text += entry.name;
  text.append(entry.name.size() < value_column ? value_column - entry.name.size() : 1, ' ');
  text += entry.value;
  bool const is_text = entry.kind == EntryKind::text;
  if (random.chance(comment_percent)) {
    // Behind a word only a parenthesis opens a comment.
    std::string_view const comment = comments[random.below(comments.size())];
    text += "   ";
    text += is_text && comment.front() == '#' ? comments.front() : comment;
  }
  text += line_end;
}

}  // namespace

GeneratedList generate_list(std::size_t number) {
  Random random(number * 2 + 1);
  GeneratedList list;
  for (Row const& row : choose_rows(random)) {
    list.entries.push_back(random_entry(*row.parameter, row.slot, random));
  }
  add_filters(list.entries, number % 4 == 0, random);
  std::string_view const line_end = number % 2 == 0 ? "\n" : "\r\n";
  auto const line = [&](std::string_view content) { (list.text += content) += line_end; };
  line("#**********************************************************************");
  line("# Achsliste " + std::to_string(number));
  for (std::size_t i = 0; i < list.entries.size(); ++i) {
    if (i % 12 == 0) line("");
    if (i % 12 == 0) line("# ---- Gruppe " + std::to_string(i / 12));
    if (i % 40 == 7) line("# die folgenden Werte gelten seit der Inbetriebnahme");
    add_line(list.entries[i], random, line_end, list.text);
  }
  line("Ende");
  return list;
}

std::vector<GeneratedList> generate_lists(std::size_t count) {
  std::vector<GeneratedList> lists;
  lists.reserve(count);
  for (std::size_t number = 0; number < count; ++number) lists.push_back(generate_list(number));
  return lists;
}

std::string with_mistakes(GeneratedList const& list) {
  constexpr std::array<std::string_view, 4> values = {" 1", " 99999999999999", " falsch", ""};
  std::string text;
  for (std::size_t i = 0; i < list.entries.size(); ++i) {
    std::string name = list.entries[i].name;
    if (i % values.size() == 0) std::swap(name[name.size() - 2], name[name.size() - 1]);
    text += name;
    text += values[i % values.size()];
    text += '\n';
  }
  return text;
}

}  // namespace axisc::bench
