// One case for each rule of text_recording.hpp; that of the program in the field are in scope_files.test.cpp.
#include "analysis/recordings/text_recording.hpp"

#include "support/catch.hpp"

#include <cmath>

namespace axisc::recordings::text_recording_test {
namespace {

using Values = std::vector<double>;

Recording read(std::string const& text) {
  auto found = read_text_recording(source_of(text));
  if (auto const* const bad = std::get_if<BadRecording>(&found)) {
    FAIL(static_cast<int>(bad->problem) << " line " << bad->line << " " << bad->text);
  }
  return std::get<Recording>(std::move(found));
}

BadRecording refused(std::string const& text) {
  auto const found = read_text_recording(source_of(text));
  REQUIRE(std::holds_alternative<BadRecording>(found));
  return std::get<BadRecording>(found);
}

Channel const& channel(Recording const& recording, std::string const& name) {
  for (auto const& each : recording.channels) {
    if (each.name == name) return each;
  }
  FAIL(name);
  return recording.channels.front();
}

Values times(Recording const& recording, std::string const& name) {
  return recording.clocks[channel(recording, name).clock].times.values();
}

Values values(Recording const& recording, std::string const& name) {
  return channel(recording, name).values.values();
}

std::vector<std::string> names(Recording const& recording) {
  std::vector<std::string> found;
  for (auto const& each : recording.channels) found.push_back(each.name);
  return found;
}

std::string replaced(std::string text, std::string const& from, std::string const& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// Two groups, as a scope exports them: a slower one begins before the other, and ends first.
std::string const table =
    "Name\ttest\nFile\tC:\\test.csv\nStarttime of export\t132959733843760000\tMontag, 2. Mai "
    "2022\t15:56:24\n\n"
    "Name\tX\tY\tName\tslow\n"
    "SymbolComment\t\t\tSymbolComment\t\n"
    "Data-Type\tINT32\tREAL64\tData-Type\tINT16\n"
    "SampleTime[ms]\t1\t1\tSampleTime[ms]\t2\n"
    "IndexGroup\t1184513\t16448\tIndexGroup\t16448\n"
    "IndexOffset\t65633\t7\tIndexOffset\t8\n"
    "SymbolName\tS.x\tS.y\tSymbolName\tS.slow\n"
    "NetID\t1.2.3.4.1.1\t1.2.3.4.1.1\tNetID\t1.2.3.4.1.1\n"
    "Port\t551\t851\tPort\t851\n"
    "Offset\t0\t1\tOffset\t0\n"
    "ScaleFactor\t1\t-0.5\tScaleFactor\t1\n"
    "Unit\t(None)\tmm\tUnit\t(None)\n"
    "\n"
    "0\t10\t0.5\t-1\t3\n"
    "1\t11\t1.5\t1\t4\n"
    "2\t12\t2.5\n"
    "3\t13\t-3\n";

std::string utf16(std::string const& text, bool big_endian) {
  std::string bytes = big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (std::size_t i = 0; i < text.size(); ++i) {
    // ASCII, and the two-byte characters of UTF-8.
    unsigned unit = static_cast<unsigned char>(text[i]);
    if (unit >= 0xC0) unit = (unit & 0x1FU) << 6U | (static_cast<unsigned char>(text[++i]) & 0x3FU);
    auto const low = static_cast<char>(unit & 0xFFU);
    auto const high = static_cast<char>(unit >> 8U);
    bytes += big_endian ? high : low;
    bytes += big_endian ? low : high;
  }
  return bytes;
}

void check_table(Recording const& recording) {
  CHECK(recording.form == Form::scope_text);
  CHECK(recording.clocks.size() == 2);
  CHECK(values(recording, "X") == Values{10, 11, 12, 13});
  CHECK(values(recording, "Y") == Values{0.5, 1.5, 2.5, -3});
  CHECK(times(recording, "X") == Values{0, 1, 2, 3});
  CHECK(values(recording, "slow") == Values{3, 4});
  CHECK(times(recording, "slow") == Values{-1, 1});
}

TEST_CASE("the table of a scope describes each channel") {
  auto const recording = read(table);
  check_table(recording);
  auto const& x = channel(recording, "X");
  CHECK(x.data_type == "INT32");
  CHECK(x.symbol == "S.x");
  CHECK((x.port == 551U && x.index_group == 0x121301U && x.index_offset == 0x10061U));
  CHECK(x.scale.is_identity());
  CHECK(x.column == 2);
  auto const& y = channel(recording, "Y");
  CHECK((y.scale.factor == -0.5 && y.scale.offset == 1));
  CHECK(y.unit == "mm");
  CHECK(recording.clocks[0].sample_time == 1.0);
  CHECK(recording.clocks[1].sample_time == 2.0);
}

TEST_CASE("any separator, any end of a line, any encoding") {
  for (std::string const separator : {";", ",", ":", "\t"}) {
    INFO(separator);
    check_table(read(replaced(table, "\t", separator)));
    auto const trailing = replaced(replaced(table, "\t", separator), "\n", separator + separator + "\r\n");
    check_table(read(trailing));
  }
  check_table(read("\xEF\xBB\xBF" + table + "EOF\nrest\trest\n"));
  auto const umlaut = replaced(table, "slow", "langsam \xC3\xA4");
  for (auto const& text :
       {umlaut, utf16(umlaut, false), utf16(umlaut, true), replaced(umlaut, "\xC3\xA4", "\xE4")}) {
    CHECK(names(read(text)) == std::vector<std::string>{"X", "Y", "langsam \xC3\xA4"});
  }
  // Half of a character at the end: the file was cut off.
  CHECK(refused(utf16(table, false) + "\n").problem == RecordingProblem::field_count);
}

TEST_CASE("blanks that separate take what does not split from other rows") {
  auto text = replaced(table, "\t", " ");
  text = replaced(text, "Name test", "Name \"my test\"");
  text = replaced(text, "Unit (None) mm Unit (None)", "Unit (None) dV (Voltage) Unit (None)");
  CHECK(names(read(text)) == std::vector<std::string>{"X", "Y", "slow"});
  CHECK(channel(read(text), "Y").unit.empty());
  auto const blank_name = replaced(text, "Name X Y Name slow", "Name X test Y Name slow");
  auto const recording = read(blank_name);
  CHECK(names(recording) == std::vector<std::string>{"S.x", "S.y", "S.slow"});
  CHECK(values(recording, "S.y") == Values{0.5, 1.5, 2.5, -3});
}

TEST_CASE("a sample time with the mark that separates is taken from the times") {
  auto text = replaced(table, "SampleTime[ms]\t1\t1\t", "SampleTime[ms]\t1,0\t1,0\t");
  text = replaced(text, "\t", ",");
  auto const recording = read(text);
  check_table(recording);
  CHECK_FALSE(recording.clocks[0].sample_time.has_value());
}

TEST_CASE("a group that has ended is blank before others") {
  std::string const text =
      "Name\ta\tName\tb\nPort\t851\tPort\t851\n0\t5\t0\t1\n2\t6\t1\t2\n \t \t2\t3\n \t \t3\t4\n";
  for (auto const& form : {text, replaced(text, " ", ""), replaced(text, "\t", " ")}) {
    auto const recording = read(form);
    CHECK(values(recording, "a") == Values{5, 6});
    CHECK(values(recording, "b") == Values{1, 2, 3, 4});
    CHECK(times(recording, "b") == Values{0, 1, 2, 3});
  }
}

TEST_CASE("comments of a symbol may have line breaks, even of numbers") {
  auto const text = replaced(table, "SymbolComment\t\t\tSymbolComment\t\n",
                             "SymbolComment\tfirst\n5\t7\tsecond\n1\t2\tSymbolComment\tand\nName of it\n");
  check_table(read(text));
}

TEST_CASE("names alone, pairs without a header, and one column of times") {
  std::string const rows = "0\t10\t0\t20\n1\t11\t1\t21\n2\t12\t2\t22\n";
  auto const named = read("Name\ta\tName\tb\n" + rows);
  CHECK(named.form == Form::scope_text);
  CHECK(values(named, "b") == Values{20, 21, 22});
  CHECK(times(named, "b") == Values{0, 1, 2});
  auto const pairs = read(rows);
  CHECK((pairs.form == Form::columns && !pairs.is_named));
  CHECK(names(pairs) == std::vector<std::string>{"2", "4"});
  CHECK(values(pairs, "4") == Values{20, 21, 22});
  auto const one_time = read("0\t5\t7\t3\n1\t5\t6\t3\n2\t4\t9\t3\n");
  CHECK(names(one_time) == std::vector<std::string>{"2", "3", "4"});
  CHECK(times(one_time, "3") == Values{0, 1, 2});
  auto const columns = read("5\t7\n5\t6\n4\t9\n");
  CHECK(names(columns) == std::vector<std::string>{"1", "2"});
  CHECK(columns.clocks.front().is_counted);
  // A slower pair ends first.
  auto const slower = read("0\t1\t0\t5\n1\t2\t2\t6\n2\t3\n3\t4\n");
  CHECK(values(slower, "2") == Values{1, 2, 3, 4});
  CHECK(values(slower, "4") == Values{5, 6});
}

TEST_CASE("a line names columns, the last one with their number, and times by their name") {
  auto const recording = read("my program\na;b;c\nZeit [s];x;y\n0,000;1,5;2\n0,001;2,5;3\n");
  CHECK(names(recording) == std::vector<std::string>{"x", "y"});
  CHECK(recording.clocks.front().unit == TimeUnit::seconds);
  CHECK(values(recording, "x") == Values{1.5, 2.5});
  CHECK(read("time,x,y\n0,1,2\n1,1,2\n").clocks.front().unit == TimeUnit::milliseconds);
  CHECK(read("time,x,y\n0,1,2\n0.001,1,2\n").clocks.front().unit == TimeUnit::seconds);
  CHECK(read("time_ms,x,y\n0,1,2\n0.001,1,2\n").clocks.front().unit == TimeUnit::milliseconds);
  // The table's first key is also what another program begins its file with.
  auto const drive =
      read("Name\tDrive\r\n\r\nTime\tin\tTime\tout\r\n0,0\t1,5\t0,0\t-2\r\n1\t0\t1\t\"4e-1\"\r\n");
  CHECK(drive.form == Form::columns);
  CHECK(values(drive, "out") == Values{-2, 0.4});
}

TEST_CASE("rows that repeat a slower group are dropped, two values at one time are not") {
  std::string const text = "Name\ta\tName\tb\nPort\t851\tPort\t851\n";
  auto const recording = read(text + "0\t1\t0\t5\n1\t2\t0\t5\n2\t3\t2\t6\n3\t4\t2\t6\n4\t5\t4\t7\n");
  CHECK(values(recording, "b") == Values{5, 6, 7});
  CHECK(times(recording, "b") == Values{0, 2, 4});
  CHECK(recording.clocks[1].repeated == 2);
  auto const envelope = read(text + "0\t1\t0\t5\n0\t2\t1\t5\n1\t3\t2\t6\n");
  CHECK(envelope.clocks[0].problem == ClockProblem::two_values);
  CHECK(envelope.clocks[0].place.line == 4);
  CHECK_FALSE(envelope.clocks[1].problem.has_value());
  auto const falling = read(text + "1\t1\t0\t5\n0\t2\t1\t5\n");
  CHECK(falling.clocks[0].problem == ClockProblem::falls);
}

TEST_CASE("empty fields are missing samples, texts spoil only their column") {
  auto const recording = read("time;a;b;c\n0;1;;3\n1;;x;4\n2;3;;\n3;4;5;6\n");
  auto const a = values(recording, "a");
  CHECK((a[0] == 1 && std::isnan(a[1]) && a[2] == 3));
  CHECK_FALSE(channel(recording, "a").bad.has_value());
  REQUIRE(channel(recording, "b").bad.has_value());
  CHECK((channel(recording, "b").bad->line == 3 && channel(recording, "b").bad->text == "x"));
  CHECK(std::isnan(values(recording, "c")[2]));
  auto const infinite = read("time;a;b\n0;1;2\n1;inf;3\n");
  CHECK(channel(infinite, "a").bad->text == "inf");
  auto const timeless = read("time;a;b\n0;1;2\n;2;3\n");
  CHECK(timeless.clocks.front().problem == ClockProblem::no_time);
  auto const words = read("Name\ta\tName\tb\nPort\t851\tPort\t851\n0\tTrue\t0\t5\n1\tFalse\t1\t6\n");
  CHECK(channel(words, "a").bad->text == "True");
  CHECK(values(words, "b") == Values{5, 6});
}

TEST_CASE("a file has one decimal mark") {
  CHECK(values(read("a;b\n1,5;2\n2;3,25\n"), "b") == Values{2, 3.25});
  auto bad = refused("a;b\n1,5;2\n2.5;3\n");
  CHECK((bad.problem == RecordingProblem::mixed_marks && bad.line == 3));
  bad = refused("a;b\n1,5;2.5\n");
  CHECK((bad.problem == RecordingProblem::mixed_marks && bad.line == 2));
  // In the table the mark is always that of the system.
  check_table(read(replaced(table, "-0.5", "-0,5")));
}

TEST_CASE("what is not a recording is refused with its place") {
  using enum RecordingProblem;
  CHECK(refused("").problem == no_rows);
  CHECK(refused("EOF\n1,2\n").problem == no_rows);
  CHECK(refused("a\n1\n2\n").problem == no_rows);
  CHECK(refused(table.substr(0, table.find("0\t10"))).problem == no_rows);
  auto bad = refused("1;2\n\n3;4;5\n");
  CHECK((bad.problem == field_count && bad.line == 3 && bad.fields == 3 && bad.expected == 2));
  bad = refused("time;a;b\n0;1;2\n1;2\n");
  CHECK((bad.problem == field_count && bad.line == 3));
  CHECK(refused("1;2\n1;" + std::string(2 * longest_line, '2')).problem == long_line);
  bad = refused(replaced(replaced(table, ".", ","), "\t", ","));
  CHECK((bad.problem == comma_separator && bad.line == 18 && bad.fields == 6 && bad.expected == 5));
  bad = refused("Name\ta\tb\nPort\tPort\t851\n0\t1\n");
  CHECK((bad.problem == bad_table && bad.text == "Port"));
  bad = refused("Name\ta\tName\tb\nPort\t1\tPort\t1\n0\t1\t0\t5\n1\t2\t5\t5\n2\t3\t10\t6\n3\t4\t15\t6\n");
  CHECK((bad.problem == different_spans && bad.line == 6));
}

TEST_CASE("a text is the same whatever pieces it arrives in") {
  for (std::size_t const piece : {1U, 2U, 7U, 1000U}) {
    for (auto const& text : {table, utf16(table, false)}) {
      auto whole = source_of(text);
      auto found = read_text_recording(
          [&](std::span<char> buffer) { return whole(buffer.first(std::min(piece, buffer.size()))); });
      REQUIRE(std::holds_alternative<Recording>(found));
      check_table(std::get<Recording>(found));
    }
  }
}

}  // namespace
}  // namespace axisc::recordings::text_recording_test
