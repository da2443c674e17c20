#include "validator/list_layout.hpp"

#include "grammar/axis_list.hpp"
#include "support/catch.hpp"
#include "support/random_lists.hpp"
#include "validator/reading.hpp"

#include <string>
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
