// Lines that are read without the grammar say the same as with it.
#include "validator/values/list_reader.hpp"

#include "schema/catalogue.hpp"
#include "schema/parameter_row.hpp"
#include "support/catch.hpp"
#include "validator/same_lists.hpp"
#include "validator/values/line_value.hpp"

#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include <rapidcheck.h>

namespace {

using namespace axisc;

/// Only where a block of text follows a line is it read without the grammar, and only where as many bytes
/// stand before its value as numbers are read at once.
std::string with_room(std::string const& text) {
  return "# so that numbers may be read\n" + text + "\n" + std::string(70, '#') + "\n";
}

bool reads_alike_as_it_is(std::string const& text) {
  return tests::reads_as_by_the_grammar(SourceText("x.lis", text));
}

bool reads_alike(std::string const& text) {
  // A byte that is not UTF-8 makes the whole text windows-1252.
  return reads_alike_as_it_is(text) && reads_alike_as_it_is(with_room(text)) &&
         reads_alike_as_it_is(with_room(text) + "# \xE4\n");
}

rc::Gen<std::string> one_of(std::vector<std::string> const& texts) {
  return rc::gen::elementOf(texts);
}

/// Any number of pieces.
rc::Gen<std::string> joined(rc::Gen<std::string> const& piece) {
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(piece), [](auto const& pieces) {
    std::string text;
    for (std::string const& each : pieces) text += each;
    return text;
  });
}

/// A parameter of the catalogue and a value that it may have, or a name that is none.
std::string symbol_of(schema::Parameter const& parameter, std::size_t number) {
  if (parameter.symbols.empty()) return std::string(parameter.default_text);
  return std::string(parameter.symbols[number % parameter.symbols.size()].word);
}

rc::Gen<std::string> name() {
  auto const known =
      rc::gen::map(rc::gen::inRange<std::size_t>(0, schema::slot_count()),
                   [](std::size_t slot) { return schema::slot_name(static_cast<schema::Slot>(slot)); });
  auto const piece =
      one_of({"a", "b7", "_", "filter", "[", "]", "[0]", "[12]", ".", ".x", "9", "-", "P-", "\xE4"});
  auto const usual =
      one_of({"filter[0].order", "filter[0].type", "filter[0].fg_f0", "kopf.achs_nr", "kopf.log_achs_name",
              "filter[00].order", "filter[0]].order", "Filter[0].order", "ende", "Ende", "ENDE"});
  return rc::gen::weightedOneOf<std::string>({{6, known}, {3, usual}, {1, joined(piece)}});
}

rc::Gen<std::string> value() {
  auto const usual = one_of({"1",
                             "0",
                             "007",
                             "-5",
                             "+5",
                             "+",
                             "-",
                             "0x1F",
                             "0x",
                             "-0x1",
                             "0xG",
                             "1.5",
                             ".5",
                             "5.",
                             ".",
                             "-.5",
                             "00.5",
                             "1e5",
                             "1e+5",
                             "1e",
                             "1.e5",
                             "e5",
                             "1.5e-3",
                             "1e5x",
                             "1.2.3",
                             "1,8",
                             "LOWPASS",
                             "TRUE",
                             "P-AXIS-00212",
                             "P-AXIS-00212.0",
                             "P_1",
                             "\"quoted text\"",
                             "\"open",
                             "wo(rt",
                             "w\xC3\xA4",
                             "a\"b",
                             "%x",
                             "/path",
                             "/*",
                             "(",
                             "#",
                             "12abc",
                             "0X7f",
                             "1E5"});
  auto const piece =
      one_of({"1", "0", "7", ".", "e", "E", "x", "+", "-", "a", "F", "(", "\"", "\xC3\xA4", "/"});
  return rc::gen::oneOf(usual, joined(piece));
}

rc::Gen<std::string> trailer() {
  return one_of(
      {"", "", "( Kommentar", "(geschlossen) mehr", "# Zahl", "/* Stern */", "/ Strich", "5",
       "text \"mit\" (Quote", "( l\xE4nger", "( l\xC3\xA4nger", "( \xC2\x85", "( \x81",
       "( axisc: allow AX3005", "\x01",
       "( so lang, dass der Kommentar gewiss bis weit hinter das Ende eines Blocks reicht \xC3\xBC \"",
       "ohne Klammer, aber so lang, dass er gewiss bis weit hinter das Ende eines Blocks reicht (jetzt"});
}

/// A parameter with one of its words or its default; else a name with any value.
rc::Gen<std::string> name_and_value() {
  auto const blanks = one_of({" ", "\t", "  ", "          ", std::string(40, ' '), std::string(60, ' '), ""});
  auto const fitting = rc::gen::map(rc::gen::tuple(rc::gen::inRange<std::size_t>(0, schema::slot_count()),
                                                   rc::gen::inRange<std::size_t>(0, 40), blanks),
                                    [](auto const& parts) {
                                      auto const& [number, symbol, gap] = parts;
                                      auto const slot = static_cast<schema::Slot>(number);
                                      return schema::slot_name(slot) + gap +
                                             symbol_of(schema::parameter(schema::parameter_of(slot)), symbol);
                                    });
  auto const any = rc::gen::map(rc::gen::tuple(name(), blanks, value()), [](auto const& parts) {
    return std::get<0>(parts) + std::get<1>(parts) + std::get<2>(parts);
  });
  return rc::gen::oneOf(fitting, any);
}

rc::Gen<std::string> line() {
  auto const blanks = one_of({" ", "\t", "  ", "          ", std::string(40, ' '), std::string(60, ' '), ""});
  auto const line_end = one_of({"\n", "\n", "\n", "\r\n", "\r\n", " \n", "\t \r\n", "\r\r\n", "\r", ""});
  return rc::gen::map(rc::gen::tuple(one_of({"", "", "", " ", "\t", "#", "( "}), name_and_value(), blanks,
                                     trailer(), line_end),
                      [](auto const& parts) {
                        return std::apply([](auto const&... part) { return (std::string() + ... + part); },
                                          parts);
                      });
}

TEST_CASE("lines are read as the grammar reads them") {
  REQUIRE(rc::check("lines of all kinds", [] {
    std::string text;
    for (std::string const& each : *rc::gen::container<std::vector<std::string>>(line())) text += each;
    RC_ASSERT(reads_alike(text));
  }));
  REQUIRE(rc::check("any bytes", [](std::string const& text) { RC_ASSERT(reads_alike(text)); }));
}

TEST_CASE("every parameter takes every kind of value alike") {
  for (std::size_t i = 0; i < schema::slot_count(); ++i) {
    auto const slot = static_cast<schema::Slot>(i);
    schema::Parameter const& parameter = schema::parameter(schema::parameter_of(slot));
    std::string const name = schema::slot_name(slot);
    std::string text;
    for (std::string const value :
         {"0", "1", "-1", "2", "007", "1.5", "-0.25e+03", "0x1F", "0xFFFFFFFFFFFFFFFF", "99999999",
          "-99999999", "4294967296", "TRUE", "false", "X_Achse", "w\"x", "P-AXIS-00212", "%"}) {
      for (std::string const behind : {"", " ( a", " # a", " /* a", " a"}) {
        text.append(name).append(" ").append(value).append(behind).append("\n");
      }
    }
    for (schema::Symbol const& symbol : parameter.symbols) {
      for (std::string const behind : {"", " ( a", "(a", " # a", " a"}) {
        text.append(name).append(" ").append(symbol.word).append(behind).append("\n");
      }
    }
    if (!reads_alike_as_it_is(with_room(text))) FAIL(name);
  }
}

TEST_CASE("numbers at the ends of their ranges are read alike") {
  for (schema::Parameter const& parameter : schema::parameters()) {
    std::string text;
    for (schema::Limit const& limit : {parameter.minimum, parameter.maximum}) {
      for (double const step : {-1.0, -0.001, 0.0, 0.001, 1.0}) {
        std::string const name = schema::slot_name(parameter, parameter.first_slot);
        text += name + " " + std::to_string(limit.number + step) + "\n";
        constexpr double largest = 9e18;  // that a whole number takes
        auto const whole = static_cast<long long>(std::clamp(limit.number + step, -largest, largest));
        text += name + " " + std::to_string(whole) + "\n";
      }
    }
    if (!reads_alike_as_it_is(with_room(text))) FAIL(parameter.name);
  }
}

TEST_CASE("every place of a token in its block reads alike") {
  for (std::size_t room = 0; room < 80; ++room) {
    std::string const blanks(room, ' ');
    CHECK(reads_alike("kopf.achs_nr" + blanks + " 1 ( b"));
    CHECK(reads_alike(blanks + "filter[0].fg_f0 20.5 text (b"));
    CHECK(reads_alike(blanks + "filter[0].order 0x1F" + blanks + "\"q\" # b"));
    CHECK(reads_alike("filter[0].order 1e5" + blanks + "\r\nkopf.achs_nr 1\n" + blanks + "\r\n" + blanks +
                      "# b"));
    CHECK(reads_alike(std::string(room + 1, 'a') + " WORD(b"));
    CHECK(reads_alike("kopf.achs_nr " + std::string(room + 1, '1')));
    CHECK(reads_alike("filter[0].type LOWPASS" + blanks + "( b\nfilter[0].type" + blanks + "LOWPASS"));
  }
}

TEST_CASE("directives read alike near the end of the text and far from it") {
  for (std::size_t room = 0; room < 140; ++room) {
    CHECK(reads_alike_as_it_is(
        "# axisc: allow AX3005\nkopf.achs_nr 1\nfilter[0].order 2 ( axisc: allow AX3005\n" +
        std::string(room, '#')));
    CHECK(reads_alike_as_it_is("kopf.achs_nr 1\n\nfilter[0].order 2\n#" + std::string(room, ' ') +
                               "axisc: allow AX3005\n# x\nfilter[1].order 3"));
  }
}

TEST_CASE("many lines in a row read alike") {
  for (std::size_t const count : {31U, 32U, 33U, 64U, 65U, 255U, 256U, 257U, 600U}) {
    for (std::string const between : {"", "\n", "# b\n", "\n\n\n\n\n"}) {
      std::string text;
      for (std::size_t i = 0; i < count; ++i) text += between + "filter[0].order " + std::to_string(i) + "\n";
      CHECK(validator::read_list(SourceText("x.lis", with_room(text))).tree.assignments.size() == count);
      CHECK(reads_alike(text));
      CHECK(reads_alike(text + "a 1 # axisc: allow AX3005\nb 2\n" + text));
      CHECK(reads_alike(text + "Ende\nb 2\n" + text));
      CHECK(reads_alike(text + "kopf.achs_nr[ 1\nb 2\n" + text));
    }
  }
}

TEST_CASE("what stands far behind reads alike") {
  for (std::string const piece :
       {"(", "\"", "\x01", "\t", "\xC2\x85", "\xC3\xA4", "\x81", "\r", "\xE2\x82\xAC", ":"}) {
    for (std::size_t place = 0; place < 300; ++place) {
      std::string const text = std::string(place, 'x') + piece + std::string(200, 'y') + "\n";
      if (!reads_alike("kopf.achs_nr 1 " + text) || !reads_alike("filter[0].type LOWPASS (" + text) ||
          !reads_alike("kopf.log_achs_name " + text) || !reads_alike("# " + text)) {
        CAPTURE(piece, place);
        CHECK(false);
      }
    }
  }
}

TEST_CASE("rows of schema files read alike") {
  schema::ParameterRow changed =
      schema::ParameterRow::from(schema::parameter(schema::find("kopf.achs_nr").parameter));
  changed.type = schema::DataType::real64;
  changed.minimum = {.number = 0.5, .p_axis = 0, .kind = schema::Limit::Kind::number, .open = true};
  schema::ParameterRow added;
  added.name = "own[].words";
  added.type = schema::DataType::string;
  added.array = {3, 0};
  added.symbols = {{"ONE", 1}, {"TWO", std::nullopt}};
  schema::ParameterRow larger =
      schema::ParameterRow::from(schema::parameter(schema::find("filter[0].order").parameter));
  larger.array = {12, 0};
  schema::ParameterRow direction;
  direction.name = "own.direction";
  direction.type = schema::DataType::boolean;
  direction.symbols = {{"FALSE", 0}, {"TRUE", 1}, {"LEFT", 0}, {"RIGHT", 1}};
  schema::Catalogue const catalogue = schema::Catalogue().with({changed, added, larger, direction});
  std::string text;
  for (std::string const name : {"kopf.achs_nr", "own[0].words", "own[00].words", "own[2].words",
                                 "own[3].words", "own[1]].words", "own[1].words.", "filter[0].order",
                                 "filter[11].order", "filter[12].order", "filter[1].type", "own.direction"}) {
    for (std::string const value : {"0.5", "0.6", "1", "7", "ONE", "TWO", "one", "LOWPASS", "TRUE # a",
                                    "LEFT", "LEFT # a", "RIGHT ( a", "left"}) {
      text.append(name).append(" ").append(value).append("\n");
    }
  }
  CHECK(tests::reads_as_by_the_grammar(SourceText("x.lis", with_room(text)), catalogue));
}

}  // namespace
