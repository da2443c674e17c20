// Numbers that are read eight digits at a time read the same as digit by digit.
#include "validator/values/short_number.hpp"

#include "diagnostics/source_text.hpp"
#include "grammar/axis_list.hpp"
#include "schema/catalogue.hpp"
#include "schema/value.hpp"
#include "support/catch.hpp"
#include "validator/values/line_value.hpp"
#include "validator/values/list_reader.hpp"

#include <bit>
#include <cstdint>
#include <forward_list>
#include <optional>
#include <random>
#include <string>
#include <string_view>

namespace short_number_test {

using namespace axisc;
using namespace axisc::validator;
using axisc::schema::DataType;

namespace {

class Texts {
 public:
  std::string digits(unsigned most) {
    std::string text;
    for (unsigned left = 1 + below(most); left > 0; --left) text += static_cast<char>('0' + below(10));
    return text;
  }
  std::string integer(unsigned most) {
    std::string text = digits(most);
    while (text.size() > 1 && text.front() == '0') text.erase(0, 1);
    return sign() + text;
  }
  std::string real() {
    std::string text = integer(10);
    if (below(8) != 0) text += '.' + (below(20) == 0 ? std::string() : digits(9));
    if (below(3) == 0) text += std::string(1, "eE"[below(2)]) + sign() + digits(3);
    return text;
  }
  /// As a value stands in a list.
  std::string behind_name(std::string_view value) {
    constexpr std::string_view before = "1.5 9999999999999e+05.99e-3 8 . e x/:";
    std::string text(before.substr(below(6), room_before_number_end + below(8)));
    return text.append(value);
  }
  unsigned below(unsigned limit) { return std::uniform_int_distribution<unsigned>(0, limit - 1)(random_); }

 private:
  std::string sign() {
    constexpr std::string_view signs[] = {"", "", "-", "+"};
    return std::string(signs[below(4)]);
  }

  std::mt19937 random_{20240611};
};

std::optional<double> short_integer(std::string const& text, std::size_t size) {
  double number = 0;
  bool const is_short =
      read_short_integer(text.data() + text.size() - size, text.data() + text.size(), number);
  return is_short ? std::optional(number) : std::nullopt;
}

std::optional<double> short_real(std::string const& text, std::size_t size) {
  double number = 0;
  bool const is_short = read_short_real(text.data() + text.size() - size, text.data() + text.size(), number);
  return is_short ? std::optional(number) : std::nullopt;
}

/// Also the sign of a zero.
bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

TEST_CASE("short integers are the same numbers") {
  Texts texts;
  unsigned read = 0;
  for (unsigned i = 0; i < 100000; ++i) {
    std::string const value = texts.integer(10);
    auto const quick = short_integer(texts.behind_name(value), value.size());
    std::size_t const digits = value.find_first_of("+-") == 0 ? value.size() - 1 : value.size();
    CAPTURE(value);
    REQUIRE(quick.has_value() == (digits <= 8));
    if (!quick) continue;
    ++read;
    REQUIRE(same(*quick, schema::read_integer(value, DataType::sgn64).number));
  }
  CHECK(read > 50000);
}

TEST_CASE("short reals are the same numbers, correctly rounded") {
  Texts texts;
  unsigned read = 0;
  for (unsigned i = 0; i < 300000; ++i) {
    std::string const value = texts.real();
    auto const quick = short_real(texts.behind_name(value), value.size());
    if (!quick) continue;
    ++read;
    CAPTURE(value);
    schema::NumberReading const line_value = schema::read_real(value);
    REQUIRE(line_value.status == schema::NumberStatus::good);
    REQUIRE(same(*quick, line_value.number));
  }
  CHECK(read > 50000);
  for (char const* value : {"1.5", "-0.0", "123.456", "99999999.9999999", "1.234560e+03", "-3.000000e+001",
                            "1.0e-21", "12345678.1E+22"}) {
    INFO(value);
    CHECK(short_real(texts.behind_name(value), std::string_view(value).size()).has_value());
  }
}

TEST_CASE("no more is read than the room before the end of a number") {
  // On the heap, where sanitizers watch both ends.
  auto const read_at_begin = [](std::string_view number, auto read) {
    auto const room = std::make_unique<char[]>(room_before_number_end);
    std::fill_n(room.get(), room_before_number_end, '9');
    char* const end = room.get() + room_before_number_end;
    std::copy(number.begin(), number.end(), end - number.size());
    double value = 0;
    return read(end - number.size(), end, value) ? std::optional(value) : std::nullopt;
  };
  CHECK(read_at_begin("7", read_short_integer) == 7);
  CHECK(read_at_begin("-12345678", read_short_integer) == -12345678);
  CHECK(read_at_begin("1.5", read_short_real) == 1.5);
  CHECK(read_at_begin("-12345678.1234567e-012", read_short_real) == -12345678.1234567e-12);
}

TEST_CASE("what is no number is none") {
  Texts texts;
  for (char const* value : {"-", "+", "1-", "1a", "0x10", "1/", "1:",
                            "\xB1"
                            "1",
                            "12345678\x80", "1.5"}) {
    INFO(value);
    CHECK_FALSE(short_integer(texts.behind_name(value), std::string_view(value).size()));
  }
  for (char const* value :
       {"1",     ".",       ".5",   "5.",    "1.5e",  "1.5e+",   "1.5e3", "1.5e+1", "1.5e+99", "1..5",
        "1.5.1", "1.5e++3", "e+03", ".e+03", "1e+03", "1.5a+03", "1,5",   "1.\xB1", "x.5",     "+.5"}) {
    INFO(value);
    CHECK_FALSE(short_real(texts.behind_name(value), std::string_view(value).size()));
  }
}

TEST_CASE("a list with short numbers is judged as line by line") {
  Texts texts;
  axisc::schema::Catalogue const catalogue;
  for (unsigned round = 0; round < 200; ++round) {
    std::string text;
    for (unsigned line = 0; line < 100; ++line) {
      auto const slot =
          static_cast<axisc::schema::Slot>(texts.below(static_cast<unsigned>(catalogue.slot_count())));
      std::string const value = texts.below(2) == 0 ? texts.integer(10) : texts.real();
      constexpr std::string_view behind[] = {"", "  ( comment", " x", " # hash"};
      text += axisc::schema::slot_name(slot) + " " + value + std::string(behind[texts.below(4)]) + "\n";
    }
    axisc::SourceText const source("x.lis", text);
    ReadList const list = read_list(source);
    for (std::size_t i = 0; i < list.tree.assignments.size(); ++i) {
      axisc::grammar::Assignment const& assignment = list.tree.assignments[i];
      axisc::schema::NameLookup const lookup = catalogue.find(source.slice(assignment.name));
      LineValue expected;
      expected.text = assignment.value;
      expected.row = lookup.row;
      expected.slot = lookup.slot;
      expected.name_status = lookup.status;
      std::forward_list<std::string> transcoded;
      judge(source, assignment, expected, transcoded);
      LineValue const line_value = list.line_values[i];
      CAPTURE(source.slice(assignment.name), source.slice(assignment.value));
      REQUIRE(line_value.status == expected.status);
      REQUIRE(line_value.number == expected.number);
      REQUIRE(same(line_value.value.number, expected.value.number));
      REQUIRE(line_value.value.text == expected.value.text);
      REQUIRE(line_value.text == expected.text);
      REQUIRE(line_value.trouble == expected.trouble);
      REQUIRE(line_value.slot == expected.slot);
    }
  }
}

TEST_CASE("a list knows whether it names a parameter twice") {
  auto const has_repetitions = [](std::string text) {
    return read_list(axisc::SourceText("x.lis", std::move(text))).line_values.has_repetitions();
  };
  CHECK(has_repetitions("filter[0].order 2\nfilter[1].order 2\nfilter[0].order 2\n"));
  CHECK(has_repetitions("filter[0].type PT2\nfilter[0].TYPE PT2\n"));
  CHECK_FALSE(has_repetitions("filter[0].order 2\nfilter[1].order 2\n"));
}

}  // namespace short_number_test
