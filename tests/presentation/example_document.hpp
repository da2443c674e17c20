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

}  // namespace says

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
           Sections{.key = "groups", .items = {std::move(channel)}},
           Sections{.key = "gantries", .items = {}}},
      .csv_table = "table"};
}

}  // namespace axisc::test
