#include "analysis/recordings/number_rows.hpp"

#include "support/catch.hpp"

namespace axisc::recordings {
namespace {

using Table = std::vector<std::vector<double>>;

Table table(NumberRows& rows) {
  Table found;
  std::vector<double> row(rows.names().size());
  while (rows.next(row) == NumberRows::Step::row) found.push_back(row);
  return found;
}

Table table(std::string const& text) {
  NumberRows rows(source_of(text));
  auto const found = table(rows);
  CHECK_FALSE(rows.problem());
  return found;
}

BadRow refused(std::string const& text) {
  NumberRows rows(source_of(text));
  static_cast<void>(table(rows));
  REQUIRE(rows.problem());
  return *rows.problem();
}

TEST_CASE("a Scope export is read whatever pieces it arrives in") {
  std::string const text =
      "\xEF\xBB\xBFName\tDrive\r\n\r\nTime\tin\tTime\tout\r\n0,0\t1,5\t0,0\t-2\r\n"
      "0,5\t1,25\t0,5\t+3\t\r\n \t \r\n1\t0\t1\t\"4e-1\"\r\nEOF\r\nrest\r\n";
  for (std::size_t const piece : {1U, 2U, 7U, 1000U}) {
    auto whole = source_of(text);
    NumberRows rows(
        [&](std::span<char> buffer) { return whole(buffer.first(std::min(piece, buffer.size()))); });
    CHECK(rows.names() == std::vector<std::string>{"Time", "in", "Time", "out"});
    CHECK(table(rows) == Table{{0, 1.5, 0, -2}, {0.5, 1.25, 0.5, 3}, {1, 0, 1, 0.4}});
    CHECK(rows.line() == 8);
  }
}

TEST_CASE("the last header of the right width names the columns") {
  NumberRows rows(source_of("a;b\nc;d\ne;f;g\n1;2\n"));
  CHECK(rows.is_named());
  CHECK(rows.names() == std::vector<std::string>{"c", "d"});
  NumberRows nameless(source_of("1,2\n"));
  CHECK_FALSE(nameless.is_named());
  CHECK(nameless.names() == std::vector<std::string>{"1", "2"});
}

TEST_CASE("the whole column decides what a comma is") {
  CHECK(table("1,5;2\n2;3,25\n") == Table{{1.5, 2}, {2, 3.25}});
  CHECK(table("1.5,2\n2,3.25\n") == Table{{1.5, 2}, {2, 3.25}});
  CHECK(table("1.5;2,5\n2;3\n") == Table{{1.5, 2.5}, {2, 3}});
  auto const bad = refused("1;1,5\n1;2.5\n");
  CHECK(bad.problem == RowProblem::mixed_marks);
  CHECK(bad.line == 2);
  CHECK(bad.column == 1);
}

TEST_CASE("what is no row of numbers is refused with its place") {
  CHECK(refused("").problem == RowProblem::no_rows);
  CHECK(refused("EOF\n1,2\n").problem == RowProblem::no_rows);
  CHECK(refused("a\n1\n2\n").problem == RowProblem::no_rows);
  auto bad = refused("a;b\n1;2\n\n3;x\xFF\n");
  CHECK(bad.problem == RowProblem::not_a_number);
  CHECK((bad.line == 4 && bad.column == 1 && bad.text == "x\xEF\xBF\xBD"));
  bad = refused("1;2\n3;inf\n");
  CHECK(bad.problem == RowProblem::not_a_number);
  bad = refused("1;2\n3;4;5\n");
  CHECK(bad.problem == RowProblem::field_count);
  CHECK((bad.line == 2 && bad.fields == 3));
  CHECK(refused("1;2\n1;" + std::string(2 * longest_line, '2')).problem == RowProblem::long_line);
}

TEST_CASE("columns that nobody reads may have any text") {
  NumberRows rows(source_of("n;x;y\n1;2;3\n4;idle;6\n"));
  rows.read_only({0, 2});
  std::vector<double> row(3);
  CHECK(rows.next(row) == NumberRows::Step::row);
  CHECK(rows.next(row) == NumberRows::Step::row);
  CHECK((row[0] == 4 && row[2] == 6));
  CHECK(rows.next(row) == NumberRows::Step::end);
}

}  // namespace
}  // namespace axisc::recordings
