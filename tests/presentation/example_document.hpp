// A document with every kind of block and value, and with texts that try to break out of their places.
#pragma once

#include "presentation/document.hpp"

#include <limits>
#include <string>

namespace axisc::test {

namespace says {

inline constexpr Sentence title{"{machine}: how far `X` deviates", "{machine}: wie weit `X` abweicht"};
inline constexpr Sentence cycle_time{"NC cycle time", "NC-Zykluszeit"};
inline constexpr Sentence axes{"axes", "Achsen"};
inline constexpr Sentence synchronous{"equal delays", "gleiche Verzögerungen"};
inline constexpr Sentence kind{"type", "Typ"};
inline constexpr Sentence rotary{"rotary", "rotatorisch"};
inline constexpr Sentence channel{"channel {name}", "Kanal {name}"};
inline constexpr Sentence feed{"feed", "Vorschub"};
inline constexpr Sentence contour{"contour", "Kontur"};
inline constexpr Sentence error{"error {axis}", "Fehler {axis}"};
inline constexpr Sentence corner{"corner", "Ecke"};
inline constexpr Sentence share{"remaining vibration", "verbleibende Schwingung"};
inline constexpr Sentence readings{"readings", "Lesarten"};
inline constexpr Sentence largest{"largest error", "größter Fehler"};
inline constexpr Sentence limit{
    "an axis error of {tolerance} is kept at the corner up to {feed}, and every word of this sentence is "
    "there to see it "
    "wrapped",
    "ein Achsfehler von {tolerance} wird an der Ecke bis {feed} eingehalten, und jedes Wort dieses Satzes "
    "ist da, damit "
    "er umgebrochen wird"};
inline constexpr Sentence filters{"filters", "Filter"};
inline constexpr Sentence page{"page", "Seite"};
inline constexpr Sentence long_label{"largest gain of the chain", "größte Verstärkung der Kette"};
inline constexpr Sentence empty{"never shown", "nie zu sehen"};
inline constexpr Sentence zeros{"no gain at", "keine Verstärkung bei"};
inline constexpr Sentence remark{"remark", "Bemerkung"};

}  // namespace says

/// Rows that have more to tell, below a title that links lead to.
inline presentation::Section example_of_details() {
  using namespace presentation;
  Table filters{.key = "filters", .columns = {}, .rows = {}};
  for (int i = 0; i < 2; ++i) {
    std::string const name = "filter[" + std::to_string(i) + "]";
    std::vector<double> const zeros{12.5, 25, 37.5, 50, 62.5, 75, 87.5, 100};
    add_row(filters, {{"name", says::filters, Link{.text = name, .id = "page"}},
                      data("index", i),
                      {"gain", says::long_label, exact(1.25 * i)},
                      shown(says::long_label, exact(1.25 * i, Unit::decibel)),
                      {"unused", says::empty, Nothing{}},
                      {"zeros_hz", says::zeros, Numbers{.values = zeros, .unit = Unit::hertz}},
                      {"remark", says::remark,
                       Wording("a sentence that has room in this column on "
                               "several lines only, as it is the last one",
                               "ein Satz, der in dieser Spalte nur auf mehreren "
                               "Zeilen Platz hat, weil sie die letzte ist")}});
    Table sections{.key = "sections", .columns = {}, .rows = {}};
    add_row(sections, {{"b0", as_given("b0"), exact(0.5)}, {"a1", as_given("a1"), exact(-0.5)}});
    filters.details.push_back({.key = {},
                               .title = as_given(name),
                               .blocks = {Facts{{{"samples", says::kind, 32}}}, std::move(sections)}});
  }
  Prose const page{.key = "page",
                   .markdown = Wording("**Repair:** write `a < b`.\n\n```\nfilter[0].order 2\n```\n\n"
                                       "| case | reading |\n|---|---|\n| `0x` | 0 |\n",
                                       "**Abhilfe:** `a < b` schreiben.\n")};
  return {.key = "chain",
          .title = says::filters,
          .blocks = {std::move(filters),
                     Section{.key = {}, .title = says::page, .blocks = {page}, .id = "page"}}};
}

inline presentation::Document example_document() {
  using namespace presentation;
  std::string const hostile = "<b>a|b\"c,\x1b[31m";
  Table const errors{.key = "table",
                     .columns = {{.key = "feed_mm_per_min",
                                  .label = says::feed,
                                  .unit = Unit::millimetre_per_minute,
                                  .is_head = true},
                                 {.key = "contour", .label = says::contour, .is_head = true},
                                 {.key = "axis_error_um",
                                  .label = Words(says::error, {{"axis", "X"}}),
                                  .unit = Unit::micrometre,
                                  .member = "X"},
                                 {.key = "axis_error_um",
                                  .label = Words(says::error, {{"axis", hostile}}),
                                  .unit = Unit::micrometre,
                                  .member = hostile}},
                     .rows = {{Quantity{.value = 4000, .digits = Digits::exact()},
                               Symbol{.symbol = "corner", .words = says::corner},
                               Quantity{.value = 191.58149999, .digits = Digits::decimals(3)},
                               Quantity{.value = -0.0004, .digits = Digits::decimals(3)}},
                              {Quantity{.value = 12.5, .digits = Digits::exact()}, hostile, Nothing{},
                               Quantity{.value = std::numeric_limits<double>::infinity()}}},
                     .left_out = 3};
  Section channel{
      .key = {},
      .title = Words(says::channel, {{"name", "K1"}}),
      .blocks = {errors,
                 Paragraph{
                     Words(says::limit, {{"tolerance", Quantity{.value = 0.0015, .unit = Unit::millimetre}},
                                         {"feed", Quantity{.value = 1234.5,
                                                           .unit = Unit::millimetre_per_minute,
                                                           .digits = Digits::significant(6)}}})},
                 Verbatim{.key = "lines", .text = "filter[0].order 2\nfilter[0].guete 1.5\n"}},
      .identity = {data("group", "K1")}};
  return {
      .version = 2,
      .title = Words(says::title, {{"machine", hostile}}),
      .blocks =
          {Facts{
               {{.key = "cycle_time_us",
                 .label = says::cycle_time,
                 .value = Quantity{.value = 1000, .unit = Unit::microsecond, .digits = Digits::exact()}},
                {.key = "axes", .label = says::axes, .value = Names{"X", hostile}},
                {.key = "synchronous", .label = says::synchronous, .value = false},
                {.key = "type", .label = says::kind, .value = Symbol{.symbol = "R", .words = says::rotary}},
                {.key = "remaining_vibration", .label = says::share, .value = fixed(0.2468, Unit::share, 1)},
                {.key = "readings", .label = says::readings, .value = NameLists{{"a", "b"}, {}, {hostile}}},
                {.key = "filter", .label = says::kind, .value = Wording("low-pass", "Tiefpass")},
                {.key = "largest",
                 .label = says::largest,
                 .value = rounded(12.345, Unit::micrometre, 3),
                 .member = "X"},
                data("largest", exact(0.5), hostile),
                data("image_version", 7)}},
           data_section("first", {data("cycle", 3)}),
           Sections{.key = "groups", .items = {std::move(channel)}}, Sections{.key = "gantries", .items = {}},
           example_of_details()},
      .csv_table = "table"};
}

}  // namespace axisc::test
