// Recordings as scopes write them: which column is what, what its numbers are, and what to record.
#include "../../analysis/recordings/svdx_writer.hpp"
#include "analysis/recordings/svdx/project.hpp"
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

namespace scope_recording_test {

using namespace axisc::test;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

constexpr std::size_t cycles = 1200;

std::vector<double> setpoints(double velocity) {
  std::vector<double> values(cycles, 0.0);
  for (std::size_t n = 1; n < cycles; ++n) {
    double const now = n < 50 || n >= 1100 ? 0 : n < 500 ? velocity : n < 600 ? 0 : -velocity / 3;
    values[n] = std::round(values[n - 1] + now);
  }
  return values;
}

/// By its definition: the mean of the setpoint and of those of eight cycles before it, in whole units.
std::vector<double> averaged(std::vector<double> const& values) {
  std::vector<double> mean(values.size());
  for (std::size_t n = 0; n < values.size(); ++n) {
    double sum = 0;
    for (std::size_t k = 0; k <= 8; ++k) sum += n >= k ? values[n - k] : values[0];
    mean[n] = std::round(sum / 9);
  }
  return mean;
}

/// A column of an export.
struct Column {
  std::string name = "any", type = "INT32";
  std::uint64_t port = 551, group = 0x121301, offset = 0x10061;
  std::vector<double> values = {};
  double factor = 1, add = 0;
  std::string unit = "(None)";
};

std::string exported(std::vector<Column> const& columns) {
  std::string names, types, ports, groups, offsets, factors, adds, units;
  for (auto const& column : columns) {
    auto const add = [](std::string& row, std::string const& key, std::string const& value) {
      row += (row.empty() ? "" : ";") + key + ";" + value;
    };
    add(names, "Name", column.name);
    add(types, "Data-Type", column.type);
    add(ports, "Port", std::to_string(column.port));
    add(groups, "IndexGroup", std::to_string(column.group));
    add(offsets, "IndexOffset", std::to_string(column.offset));
    add(adds, "Offset", std::to_string(column.add));
    add(factors, "ScaleFactor", std::to_string(column.factor));
    add(units, "Unit", column.unit);
  }
  std::string text = "Name;rec\nFile;x.csv\n\n";
  for (auto const& row : {names, types, groups, offsets, ports, adds, factors, units}) text += row + "\n";
  text += "\n";
  for (std::size_t i = 0; i < columns.front().values.size(); ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      text += (k > 0 ? ";" : "") + std::to_string(i) + ";" + std::to_string(columns[k].values[i]);
    }
    text += "\n";
  }
  return text;
}

/// Two axes with one average of nine.
struct Machine {
  TemporaryFolder folder;
  std::vector<double> in = setpoints(800), out = averaged(in);

  Machine() {
    folder.write("x.lis",
                 "kenngr.achs_typ 1\nkopf.achs_nr 5\nfilter_fir.enable 1\nfilter_fir.type "
                 "1\nfilter_fir.order 8\nEnde\n");
    folder.write("y.lis",
                 "kenngr.achs_typ 1\nkopf.achs_nr 7\nfilter_fir.enable 1\nfilter_fir.type "
                 "1\nfilter_fir.order 8\nEnde\n");
    folder.write("m.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"},
      {"name": "Y", "list": "y.lis"}], "groups": [{"name": "channel 1", "axes": ["X", "Y"]}]})");
  }
  [[nodiscard]] Column column(std::string const& name, std::uint64_t offset,
                              std::vector<double> values) const {
    return {.name = name, .offset = offset, .values = std::move(values)};
  }
  [[nodiscard]] std::vector<Column> both() const {
    return {column("soll", 0x10061, in), column("ist", 0x1001C, out)};
  }
  [[nodiscard]] Outcome compare(std::vector<Column> const& columns,
                                std::vector<std::string> more = {}) const {
    folder.write("scope.csv", exported(columns));
    return run(std::move(more));
  }
  [[nodiscard]] Outcome run(std::vector<std::string> more, std::string const& file = "scope.csv") const {
    std::vector<std::string> arguments{"compare", "m.json", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_axisc(arguments, in_folder(folder.path()));
  }
};

json told(Outcome const& outcome) {
  INFO(outcome.err);
  REQUIRE(outcome.status != 2);
  return json::parse(outcome.out);
}

}  // namespace

TEST_CASE("columns are found by their objects, and the recording's only axis is compared") {
  Machine const machine;
  auto columns = machine.both();
  columns.insert(columns.begin(),
                 {.name = "PLC", .port = 851, .group = 16448, .offset = 7, .values = machine.in});
  auto const answer = told(machine.compare(columns, {"--format", "json"}));
  CHECK(answer["verdict"] == "same");
  CHECK(answer["axis"] == "X");
  CHECK(answer["mapping"][0] == json::parse(R"({"signal": "in", "column": "soll", "number": 4,
    "found_by": "object", "unit": "0.1 µm", "numbers": "unscaled", "sample_time_ms": 1})"));
  CHECK(answer["mapping"][1]["column"] == "ist");
  CHECK_THAT(machine.compare(columns).out, Contains("in      soll") && Contains("object"));
  CHECK_THAT(machine.compare(columns, {"--lang", "de"}).out, Contains("gefunden über") && Contains("0,1 µm"));
}

TEST_CASE("the binary file is read as its export") {
  Machine const machine;
  machine.folder.write(
      "scope.svdx", svdx_file({{.name = "soll", .values = machine.in},
                               {.name = "ist", .type = "INT64", .offset = 0x1001C, .values = machine.out}}));
  CHECK(told(machine.run({"--format", "json"}, "scope.svdx"))["verdict"] == "same");
  auto const outcome = machine.run({"--axis", "Y"}, "scope.svdx");
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("no column that is the unfiltered position of axis Y") &&
                              Contains("--in COLUMN") && Contains("\"soll\", \"ist\""));
  machine.folder.write("scope.svdx", machine.folder.read("scope.svdx").substr(0, 9000));
  CHECK_THAT(machine.run({}, "scope.svdx").err,
             Contains("scope.svdx: the file is not as long") && Contains("AX9005"));
}

TEST_CASE("copies are one column, other columns of one object are asked about") {
  Machine const machine;
  auto columns = machine.both();
  columns.push_back(machine.column("ist (1)", 0x1001C, machine.out));
  CHECK(machine.compare(columns).status == 0);
  columns.back().values[700] += 5;
  auto const outcome = machine.compare(columns);
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err,
             Contains("several columns") && Contains("\"ist\", \"ist (1)\"") && Contains("--out COLUMN"));
  CHECK(machine.compare(columns, {"--out", "ist"}).status == 0);
}

TEST_CASE("several axes need --axis, names of a template are enough") {
  Machine const machine;
  auto columns = machine.both();
  columns.push_back(machine.column("other", 0x20061, machine.in));
  columns.push_back(machine.column("another", 0x2001C, machine.out));
  CHECK_THAT(machine.compare(columns).err, Contains("--axis"));
  CHECK(told(machine.compare(columns, {"--axis", "Y", "--format", "json"}))["mapping"][0]["column"] ==
        "other");
  std::vector<Column> named{{.name = "X unfiltered", .port = 851, .group = 1, .values = machine.in},
                            {.name = "X filtered", .port = 851, .group = 1, .values = machine.out}};
  auto const answer = told(machine.compare(named, {"--axis", "X", "--format", "json"}));
  CHECK(answer["mapping"][1]["found_by"] == "name");
}

TEST_CASE("nothing that is recognised is never invented") {
  Machine const machine;
  std::vector<Column> const columns{{.name = "a", .port = 851, .group = 1, .values = machine.in},
                                    {.name = "b", .port = 851, .group = 1, .values = machine.out}};
  auto const outcome = machine.compare(columns, {"--axis", "X"});
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, Contains("scope.csv has no column") && Contains("\"a\", \"b\""));
  CHECK(machine.compare(columns, {"--axis", "X", "--in", "a", "--out", "4"}).status == 0);
}

TEST_CASE("the numbers of a scaled column are raw, scaled, or asked about") {
  Machine const machine;
  auto columns = machine.both();
  auto const scaled = [](std::vector<double> values) {
    for (double& value : values) value = value / 10000 + 5;
    return values;
  };
  // Of 32 bits, 320000 would be a raw number that is too large.
  for (auto& column : columns) {
    column.factor = 0.0001;
    column.add = 5;
  }
  CHECK(told(machine.compare(columns, {"--format", "json"}))["mapping"][0]["numbers"] == "raw");
  for (auto& column : columns) column.type = "INT64";
  auto const open = machine.compare(columns);
  CHECK(open.status == 2);
  CHECK_THAT(open.err, Contains("factor 0.0001, offset 5") && Contains("--scaled or --raw"));
  CHECK_THAT(machine.run({"--lang", "de"}).err, Contains("Faktor 0,0001"));
  auto const raw = told(machine.run({"--raw", "--format", "json"}));
  CHECK((raw["verdict"] == "same" && raw["mapping"][0]["numbers"] == "raw"));
  CHECK(machine.run({"--raw", "--scaled"}).status == 2);
  // Scaled numbers are recognised by their decimals; without a unit the object's raw ones are computed.
  for (auto& column : columns) column.values = scaled(column.name == "soll" ? machine.in : machine.out);
  auto const shown = told(machine.compare(columns, {"--format", "json"}));
  CHECK((shown["verdict"] == "same" && shown["mapping"][0]["numbers"] == "scaled"));
  CHECK(shown["allowed_rms"] == raw["allowed_rms"]);
  // With one, it counts; an unknown one is asked about.
  for (auto& column : columns) column.unit = "mm (Length)";
  auto const millimetres = told(machine.compare(columns, {"--format", "json"}));
  CHECK((millimetres["verdict"] == "same" && millimetres["mapping"][0]["unit"] == "mm"));
  for (auto& column : columns) column.unit = "V (Voltage)";
  CHECK_THAT(machine.compare(columns).err, Contains("V (Voltage)") && Contains("--unit"));
  CHECK(machine.compare(columns, {"--unit", "mm"}).status == 0);
}

TEST_CASE("a recording that left cycles out is refused") {
  Machine const machine;
  std::string text = "time_ms;in;out\n";
  for (std::size_t i = 0; i < cycles; i += 4) {
    text +=
        std::to_string(i) + ";" + std::to_string(machine.in[i]) + ";" + std::to_string(machine.out[i]) + "\n";
  }
  machine.folder.write("scope.csv", text);
  CHECK_THAT(machine.run({"--axis", "X"}).err, Contains("4 ms pass between samples of column \"in\""));
}

TEST_CASE("a template records what compare needs, and its objects are recognised") {
  Machine const machine;
  auto const there = in_folder(machine.folder.path());
  std::vector<std::string> const base{"compare", "m.json", "--emit", "template"};
  auto const emit = [&](std::vector<std::string> more) {
    auto arguments = base;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_axisc(arguments, there);
  };
  CHECK_THAT(emit({}).err, Contains("--netid 1.2.3.4.1.1"));
  CHECK(emit({}).status == 2);
  CHECK_THAT(emit({"--netid", "1.2.3.4"}).err, Contains("six numbers"));
  CHECK(emit({"--netid", "1.2.3.4.5.256"}).status == 2);
  CHECK(emit({"--netid", "1.2.3.4.1.1", "--axis", "Q"}).status == 2);
  // Of a list by itself nobody knows where its control has the axis.
  auto const alone = run_axisc(
      {"compare", "x.lis", "--alone", "--cycle-time", "1ms", "--emit", "template", "--netid", "1.2.3.4.1.1"},
      there);
  CHECK(alone.status == 2);
  CHECK_THAT(alone.err, Contains("x.lis: axis x is in no channel"));
  auto const outcome = emit({"--netid", "1.2.3.4.1.1"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err, Contains("Measurement project"));
  std::string const mark = "\xEF\xBB\xBF";
  REQUIRE(outcome.out.starts_with(mark));
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') ==
        std::count(outcome.out.begin(), outcome.out.end(), '\r'));
  // Identifiers are unique.
  std::multiset<std::string> guids;
  for (std::size_t at = outcome.out.find("<Guid>"); at != std::string::npos;
       at = outcome.out.find("<Guid>", at + 1)) {
    guids.insert(outcome.out.substr(at + 6, 36));
  }
  CHECK(guids.size() > 20);
  CHECK(std::set<std::string>(guids.begin(), guids.end()).size() == guids.size());
  // References resolve, and the objects are those of both axes.
  using namespace axisc::recordings;
  auto const read = read_project(std::string_view(outcome.out).substr(mark.size()), 0);
  REQUIRE(std::holds_alternative<ScopeProject>(read));
  auto const& project = std::get<ScopeProject>(read);
  std::vector<std::pair<std::uint64_t, std::uint64_t>> objects;
  for (auto const& each : project.channels) {
    objects.emplace_back(*each.channel.index_group, *each.channel.index_offset);
  }
  CHECK(objects == std::vector<std::pair<std::uint64_t, std::uint64_t>>{
                       {0x121301, 0x10061}, {0x121301, 0x1001C}, {0x121301, 0x20061}, {0x121301, 0x2001C}});
  CHECK(project.channels[0].channel.name == "X unfiltered");
  CHECK(project.channels[1].channel.data_type == "INT64");
  // Numbers of axes in the groups of axes.
  auto const other = emit({"--netid", "1.2.3.4.1.1", "--axis", "Y", "--for", "identify"});
  CHECK_THAT(other.err, Contains("torque"));
  auto const axis = std::get<ScopeProject>(read_project(std::string_view(other.out).substr(mark.size()), 0));
  REQUIRE(axis.channels.size() == 3);
  CHECK(axis.channels[0].channel.port == 553U);
  CHECK(axis.channels[0].channel.index_offset == 0x70002U);
  CHECK(axis.channels[2].channel.index_offset == 0x7000DU);
}

TEST_CASE("German names the missing column in German") {
  TemporaryFolder const folder;
  folder.write("x.lis", "kopf.achs_nr 1\nEnde\n");
  folder.write("columns.csv", "a,b,c\n1,2,3\n2,3,4\n");
  auto const said = run_axisc({"compare", "x.lis", "columns.csv", "--cycle-time", "1ms", "--lang", "de"},
                              in_folder(folder.path()));
  CHECK_THAT(said.err, Contains("hat keine Spalte für die ungefilterte Position der Achse x;"));
}

}  // namespace scope_recording_test
