#include "schema/lookup/lookup.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace axisc::schema::says {

constexpr Sentence list_reader{"reading of the lists", "Einlesen der Listen"};
constexpr Sentence start_up{"start-up", "Hochlauf"};
constexpr Sentence decoder{"NC decoder", "NC-Decoder"};
constexpr Sentence path_interpolator{"path interpolator", "Bahninterpolator"};
constexpr Sentence spindle_interpolator{"spindle interpolator", "Spindelinterpolator"};
constexpr Sentence position_controller{"position controller", "Lageregler"};
constexpr Sentence axis_management{"axis management", "Achsverwaltung"};
constexpr Sentence path_preparation{"path preparation", "Bahnvorbereitung"};

}  // namespace axisc::schema::says

namespace axisc::schema {
namespace {

#include "lookup_tables.inc"

struct ReporterRow {
  std::uint32_t first = 0, last = 0;
  SentenceRef name;
};

constexpr std::array reporters = {
    ReporterRow{2000, 2999, says::list_reader},
    ReporterRow{1000, 19999, says::start_up},
    ReporterRow{20000, 29999, says::decoder},
    ReporterRow{50000, 59999, says::path_interpolator},
    ReporterRow{60000, 69999, says::spindle_interpolator},
    ReporterRow{70000, 79999, says::position_controller},
    ReporterRow{110000, 119999, says::axis_management},
    ReporterRow{120000, 129999, says::path_preparation},
    ReporterRow{1001000, 1001999, says::list_reader},
};

}  // namespace

std::span<ControlMessage const> control_messages() {
  return message_table;
}

ControlMessage const* find_control_message(std::uint32_t number) {
  auto const has = [number](ControlMessage const& row) {
    return std::find(row.numbers.begin(), row.numbers.end(), number) != row.numbers.end();
  };
  auto const* const found = std::find_if(std::begin(message_table), std::end(message_table), has);
  return found == std::end(message_table) ? nullptr : found;
}

std::optional<SentenceRef> reporter_of(std::uint32_t number) {
  for (auto const& row : reporters) {
    if (number >= row.first && number <= row.last) return row.name;
  }
  return std::nullopt;
}

std::span<Topic const> topics() {
  return topic_table;
}

Topic const* find_topic(std::string_view name) {
  auto const* const found =
      std::find_if(std::begin(topic_table), std::end(topic_table),
                   [name](Topic const& row) { return ascii::equal_ignoring_case(row.name, name); });
  return found == std::end(topic_table) ? nullptr : found;
}

std::span<Synonyms const> synonyms() {
  return synonym_table;
}

SearchWords const& search_words() {
  return search_word_table;
}

}  // namespace axisc::schema
