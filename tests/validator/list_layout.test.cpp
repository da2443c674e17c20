#include "validator/list_layout.hpp"

#include "grammar/axis_list.hpp"
#include "support/catch.hpp"
#include "support/random_lists.hpp"
#include "validator/values/line_value.hpp"
#include "validator/values/list_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace axisc;

std::string aligned(std::string const& list) {
  return validator::aligned_list(SourceText("x.lis", list));
}

/// Everything an assignment says, without the blanks between its parts.
std::vector<std::string> meaning(std::string const& list) {
  SourceText const source("x.lis", list);
  auto const [tree, readings] = validator::read_list(source);
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    auto const& assignment = tree.assignments[i];
    auto const reading = readings[i];
    for (Span const span : {assignment.name, assignment.value, reading.text, reading.trouble}) {
      parts.emplace_back(source.slice(span));
    }
    // Behind a free string the blanks before the `(` are nobody's.
    std::string trailer(source.slice(assignment.trailer));
    std::erase(trailer, ' ');
    parts.push_back(trailer);
    parts.push_back(std::string(reading.value.text) + ' ' + std::to_string(reading.value.number) + ' ' +
                    std::to_string(static_cast<int>(reading.status)) + ' ' + std::to_string(assignment.line));
  }
  for (auto const& problem : tree.problems) {
    parts.push_back(std::to_string(problem.line) + ' ' + std::string(source.slice(problem.span)));
  }
  return parts;
}

/// What each line gives its parameter, or why it gives none.
std::vector<std::string> effect(std::string const& list) {
  SourceText const source("x.lis", list);
  auto const [tree, readings] = validator::read_list(source);
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    auto const reading = readings[i];
    std::string line = std::to_string(tree.assignments[i].line) + ' ' +
                       std::string(source.slice(tree.assignments[i].name)) + ' ' +
                       std::string(reading.value.text);
    for (double const number :
         {reading.value.number, static_cast<double>(reading.status), static_cast<double>(reading.number),
          static_cast<double>(reading.name_status), static_cast<double>(reading.symbol_folded),
          static_cast<double>(reading.quoted), static_cast<double>(reading.reference.p_axis),
          static_cast<double>(reading.reference.index)}) {
      line += ' ' + std::to_string(number);
    }
    lines.push_back(line + ' ' + std::string(source.slice(reading.trouble)));
  }
  for (auto const& problem : tree.problems) {
    lines.push_back(std::to_string(problem.line) + ' ' + std::string(source.slice(problem.span)));
  }
  return lines;
}

/// Some bytes are lost, come twice, or become others that mean something.
std::string mutated(std::string list, std::uint32_t seed) {
  constexpr std::string_view meaningful = " \t(#/*\".,+-0123456789xXeEP[]=|:\r\n\xE4";
  std::mt19937 random(seed);
  for (std::size_t count = 1 + random() % 12; count > 0 && !list.empty(); --count) {
    std::size_t const place = random() % list.size();
    char const byte = meaningful[random() % meaningful.size()];
    switch (random() % 3) {
      case 0: list.erase(place, 1); break;
      case 1: list.insert(place, 1, byte); break;
      default: list[place] = byte; break;
    }
  }
  return list;
}

}  // namespace

TEST_CASE("values and comments of a paragraph stand in columns") {
  CHECK(aligned("kopf.achs_nr 1\n"
                "filter[0].type   LOWPASS(tief\n"
                "filter[0].fg_f0\t20.5 # Hz  \n"
                "\n"
                "# alone\n"
                "a.b 1\n"
                "\tfilter[0].order 2   \n"
                "Ende\n") ==
        "kopf.achs_nr     1\n"
        "filter[0].type   LOWPASS  (tief\n"
        "filter[0].fg_f0  20.5     # Hz\n"
        "\n"
        "# alone\n"
        "a.b                      1\n"
        "\tfilter[0].order  2\n"
        "Ende\n");
}

TEST_CASE("a list with one column for all values keeps it") {
  std::string list;
  for (int i = 0; i < 6; ++i) {
    list +=
        "kopf.achs_nr                              1               ( number\n\n"
        "getriebe[0].dynamik.vb_max                500000          ( speed\n";
  }
  CHECK(aligned(list) == list);
  std::string const added =
      list + "kenngr.achs_typ 1 ( type\nantr.a_very_long_name.that_does_not_fit_here 2 ( long\n";
  CHECK(aligned(added) == list +
                              "kenngr.achs_typ                           1               ( type\n"
                              "antr.a_very_long_name.that_does_not_fit_here 2            ( long\n");
}

TEST_CASE("what only the control can take apart keeps its line") {
  std::string const list =
      "kopf.log_achs_name  X  Achse # x\n\nfilter[0].type  LOWPASS   # low\n\nkopf.hugo  1   # unknown\n";
  CHECK(aligned(list) == list);
}

TEST_CASE("broken lines stay untouched and end a paragraph") {
  std::string const list =
      "filter[0].order   1   \nfilter[   x\nkopf.achs_nr 1\nEnde\nfilter[0].order      1\n";
  CHECK(aligned(list) == "filter[0].order  1\nfilter[   x\nkopf.achs_nr  1\nEnde\nfilter[0].order      1\n");
}

TEST_CASE("a long value does not push the comments of others") {
  CHECK(aligned("kopf.log_achs_name \"a very very long name of an axis\" ( a\nkopf.achs_nr 1 ( b\n") ==
        "kopf.log_achs_name  \"a very very long name of an axis\"  ( a\nkopf.achs_nr        1  ( b\n");
}

TEST_CASE("aligning never changes what a list means, and twice is once") {
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    auto const list = tests::random_list(seed);
    auto const once = aligned(list);
    INFO(list << "\n---\n" << once);
    CHECK(meaning(once) == meaning(list));
    CHECK(aligned(once) == once);
  }
}

TEST_CASE("a number that a parenthesis follows is none, and stays none") {
  // A blank between them would make a number of it.
  for (std::string const value : {"4( P-AXIS-00140", "0x1F(", "1,5(", "1.5e3(x", "-1e-999(", "007(a b"}) {
    CAPTURE(value);
    for (std::string const name : {"filter[0].order", "filter[0].fg_f0", "filter[0].type", "kopf.hugo"}) {
      std::string const line = name + " " + value + "  \n";
      CHECK(aligned(line) == line);
      CHECK(aligned("kopf.achs_nr 1\n" + line + "a 1\n") == "kopf.achs_nr  1\n" + line + "a  1\n");
    }
  }
  CHECK(aligned("filter[0].order 4 ( a\n") == "filter[0].order  4  ( a\n");
  CHECK(aligned("kopf.log_achs_name 4(a\n") == "kopf.log_achs_name  4  (a\n");
  CHECK(aligned("getriebe[0].dynamik.a_max P-AXIS-00212(a\n") ==
        "getriebe[0].dynamik.a_max  P-AXIS-00212  (a\n");
}

TEST_CASE("a long line stays and does not push its neighbours away") {
  // Otherwise a line might grow beyond what can be read.
  std::string const name = "a" + std::string(5000, 'b') + " 1\n";
  std::string const indent = std::string(5000, '\t') + "a 1\n";
  for (std::string const& line : {name, indent}) {
    CHECK(aligned("kopf.achs_nr 1\n" + line + "a 1\n") == "kopf.achs_nr  1\n" + line + "a  1\n");
  }
}

TEST_CASE("whatever a list has become, aligning does not change its effect") {
  for (std::uint32_t seed = 0; seed < 3000; ++seed) {
    auto const list = mutated(tests::random_list(seed), seed);
    auto const once = aligned(list);
    INFO(list << "\n---\n" << once);
    REQUIRE(effect(once) == effect(list));
    REQUIRE(aligned(once) == once);
  }
}
