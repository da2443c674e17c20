// An FMU of every sample computes what `axisc run` computes: exported, unpacked, compiled and imported.
#include "runtime/c99/random_numbers.hpp"
#include "tests/fmu/imported.hpp"

#include <algorithm>
#include <sstream>

using namespace axisc;
using namespace axisc::test;
using image::FmiVersion;

namespace {

namespace fs = std::filesystem;
constexpr int cycles = 900;

bool axisc_program(std::string const& arguments) {
  return shell(AXISC_PROGRAM " " + arguments + " 2>/dev/null");
}

std::vector<std::string> sample_machines() {
  std::vector<std::string> inputs;
  std::string const samples = AXISC_SOURCE_DIR "/samples";
  for (auto const& entry : fs::recursive_directory_iterator(samples)) {
    bool const is_manual =
        entry.path().parent_path() == samples + "/manual" && entry.path().extension() == ".lis";
    if (entry.path().filename() == "machine.json" || is_manual) inputs.push_back(entry.path().string());
  }
  for (auto const* const folder : {"controller", "controller-project", "controller-xml"}) {
    inputs.push_back(samples + "/" + folder);
  }
  std::sort(inputs.begin(), inputs.end());
  return inputs;
}

/// Exported as `--to` says, without libraries, and unpacked by another program.
UnpackedFmu exported(TemporaryFolder const& folder, std::string const& input, FmiVersion version) {
  bool const is_three = version == FmiVersion::three;
  REQUIRE(axisc_program("export '" + input + "' --cycle-time 1ms --binaries none --to " +
                        (is_three ? "fmu3" : "fmu2") + " -o " + (folder / "sample.fmu")));
  auto const unpacked = folder / (is_three ? "three" : "two");
  fs::create_directories(unpacked);
  REQUIRE(shell("cd " + unpacked + " && " AXISC_CMAKE " -E tar xf ../sample.fmu"));
  return {unpacked, version};
}

/// Commands at cycles: all filters off, then the last of the settings of each channel.
struct Commands {
  std::map<int, std::string> scenario;
  std::string options;  ///< of `axisc run`
};

Commands commands_of(UnpackedFmu const& fmu) {
  Commands commands;
  std::string last;
  std::size_t settings = 0;
  for (auto const type : fmu.description.document_element().child("TypeDefinitions")) {
    if (!std::string_view(type.attribute("name").value()).starts_with("Filter")) continue;
    auto const items = fmu.version == FmiVersion::three ? type : type.child("Enumeration");
    for (auto const item : items.children("Item")) {
      last = item.attribute("value").value();
      settings += 1;
    }
    auto const text = std::string(items.last_child().attribute("name").value());
    commands.options = " --at '50:#FILTER OFF' --at '500:#" +
                       std::string(text.starts_with("VIB") ? text : "FILTER " + text) + "'";
  }
  for (auto const& [name, variable] : fmu.variables) {
    if (!name.ends_with(".filter") || settings < 3) continue;
    commands.scenario[50] += variable + " 1\n";
    commands.scenario[500] += variable + " " + last + "\n";
  }
  return commands;
}

/// What `axisc run` calls a variable: "X", "X.interface", "X.v_set" of inputs, "X.v_add" of outputs.
std::string column_of(std::string name) {
  for (auto const* const suffix : {".setpoint", ".filtered", "_filtered"}) {
    if (name.ends_with(suffix)) name.resize(name.size() - std::string_view(suffix).size());
  }
  std::erase(name, '\'');
  return name;
}

std::vector<std::string> real_variables(UnpackedFmu const& fmu, std::string_view causality) {
  std::vector<std::string> names;
  for (auto const variable : fmu.description.document_element().child("ModelVariables")) {
    std::string const name = variable.attribute("name").value();
    if (variable.attribute("causality").value() == causality && fmu.variable(name).front() == 'f')
      names.push_back(name);
  }
  return names;
}

std::vector<std::string> lines_of(std::string const& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<double> numbers_of_row(std::string row) {
  std::replace(row.begin(), row.end(), ',', ' ');
  return numbers_of(row);
}

/// A sample of mistakes is none.
bool is_compiled(TemporaryFolder const& folder, std::string const& input) {
  return axisc_program("compile --quiet --cycle-time 1ms '" + input + "' -o " + (folder / "sample.axim"));
}

/// How many values were equal. Row n + 1 of an importer's table is row n of `axisc run`.
std::size_t compare(TemporaryFolder const& folder, std::string const& input, FmiVersion version) {
  auto const fmu = exported(folder, input, version);
  fmu.compile();
  auto const inputs = real_variables(fmu, "input");
  auto const commands = commands_of(fmu);
  std::string table, scenario = "init\n";
  for (auto const& name : inputs) table += (table.empty() ? "" : ",") + column_of(name);
  table += "\n";
  Random random(7);
  std::vector<double> position(inputs.size()), velocity(inputs.size());
  for (int cycle = 0; cycle < cycles; ++cycle) {
    if (auto const command = commands.scenario.find(cycle); command != commands.scenario.end()) {
      scenario += command->second;
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      if (random.chance(100)) velocity[i] = random.chance(2) ? 0 : random.between(-800, 800);
      position[i] += velocity[i];
      std::array<char, 32> text{};
      std::snprintf(text.data(), text.size(), "%.17g", position[i]);
      table += (i == 0 ? "" : ",") + std::string(text.data());
      scenario += fmu.variable(inputs[i]) + " " + hexadecimal(position[i]) + "\n";
    }
    table += "\n";
    scenario += "step 1\n";
  }
  auto const rows = folder.write("setpoints.csv", table);
  REQUIRE(is_compiled(folder, input));
  REQUIRE(axisc_program("run --quiet " + (folder / "sample.axim") + " --input " + rows + commands.options +
                        " >" + (folder / "out.csv")));
  auto const expected = lines_of(folder.read("out.csv"));
  auto const outputs = real_variables(fmu, "output");
  std::string header;
  for (auto const& name : outputs) header += (header.empty() ? "" : ",") + column_of(name);
  CHECK(expected.at(0) == header);
  auto const printed = fmu.run(scenario, outputs);
  REQUIRE(printed.size() == cycles + 1);
  REQUIRE(expected.size() == cycles + 1);
  for (std::size_t i = 1; i < expected.size(); ++i) {
    INFO("row " << i);
    REQUIRE(numbers_of(printed[i]) == numbers_of_row(expected[i]));
  }
  return cycles * outputs.size();
}

}  // namespace

TEST_CASE("FMUs of samples compute what run computes") {
  if (!is_installed("cc")) {
    WARN("cc is not installed");
    return;
  }
  std::string const samples = AXISC_SOURCE_DIR "/samples/";
  for (auto const* const sample : {"mill", "motion/guard/machine.json", "manual/position-control.lis",
                                   "manual/hsc-novib.lis", "manual/fir-synchronous", "controller"}) {
    INFO(sample);
    TemporaryFolder const folder;
    CHECK(compare(folder, samples + sample, FmiVersion::three) >= cycles);
    if (sample == std::string_view("mill"))
      CHECK(compare(folder, samples + sample, FmiVersion::two) == 5 * cycles);
  }
}

TEST_CASE("the FMU of every sample computes what run computes", "[.long]") {
  std::size_t values = 0;
  for (auto const& input : sample_machines()) {
    INFO(input);
    TemporaryFolder const folder;
    if (!is_compiled(folder, input)) continue;
    for (auto const version : {FmiVersion::two, FmiVersion::three}) values += compare(folder, input, version);
  }
  CHECK(values > 50'000);
}

TEST_CASE("an FMU discards steps that it cannot take, and takes states back") {
  if (!is_installed("cc")) {
    WARN("cc is not installed");
    return;
  }
  for (auto const version : {FmiVersion::two, FmiVersion::three}) {
    TemporaryFolder const folder;
    auto const fmu = exported(folder, AXISC_SOURCE_DIR "/samples/mill/machine.json", version);
    fmu.compile();
    auto const x = fmu.variable("X.setpoint"), filter = fmu.variable("CH1.filter");
    std::string const move = x + " 20000\nstep 1\nstep 1\n" + filter + " 5\nstep 3\n";
    std::string scenario =
        x + " 10000\ninit\n" + x + " 12000\nstep 1\nkeep\n" + move + "late\n" + x + " 12000\n";
    for (int i = 0; i < 10; ++i) scenario += "restore\n" + move;
    auto const printed = fmu.run(scenario + "reset\n" + x + " 10000\ninit\n",
                                 {"X.filtered", "X.settled", "CH1.filter_status"});
    REQUIRE(printed.size() == 2 + 3 + 2 + 30 + 1);
    CHECK(numbers_of(printed.at(0)) == std::vector<double>{10000, 1, 0});
    CHECK(printed.at(5).find("a step takes a whole number of NC cycles") != std::string::npos);
    CHECK(printed.at(6) == "status 2");
    for (std::size_t i = 0; i < 30; ++i) CHECK(printed.at(7 + i) == printed.at(2 + i % 3));
    CHECK(printed.back() == printed.front());
    auto const refused = fmu.run("", {}, "54b92283");
    CHECK(refused.back() == "failed");
    CHECK(refused.front().find("this FMU is for another machine") != std::string::npos);
    auto const wrong = fmu.run("init\n" + fmu.variable("X.filtered") + " 1\n" + filter + " 9\nf999 1\n", {});
    REQUIRE(wrong.size() == 1 + 6);
    CHECK(wrong.at(1).find("only inputs can be set") != std::string::npos);
    CHECK(wrong.at(3).find("the channel has no filter setting of this number") != std::string::npos);
    CHECK(wrong.at(5).find("no variable of this type") != std::string::npos);
  }
}

TEST_CASE(
    "the sources of an FMU compile without a warning, as C and as C++, shared, static and without memory") {
  if (!is_installed("cc")) {
    WARN("cc is not installed");
    return;
  }
  TemporaryFolder const folder;
  for (auto const version : {FmiVersion::two, FmiVersion::three}) {
    auto const fmu = exported(folder, AXISC_SOURCE_DIR "/samples/mill/machine.json", version);
    std::string const interface = version == FmiVersion::two ? "fmi2.c" : "fmi3.c";
    for (std::string const compiler :
         {"gcc -std=c99", "clang -std=c99", "g++ -std=c++14 -x c++", "clang++ -std=c++14 -x c++"}) {
      if (!is_installed(compiler.substr(0, compiler.find(' ')))) {
        WARN(compiler << " is not installed");
        continue;
      }
      for (std::string const option :
           {"", " -DAXISC_FMU_STATIC=2 -DFMI2_OVERRIDE_FUNCTION_PREFIX -DFMI3_OVERRIDE_FUNCTION_PREFIX"}) {
        INFO(compiler << option);
        CHECK(shell("cd " + fmu.folder + "/sources && " + compiler +
                    " -pedantic -Wall -Wextra -Werror -fsyntax-only machine.c fmu_core.c " + interface +
                    option));
      }
    }
    // Without an override, functions have the model's prefix.
    REQUIRE(shell("cd " + fmu.folder + "/sources && cc -std=c99 -c " + interface + " -o ../interface.o"));
    CHECK(shell("nm " + fmu.folder + "/interface.o | grep -q ' T sample_fmi[23]DoStep'"));
    // Two blocks: an instance and a state, and no more.
    REQUIRE(shell("cd " + fmu.folder +
                  "/sources && cc -std=c99 -fPIC -shared -DAXISC_FMU_STATIC=2 -DFMI2_OVERRIDE_FUNCTION_PREFIX"
                  " -DFMI3_OVERRIDE_FUNCTION_PREFIX axisrt_c.c machine.c fmu_core.c " +
                  interface + " -o ../library.so"));
    CHECK(shell("! nm -D " + fmu.folder + "/library.so | grep -qE ' (calloc|malloc)'"));
    auto const x = fmu.variable("X.setpoint");
    auto const printed = fmu.run("init\n" + x + " 500\nkeep\nstep 1\nrestore\nstep 1\n", {"X.filtered"});
    REQUIRE(printed.size() == 3);
    CHECK(printed[1] == printed[2]);
  }
}

TEST_CASE("an FMU is small") {
  TemporaryFolder const folder;
  auto const fmu = folder / "mill.fmu";
  std::string const line = "export " AXISC_SOURCE_DIR "/samples/mill/machine.json --to fmu3 -o " + fmu;
  REQUIRE(axisc_program(line + " --binaries none"));
  CHECK(fs::file_size(fmu) < 35'000);
  if (!is_installed("cc") || !is_installed("x86_64-w64-mingw32-gcc-posix")) {
    WARN("cc or MinGW is not installed");
    return;
  }
  REQUIRE(axisc_program(line + " --binaries linux64,win64"));
  CHECK(fs::file_size(fmu) < 70'000);
}

TEST_CASE("libraries of an FMU compute the same under Windows", "[.long]") {
  std::string const compiler = "x86_64-w64-mingw32-gcc-posix", wine = "/usr/lib/wine/wine64";
  if (!is_installed(compiler) || !is_installed(wine)) {
    WARN("MinGW or wine is not installed");
    return;
  }
  TemporaryFolder const folder;
  for (std::string const version : {"2", "3"}) {
    REQUIRE(axisc_program("export " AXISC_SOURCE_DIR
                          "/samples/mill/machine.json --binaries linux64,win64 --to fmu" +
                          version + " -o " + (folder / "mill.fmu")));
    auto const place = folder / version;
    fs::create_directories(place);
    REQUIRE(shell("cd " + place + " && " AXISC_CMAKE " -E tar xf ../mill.fmu"));
    UnpackedFmu const fmu(place, version == "2" ? FmiVersion::two : FmiVersion::three);
    fs::copy_file(place + (version == "2" ? "/binaries/linux64/mill.so" : "/binaries/x86_64-linux/mill.so"),
                  place + "/library.so");
    std::string scenario = "init\n";
    Random random(3);
    for (int cycle = 0; cycle < 500; ++cycle) {
      for (auto const* const axis : {"X", "Y", "Z", "S"}) {
        scenario += fmu.variable(std::string(axis) + ".setpoint") + " " +
                    hexadecimal(random.between(-1e4, 1e4)) + "\n";
      }
      if (cycle % 100 == 50)
        scenario += fmu.variable("CH1.filter") + " " + std::to_string(random.below(6)) + "\n";
      scenario += "step 1\n";
    }
    auto const expected = fmu.run(scenario, fmu.outputs());
    REQUIRE(expected.size() == 501);
    auto const dll = version == "2" ? "/binaries/win64/mill.dll" : "/binaries/x86_64-windows/mill.dll";
    auto const token =
        fmu.description.document_element().attribute(version == "2" ? "guid" : "instantiationToken").value();
    REQUIRE(shell(compiler + " -DFMI=" + version + " " AXISC_SOURCE_DIR "/tests/fmu/importer.c -o " + place +
                  "/importer.exe"));
    std::string line = "cd " + place + " && WINEDEBUG=-all WINEPREFIX=" + (folder / "wine") + " " + wine +
                       " importer.exe ." + dll + " " + token + " 0.001";
    for (auto const& name : fmu.outputs()) line += " " + fmu.variable(name);
    REQUIRE(shell(line + " <scenario 2>/dev/null | tr -d '\\r' >of_windows"));
    std::string linux_lines;
    for (auto const& each : expected) linux_lines += each + "\n";
    CHECK(folder.read(version + "/of_windows") == linux_lines);
  }
}
