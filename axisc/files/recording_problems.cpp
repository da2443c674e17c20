#include "axisc/files/recording_problems.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/utf8.hpp"

#include <array>

namespace axisc::says {

constexpr Sentence no_numbers{
    "{file} has no line of numbers; give a scope's export or its .svdx, or a file with columns that tabs, "
    "semicolons or commas separate",
    "{file} hat keine Zeile mit Zahlen; einen Export des Scopes oder seine .svdx angeben, oder eine Datei "
    "mit Spalten, die Tabulatoren, Semikolons oder Kommas trennen"};
constexpr Sentence long_row{"{file}:{line}: the line is longer than 1 MiB",
                            "{file}:{line}: die Zeile ist länger als 1 MiB"};
constexpr Sentence field_count{
    "{file}:{line}: the number of fields is {fields}, in the first line of numbers {columns}; complete "
    "the line, or delete it where the file is cut off",
    "{file}:{line}: die Zahl der Felder ist {fields}, in der ersten Zeile mit Zahlen {columns}; die "
    "Zeile ergänzen oder, wo die Datei abgeschnitten ist, löschen"};
constexpr Sentence mixed_marks{
    "{file}:{line}: the file has decimal commas and decimal points; write it without thousands separators",
    "{file}:{line}: die Datei hat Dezimalkommas und Dezimalpunkte; ohne Tausendertrennzeichen schreiben"};
constexpr Sentence comma_separator{
    "{file}:{line}: the number of fields is {fields}, in the header {columns}: decimal commas cannot be told "
    "from the commas that separate; export with tabs or semicolons",
    "{file}:{line}: die Zahl der Felder ist {fields}, im Kopf {columns}: Dezimalkommas sind von trennenden "
    "Kommas nicht zu unterscheiden; mit Tabulatoren oder Semikolons exportieren"};
constexpr Sentence bad_table{
    "{file}:{line}: the row {text} of the header does not repeat its key before each group of columns; "
    "export the recording again",
    "{file}:{line}: die Zeile {text} des Kopfs wiederholt ihren Schlüssel nicht vor jeder Spaltengruppe; die "
    "Aufzeichnung neu exportieren"};
constexpr Sentence different_spans{
    "{file}:{line}: the groups of columns cover different times, yet none ends before the others: rows are "
    "missing; export the whole time again",
    "{file}:{line}: die Spaltengruppen decken verschiedene Zeiten ab, doch keine endet vor den anderen: Es "
    "fehlen Zeilen; die ganze Zeit neu exportieren"};
constexpr Sentence binary_cut_off{
    "{file}: the file is not as long as its first bytes say: it is cut off, or not a .svdx; save it again in "
    "the scope, or export it as text",
    "{file}: die Datei ist nicht so lang, wie ihre ersten Bytes sagen: Sie ist abgeschnitten oder keine "
    ".svdx; im Scope neu speichern oder als Text exportieren"};
constexpr Sentence binary_broken{
    "{file}, byte {byte}: not what a .svdx has here; save it again in the scope, or export it as text",
    "{file}, Byte {byte}: hier steht nicht, was eine .svdx hat; im Scope neu speichern oder als Text "
    "exportieren"};
constexpr Sentence binary_xml{
    "{file}, byte {byte}: the project in the .svdx is not well-formed XML in UTF-8; save it again in the "
    "scope, or export it as text",
    "{file}, Byte {byte}: das Projekt in der .svdx ist kein wohlgeformtes XML in UTF-8; im Scope neu "
    "speichern oder als Text exportieren"};
constexpr Sentence binary_project{
    "{file}, byte {byte}: {text} is missing in the project of the .svdx, or not valid; save it again in the "
    "scope, or export it as text",
    "{file}, Byte {byte}: {text} fehlt im Projekt der .svdx oder ist ungültig; im Scope neu speichern oder "
    "als Text exportieren"};
constexpr Sentence binary_type{
    "{file}, byte {byte}: the data type \"{text}\" is not known; export the recording as text",
    "{file}, Byte {byte}: der Datentyp \"{text}\" ist nicht bekannt; die Aufzeichnung als Text exportieren"};
constexpr Sentence binary_compressed{
    "{file}, byte {byte}: samples with the CompressionMode \"{text}\" are not read; save without "
    "compression, or export the recording as text",
    "{file}, Byte {byte}: Abtastwerte mit dem CompressionMode \"{text}\" werden nicht gelesen; ohne "
    "Komprimierung speichern oder die Aufzeichnung als Text exportieren"};
constexpr Sentence binary_version{
    "{file}, byte {byte}: a block of version \"{text}\" is not read, only 01.00.00.40; export the recording "
    "as text",
    "{file}, Byte {byte}: ein Block der Version \"{text}\" wird nicht gelesen, nur 01.00.00.40; die "
    "Aufzeichnung als Text exportieren"};
constexpr Sentence binary_extremes{
    "{file}, byte {byte}: the extremes that the .svdx has of its samples do not agree with them: the file is "
    "damaged; save it again in the scope, or export it as text",
    "{file}, Byte {byte}: die Extremwerte, die die .svdx von ihren Abtastwerten hat, passen nicht zu ihnen: "
    "Die Datei ist beschädigt; im Scope neu speichern oder als Text exportieren"};

constexpr Sentence bad_field{R"({place}: "{text}" in column "{column}" is not a number)",
                             R"({place}: "{text}" in Spalte "{column}" ist keine Zahl)"};
constexpr Sentence not_finite{R"({place}: column "{column}" has a value that is not a number)",
                              R"({place}: Spalte "{column}" hat einen Wert, der keine Zahl ist)"};
constexpr Sentence bad_time{R"({place}: "{text}", the time of column "{column}", is not a number)",
                            R"({place}: "{text}", die Zeit der Spalte "{column}", ist keine Zahl)"};
constexpr Sentence no_time{"{place}: column \"{column}\" has a value, but no time; export again",
                           "{place}: Spalte \"{column}\" hat einen Wert, aber keine Zeit; neu exportieren"};
constexpr Sentence time_falls{
    "{place}: the time of column \"{column}\" is earlier than in the line before; export one recording",
    "{place}: die Zeit der Spalte \"{column}\" liegt vor der in der Zeile davor; eine Aufzeichnung "
    "exportieren"};
constexpr Sentence two_values{
    "{place}: column \"{column}\" has two values at one time, as envelopes (minimum and maximum) have; "
    "export the samples themselves",
    "{place}: Spalte \"{column}\" hat zwei Werte zu einer Zeit, wie Hüllkurven (Minimum und Maximum) sie "
    "haben; die Abtastwerte selbst exportieren"};
constexpr Sentence no_position{
    "{place}: {value} in column \"{column}\" is too large for a position; delete the row, or name another "
    "column",
    "{place}: {value} in Spalte \"{column}\" ist zu groß für eine Position; die Zeile löschen oder eine "
    "andere Spalte nennen"};
constexpr Sentence no_samples{
    "{place}: column \"{column}\" has no samples at the time of the others; record them together",
    "{place}: Spalte \"{column}\" hat keine Abtastwerte zur Zeit der anderen; sie zusammen aufzeichnen"};
constexpr Sentence header_disagrees{
    "{place}: the header says a sample of column \"{column}\" every {header} ms, but the times are {step} ms "
    "apart; export again",
    "{place}: der Kopf nennt einen Abtastwert der Spalte \"{column}\" alle {header} ms, doch die Zeiten "
    "liegen {step} ms auseinander; neu exportieren"};
constexpr Sentence other_step{
    "{place}: {step} ms pass between samples of column \"{column}\", which is neither the NC cycle of "
    "{cycle} ms nor a whole part of it; record with the NC cycle",
    "{place}: zwischen Abtastwerten der Spalte \"{column}\" vergehen {step} ms, weder der NC-Zyklus von "
    "{cycle} ms noch ein ganzer Teil davon; mit dem NC-Zyklus aufzeichnen"};
constexpr Sentence decimated{
    "{place}: {step} ms pass between samples of column \"{column}\": NC cycles of {cycle} ms were left out; "
    "record every NC cycle",
    "{place}: zwischen Abtastwerten der Spalte \"{column}\" vergehen {step} ms: NC-Zyklen von {cycle} ms "
    "wurden ausgelassen; jeden NC-Zyklus aufzeichnen"};
constexpr Sentence other_cycle{
    "{place}: {step} ms passed since the sample before, which is not a whole number of cycles of {cycle} ms; "
    "record with the NC cycle",
    "{place}: seit dem Abtastwert davor vergingen {step} ms, das ist keine ganze Zahl von Zyklen von {cycle} "
    "ms; mit dem NC-Zyklus aufzeichnen"};
constexpr Sentence many_lost{
    "{place}: more than a quarter of the cycles of column \"{column}\" is missing by their times; record "
    "every NC cycle of {cycle} ms",
    "{place}: nach den Zeiten fehlt mehr als ein Viertel der Zyklen der Spalte \"{column}\"; jeden NC-Zyklus "
    "von {cycle} ms aufzeichnen"};
constexpr Sentence clocks_drift{
    "{place}: the times of column \"{column}\" run at another speed than those of the others; record them in "
    "one task",
    "{place}: die Zeiten der Spalte \"{column}\" laufen anders als die der anderen; sie in einer Task "
    "aufzeichnen"};
constexpr Sentence uncommon_clocks{
    "{place}: column \"{column}\" and another one do not both have times; export them together",
    "{place}: Spalte \"{column}\" und eine andere haben nicht beide Zeiten; sie zusammen exportieren"};

}  // namespace axisc::says

namespace axisc {

namespace {

using recordings::BadRecording;
using recordings::CycleProblem;
using recordings::RecordingProblem;

SentenceRef sentence_of(RecordingProblem problem) {
  switch (problem) {
    case RecordingProblem::no_rows: return says::no_numbers;
    case RecordingProblem::long_line: return says::long_row;
    case RecordingProblem::field_count: return says::field_count;
    case RecordingProblem::mixed_marks: return says::mixed_marks;
    case RecordingProblem::comma_separator: return says::comma_separator;
    case RecordingProblem::bad_table: return says::bad_table;
    case RecordingProblem::different_spans: return says::different_spans;
    case RecordingProblem::too_short: return says::binary_cut_off;
    case RecordingProblem::bad_xml: return says::binary_xml;
    case RecordingProblem::bad_project: return says::binary_project;
    case RecordingProblem::unknown_type: return says::binary_type;
    case RecordingProblem::compressed: return says::binary_compressed;
    case RecordingProblem::unknown_version: return says::binary_version;
    case RecordingProblem::bad_extremes: return says::binary_extremes;
    case RecordingProblem::bad_container:
    case RecordingProblem::bad_block:
    case RecordingProblem::bad_time: break;
  }
  return says::binary_broken;
}

SentenceRef sentence_of(CycleProblem problem) {
  switch (problem) {
    case CycleProblem::too_large: return says::no_position;
    case CycleProblem::header_disagrees: return says::header_disagrees;
    case CycleProblem::other_step: return says::other_step;
    case CycleProblem::decimated: return says::decimated;
    case CycleProblem::other_distance: return says::other_cycle;
    case CycleProblem::many_lost: return says::many_lost;
    case CycleProblem::drift: return says::clocks_drift;
    case CycleProblem::uncommon_clocks: return says::uncommon_clocks;
    case CycleProblem::bad_clock:
    case CycleProblem::bad_value:
    case CycleProblem::no_samples: break;
  }
  return says::no_samples;
}

/// By ClockProblem.
constexpr std::array<SentenceRef, 4> clock_sentences{says::bad_time, says::no_time, says::time_falls,
                                                     says::two_values};

}  // namespace

std::string shown_column(std::string_view name) {
  constexpr std::size_t longest_shown = 40;
  return repair_utf8(name.substr(0, longest_shown));
}

std::string place_at(std::string const& file, std::uint64_t line) {
  return line == 0 ? file : file + ":" + std::to_string(line);
}

void fail_reading(std::string const& file, BadRecording const& bad) {
  throw Failure({sentence_of(bad.problem),
                 {{"file", file},
                  {"line", std::to_string(bad.line)},
                  {"byte", std::to_string(bad.byte)},
                  {"fields", std::to_string(bad.fields)},
                  {"columns", std::to_string(bad.expected)},
                  {"text", bad.text}}},
                csv_malformed);
}

void fail_value(RecordingFile const& file, std::size_t channel) {
  auto const& bad = *file.recording.channels[channel].bad;
  throw Failure({bad.line == 0 ? SentenceRef(says::not_finite) : says::bad_field,
                 {{"place", place_at(file.name, bad.line)},
                  {"text", bad.text},
                  {"column", shown_column(file.recording.channels[channel].name)}}},
                csv_malformed);
}

void fail_clock(RecordingFile const& file, std::size_t channel) {
  auto const& clock = file.recording.clocks[file.recording.channels[channel].clock];
  throw Failure({clock_sentences.at(static_cast<std::size_t>(*clock.problem)),
                 {{"place", place_at(file.name, clock.place.line)},
                  {"text", clock.place.text},
                  {"column", shown_column(file.recording.channels[channel].name)}}},
                csv_malformed);
}

void fail_cycles(RecordingFile const& file, recordings::BadCycles const& bad, double cycle_ms) {
  if (bad.problem == CycleProblem::bad_clock) fail_clock(file, bad.channel);
  if (bad.problem == CycleProblem::bad_value) fail_value(file, bad.channel);
  auto const& channel = file.recording.channels[bad.channel];
  auto const& clock = file.recording.clocks[channel.clock];
  throw Failure({sentence_of(bad.problem),
                 {{"place", file.place(bad.channel, bad.sample)},
                  {"column", shown_column(channel.name)},
                  {"value", format_rounded(bad.value, 6)},
                  {"step", format_rounded(bad.step, 6)},
                  {"header", format_rounded(clock.sample_time.value_or(0), 6)},
                  {"cycle", format_rounded(cycle_ms, 6)}}},
                csv_malformed);
}

}  // namespace axisc
