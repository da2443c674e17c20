#include "axisc/files/csv.hpp"

#include "axisc/environment/failure.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include <rapidcheck.h>

namespace csv_test {

using namespace axisc;
using namespace axisc;

namespace {

/// Hands out at most `piece` bytes at a time.
ByteSource from(std::string text, std::size_t piece = 7) {
  return [text = std::move(text), piece, at = std::size_t{0}](std::span<char> buffer) mutable {
    auto const size = std::min({piece, buffer.size(), text.size() - at});
    std::copy_n(text.begin() + static_cast<std::ptrdiff_t>(at), size, buffer.begin());
    at += size;
    return size;
  };
}

std::vector<std::vector<double>> rows_of(std::string const& text) {
  CsvReader reader("in.csv", from(text));
  std::vector<std::vector<double>> rows;
  for (std::vector<double> row(reader.header().size()); reader.next(row);) rows.push_back(row);
  return rows;
}

std::string failure_of(std::string const& text) {
  try {
    static_cast<void>(rows_of(text));
  } catch (Failure const& failure) {
    return failure.what();
  }
  return "no failure";
}

}  // namespace

TEST_CASE("a CSV file is read row by row") {
  CsvReader reader("in.csv", from("X,Y.interface\n1,2.5\n-3e2,+0\n"));
  CHECK(reader.header() == std::vector<std::string>{"X", "Y.interface"});
  std::array<double, 2> row{};
  REQUIRE(reader.next(row));
  CHECK(row == std::array{1.0, 2.5});
  REQUIRE(reader.next(row));
  CHECK(row == std::array{-300.0, 0.0});
  CHECK_FALSE(reader.next(row));
  CHECK_FALSE(reader.next(row));
}

TEST_CASE("CSV as spreadsheets write it") {
  CHECK(rows_of("\xEF\xBB\xBF\"X\" , Y\r\n 1 ,\t2\r\n\r\n3,4") ==
        std::vector<std::vector<double>>{{1, 2}, {3, 4}});
}

TEST_CASE("hostile numbers reach the runtime") {
  auto const rows = rows_of("X\nnan\n-inf\n1e308\n");
  CHECK(std::isnan(rows[0][0]));
  CHECK(rows[1][0] == -std::numeric_limits<double>::infinity());
  CHECK(rows[2][0] == 1e308);
}

TEST_CASE("every mistake in a CSV file has its place") {
  auto const begins = [](std::string const& text, std::string const& expected) {
    INFO(text);
    CHECK_THAT(failure_of(text), Catch::Matchers::StartsWith(expected));
  };
  begins("", "in.csv:1:1: the CSV file is empty");
  begins("\n\n", "in.csv:1:1: the CSV file is empty");
  begins("X,,Y\n", "in.csv:1:3: a column has no name");
  begins("X,Y,X\n", "in.csv:1:5: column \"X\" occurs twice");
  begins("X,Y\n1,2\n3\n", "in.csv:3:1: the number of fields is 1, the first line names 2");
  begins("X\n1,2\n", "in.csv:2:3: the number of fields is 2");
  begins("X,Y\n1,2,\n", "in.csv:2:5: the number of fields is 3");
  begins("\xC3\x84,Y\n1,\xC3\xA4\n", "in.csv:2:3: \"\xC3\xA4\" in column \"Y\" is not a number");
  begins("\xC3\x84,\xC3\x84\n", "in.csv:1:3: column \"\xC3\x84\" occurs twice");
  begins("X,Y\n1,1.5e\n", "in.csv:2:3: \"1.5e\" in column \"Y\" is not a number");
  begins("X,Y\n1,\n", "in.csv:2:3: \"\" in column \"Y\" is not a number");
  begins("X\n1e999\n", "in.csv:2:1: \"1e999\"");
  begins("X\n\"1\n", "in.csv:2:1: the quotation mark is not closed");
  begins("X\n" + std::string((1U << 20U) + 100000, '1') + "\n", "in.csv:2:1: the line is longer than 1 MiB");
}

TEST_CASE("what is written reads back as the same doubles") {
  rc::check("every bit pattern", [](std::uint64_t bits) {
    auto const value = std::bit_cast<double>(bits);
    RC_PRE(!std::isnan(value));
    std::string text = "X,Y\n";
    append_csv_row(text, std::array{value, -value});
    RC_ASSERT(rows_of(text) == (std::vector<std::vector<double>>{{value, -value}}));
  });
}

TEST_CASE("names with separators are quoted") {
  std::string line;
  append_csv_name(line, "X");
  append_csv_name(line, "a,b");
  append_csv_name(line, "\"");
  CHECK(line == "X\"a,b\"\"\"\"\"");
}

}  // namespace csv_test
