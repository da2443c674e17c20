#include "axisc/files/row_problem.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/utf8.hpp"

namespace axisc::says {

constexpr Sentence no_numbers{
    "{file} has no line of numbers; give a file with columns that tabs, semicolons or commas separate",
    "{file} hat keine Zeile mit Zahlen; eine Datei mit Spalten angeben, die Tabulatoren, Semikolons oder "
    "Kommas trennen"};
constexpr Sentence bad_field{R"({file}:{line}: "{text}" in column "{column}" is not a number)",
                             R"({file}:{line}: "{text}" in Spalte "{column}" ist keine Zahl)"};
constexpr Sentence few_fields{
    "{file}:{line}: the line has {fields} fields, the first line of numbers {columns}; complete it, or "
    "delete it where the file is cut off",
    "{file}:{line}: die Zeile hat {fields} Felder, die erste mit Zahlen {columns}; ergänzen oder, wo die "
    "Datei abgeschnitten ist, löschen"};
constexpr Sentence mixed_marks{
    R"({file}:{line}: column "{column}" has decimal commas and decimal points; write it without thousands separators)",
    R"({file}:{line}: Spalte "{column}" hat Dezimalkommas und Dezimalpunkte; ohne Tausendertrennzeichen schreiben)"};
constexpr Sentence long_row{"{file}:{line}: the line is longer than 1 MiB",
                            "{file}:{line}: die Zeile ist länger als 1 MiB"};

}  // namespace axisc::says

namespace axisc {

namespace {

SentenceRef sentence_of(recordings::RowProblem problem) {
  switch (problem) {
    case recordings::RowProblem::not_a_number: return says::bad_field;
    case recordings::RowProblem::field_count: return says::few_fields;
    case recordings::RowProblem::mixed_marks: return says::mixed_marks;
    case recordings::RowProblem::long_line: return says::long_row;
    case recordings::RowProblem::no_rows: break;
  }
  return says::no_numbers;
}

}  // namespace

std::string shown_column(std::string_view name) {
  constexpr std::size_t longest_shown = 40;
  return repair_utf8(name.substr(0, longest_shown));
}

void fail_row(recordings::NumberRows const& rows, std::string const& file) {
  auto const& bad = *rows.problem();
  std::string const column = bad.column < rows.names().size() ? shown_column(rows.names()[bad.column]) : "";
  throw Failure({sentence_of(bad.problem),
                 {{"file", file},
                  {"line", std::to_string(bad.line)},
                  {"text", bad.text},
                  {"column", column},
                  {"fields", std::to_string(bad.fields)},
                  {"columns", std::to_string(rows.names().size())}}},
                csv_malformed);
}

bool next_row(recordings::NumberRows& rows, std::span<double> row, std::string const& file) {
  auto const step = rows.next(row);
  if (step == recordings::NumberRows::Step::bad) fail_row(rows, file);
  return step == recordings::NumberRows::Step::row;
}

}  // namespace axisc
