// The circular test at the command line. The sample is computed by another program,
// tests/analysis/circle/circle_recordings.py: a moving average of 21 values, X 0.15 ms later than
// Y, 3 µm of backlash in X, spikes of 4 µm in Y.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

using namespace axisc::test;
using nlohmann::json;

namespace {

struct Sample {
  TemporaryFolder folder;

  Sample() {
    for (std::string const name : {"machine.json", "x.lis", "y.lis", "ccw.csv", "cw.csv"}) {
      folder.write(name, read_source_file("samples/circle/" + name));
    }
  }
  [[nodiscard]] Outcome run(std::vector<std::string> more) const {
    more.insert(more.begin(), {"circle", "machine.json"});
    return run_axisc(more, in_folder(folder.path()));
  }
  [[nodiscard]] json circle(std::vector<std::string> more) const {
    more.insert(more.end(), {"--format", "json"});
    auto const outcome = run(more);
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return json::parse(outcome.out)["circles"][0];
  }
  void check_refused(std::vector<std::string> const& more, std::string const& what) const {
    auto const outcome = run(more);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find(what) != std::string::npos);
  }
};

/// Columns of a file with a line of names, each value changed by `change(row, column, value)`.
template <class Change>
std::string changed(std::string const& text, Change change) {
  std::istringstream lines(text);
  std::string line, all;
  std::getline(lines, line);
  all = line + "\n";
  for (int row = 0; std::getline(lines, line); ++row) {
    std::istringstream fields(line);
    std::ostringstream made;
    made.precision(12);
    std::string field;
    for (int column = 0; std::getline(fields, field, ';'); ++column) {
      made << (column > 0 ? ";" : "") << change(row, column, std::stod(field));
    }
    all += made.str() + "\n";
  }
  return all;
}

std::string first_lines(std::string const& text, std::size_t count) {
  std::size_t end = 0;
  while (count-- > 0) end = text.find('\n', end) + 1;
  return text.substr(0, end);
}

/// Of a moving average of n values: R (1 - sin(nθ/2)/(n sin(θ/2))) at R = 10 mm, 50 mm/s, 2 ms.
double shrunk_um() {
  double const theta = 50.0 / 10 * 0.002;
  return 1e4 * (std::sin(21 * theta / 2) / (21 * std::sin(theta / 2)) - 1);
}

}  // namespace

TEST_CASE("circle: the answer in words, in both languages") {
  Sample const sample;
  for (std::string const language : {"en", "de"}) {
    auto const predicted =
        sample.run({"--feed", "1000,3000", "--radius", "10", "--tolerance", "10", "--lang", language});
    CHECK(predicted.status == 0);
    check_golden("tests/cli/circle/data/predicted." + language + ".text", predicted.out);
    auto const recorded = sample.run({"ccw.csv", "cw.csv", "--lang", language});
    CHECK(recorded.status == 0);
    check_golden("tests/cli/circle/data/recorded." + language + ".text", recorded.out);
  }
}

TEST_CASE("circle: what the sample was made of is found again") {
  Sample const sample;
  auto const found = sample.circle({"ccw.csv", "--recording", "cw.csv"});
  auto const& causes = found["recording"]["causes"];
  CHECK(causes["delay_difference_us"].get<double>() == Approx(150).margin(0.5));
  CHECK(causes["backlash_um"][0].get<double>() == Approx(3).margin(0.05));
  CHECK(causes["backlash_um"][1].get<double>() == Approx(0).margin(0.05));
  CHECK(causes["radius_um"].get<double>() == Approx(shrunk_um()).margin(0.05));
  CHECK(causes["spike_um"]["ccw v+"].get<double>() == Approx(4).margin(0.9));
  CHECK(found["prediction"]["mean_radial_deviation_um"].get<double>() == Approx(shrunk_um()).margin(1e-6));
  CHECK(found["radius_mm"].get<double>() == Approx(10).margin(1e-5));
  CHECK(found["feed_mm_per_min"].get<double>() == Approx(3000).margin(0.1));
  CHECK(found["recording"]["reference"] == "setpoint");
}

TEST_CASE("circle: predictions are those of an independent program") {
  auto const path = std::filesystem::path(AXISC_SOURCE_DIR) / "../shared/reference/circle.json";
  std::ifstream file(path);
  if (!file) {
    WARN("no reference figures at " << path.string() << ": skipped");
    return;
  }
  auto const cases = json::parse(file)["cases"];
  CHECK(cases.size() > 0);
  for (auto const& given : cases) {
    if (given["kind"] != "prediction") continue;
    INFO(given["id"]);
    TemporaryFolder const folder;
    json machine{{"cycle_time_us", given["cycle_time_us"]}, {"axes", json::array()}};
    for (auto const& [name, lines] : given["lists"].items()) {
      std::string list = "kopf.log_achs_name " + name + "\nkenngr.achs_typ 1\n";
      for (auto const& line : lines) list += line.get<std::string>() + "\n";
      folder.write(name + ".lis", list + "Ende\n");
      machine["axes"].push_back({{"name", name}, {"list", name + ".lis"}});
    }
    machine["groups"] = json::array({{{"axes", {"X", "Y"}}}});
    folder.write("machine.json", machine.dump());
    auto const outcome = run_axisc({"circle", "machine.json", "--feed", given["feed_mm_per_min"].dump(),
                                    "--radius", given["radius_mm"].dump(), "--format", "json"},
                                   in_folder(folder.path()));
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    auto const prediction = json::parse(outcome.out)["circles"][0]["prediction"];
    auto const& expected = given["expected"];
    double const um = given["tolerance"]["um"];
    auto const check = [](json const& wanted, json const& found, double tolerance) {
      CHECK(found.get<double>() == Approx(wanted.get<double>()).epsilon(0).margin(tolerance));
    };
    for (std::string const key :
         {"bidirectional_circular_deviation_um", "mean_radial_deviation_um", "hysteresis_um"}) {
      check(expected[key], prediction[key], um);
    }
    check(expected["circular_deviation_um"]["ccw"], prediction["circular_deviation_um"]["ccw"], um);
    check(expected["radial_deviation_um"]["max"], prediction["radial_deviation_um"]["max"], um);
    check(expected["radial_deviation_um"]["min"], prediction["radial_deviation_um"]["min"], um);
    auto const& causes = prediction["causes"];
    check(expected["causes"]["radius_um"], causes["radius_um"], um);
    check(expected["causes"]["gain_difference"], causes["gain_difference"], given["tolerance"]["gain"]);
    check(expected["causes"]["delay_difference_us"], causes["delay_difference_us"], given["tolerance"]["us"]);
    std::size_t row = 0;
    for (auto const& axis : expected["causes"]["filters_um"]) {
      for (auto const& filter : axis) {
        CHECK(causes["filters_um"][row]["filter"] == filter[0]);
        check(filter[1], causes["filters_um"][row++]["radius_um"], um);
      }
    }
    CHECK(causes["filters_um"].size() == row);
  }
}

TEST_CASE("circle: the prediction is what contour says of the circle") {
  auto const there = in_folder(AXISC_SOURCE_DIR);
  auto const contour = json::parse(
      run_axisc({"contour", "samples/mill", "--feed", "4000", "--radius", "10", "--format", "json"}, there)
          .out);
  auto const circle = json::parse(
      run_axisc({"circle", "samples/mill", "--feed", "4000", "--radius", "10", "--format", "json"}, there)
          .out);
  double largest = 0;
  for (auto const& one : circle["circles"]) {
    auto const& radial = one["prediction"]["radial_deviation_um"];
    largest =
        std::max({largest, std::abs(radial["max"].get<double>()), std::abs(radial["min"].get<double>())});
  }
  CHECK(largest ==
        Approx(contour["groups"][0]["circle"]["contour_deviation_um"].get<double>()).epsilon(1e-5));
}

TEST_CASE("circle: recordings that are no test are refused") {
  Sample const sample;
  auto const ccw = read_source_file("samples/circle/ccw.csv");
  auto const cw = read_source_file("samples/circle/cw.csv");
  auto const write = [&](std::string const& text) { sample.folder.write("bad.csv", text); };

  write(first_lines(ccw, 600));
  sample.check_refused({"bad.csv"}, "bad.csv: 319° of the circle at constant speed");
  sample.check_refused({"ccw.csv", "ccw.csv"}, "another recording has this direction already (X → Y)");

  // Every twelfth NC cycle: 52 points in a turn.
  std::istringstream lines(ccw);
  std::string text, line;
  for (int i = 0; std::getline(lines, line); ++i) {
    if (i == 0 || (i - 1) % 12 == 0) text += line + "\n";
  }
  write(text);
  sample.check_refused({"bad.csv"}, "54 points in a turn, and 120 are needed");

  // A circle of 10.2 mm in the same time.
  write(changed(cw, [](int, int column, double value) {
    double const centre = column % 2 == 1 ? 120 : 80;
    return column == 0 ? value : centre + (value - centre) * 1.02;
  }));
  sample.check_refused({"ccw.csv", "bad.csv"}, "the radii of the two directions are 10 mm and 10.2 mm");

  // The same circle, 2 % slower.
  write(changed(cw, [](int row, int column, double value) {
    if (column == 0) return value;
    double const angle = row * 0.002 * 50 / 10 / 1.02;
    return column % 2 == 1 ? 120 + 10 * std::cos(angle) : 80 - 10 * std::sin(angle);
  }));
  sample.check_refused({"ccw.csv", "bad.csv"}, "the feeds of the two directions are 3000 and 2941.2");

  write(changed(ccw, [](int, int column, double value) { return column == 0 ? value : 5.0; }));
  sample.check_refused({"bad.csv"}, "the axes do not move");
  write(changed(ccw, [](int row, int column, double value) { return column == 0 ? value : row * 0.1; }));
  sample.check_refused({"bad.csv"}, "the path at constant speed is not a circle");

  sample.check_refused({"ccw.csv", "--radius", "20"}, "--radius 20: the recorded circle has 10 mm");
  sample.check_refused({"ccw.csv", "--feed", "500"}, "--feed 500: the recorded circle has 3000");
  sample.check_refused({}, "a circle needs --feed and --radius");
  sample.check_refused({"--feed", "1000", "--radius", "10", "--plane", "XZ"},
                       "--plane needs two of the axes X, Y");
  sample.check_refused({"ccw.csv", "--actual", "X"}, "--actual X=COLUMN");
  sample.check_refused({"missing.csv"}, "missing.csv");
  sample.check_refused({"ccw.csv", "--setpoint", "Q=2"}, "there is no axis \"Q\"; the axes are X, Y");
  sample.check_refused({"ccw.csv", "--feed", "3000,77"}, "a recording has one feed");
  sample.check_refused({"--feed", "3000", "--radius", "10", "--external"}, "are about a recording; name one");
  sample.check_refused({"ccw.csv", "--external", "--actual", "X=2"},
                       "--external a measuring instrument's file");
}

TEST_CASE("circle: a modulo axis cannot be measured") {
  Sample const sample;
  auto list = read_source_file("samples/circle/x.lis");
  list.insert(list.find("Ende"), "kenngr.achs_mode 0x4\ngetriebe[0].moduloo 3600000\n");
  sample.folder.write("x.lis", list);
  sample.check_refused({"ccw.csv", "cw.csv", "--cycle-time", "2ms"}, "axis X is a modulo axis");
}

TEST_CASE("circle: one direction, no setpoint, fewer points") {
  Sample const sample;
  auto const one = sample.circle({"ccw.csv"});
  CHECK(one["recording"]["causes"].is_null());
  CHECK(one["recording"]["circular_deviation_um"]["cw"].is_null());
  CHECK(one["recording"]["circular_deviation_um"]["ccw"].get<double>() == Approx(9.78).margin(0.01));

  // Only the actual positions, every fourth NC cycle.
  std::vector<std::string> names;
  for (std::string const name : {"ccw.csv", "cw.csv"}) {
    std::istringstream lines(read_source_file("samples/circle/" + name));
    std::string text = "time [ms];X actual;Y actual\n", line;
    std::getline(lines, line);
    for (int i = 0; std::getline(lines, line); ++i) {
      if (i % 4 != 0) continue;
      auto const time = line.substr(0, line.find(';'));
      auto const second = line.rfind(';');
      text += time + line.substr(line.rfind(';', second - 1)) + "\n";
    }
    names.push_back("actual-" + name);
    sample.folder.write(names.back(), text);
  }
  sample.check_refused(names, "the radius is not known; give it with --radius");
  sample.check_refused({names[0], names[1], "--radius", "20"}, "a circle of 9.98");
  sample.check_refused({"ccw.csv", names[1], "--radius", "10"},
                       "one recording has setpoints, the other has none");
  names.insert(names.end(), {"--radius", "10"});
  auto const actual = sample.circle(names);
  CHECK(actual["recording"]["reference"] == "least-squares");
  CHECK(actual["recording"]["points_per_turn"] == 159);
  CHECK(actual["recording"]["causes"]["delay_difference_us"].get<double>() == Approx(150).margin(3));
  auto const words = sample.run(names).out;
  CHECK(words.find("there are no setpoints") != std::string::npos);
  CHECK(words.find("159 points in a turn") != std::string::npos);
}

TEST_CASE("circle: friction that looks like backlash is given as neither") {
  Sample const sample;
  for (std::string const name : {"ccw.csv", "cw.csv"}) {
    double time = 0;
    sample.folder.write(
        name, changed(read_source_file("samples/circle/" + name), [&](int, int column, double value) {
          if (column == 0) time = value / 1000;
          if (column != 3) return value;
          // X sticks by 5 µm after each reversal, and lets go slowly.
          double const angle = 5 * (time - 0.0215);
          double const since = (angle - std::floor(angle / 3.14159265358979) * 3.14159265358979) / 5;
          return value + (std::sin(angle) > 0 ? 0.005 : -0.005) * std::exp(-since / 0.05);
        }));
  }
  auto const found = sample.circle({"ccw.csv", "cw.csv"});
  CHECK(found["recording"]["backlash_and_friction_separable"] == false);
  CHECK(found["recording"]["causes"]["backlash_um"].is_null());
  auto const words = sample.run({"ccw.csv", "cw.csv"}).out;
  CHECK(words.find("backlash and friction cannot be told apart") != std::string::npos);
  CHECK(words.find("backlash X") == std::string::npos);
}

TEST_CASE("circle: a measuring instrument's file") {
  Sample const sample;
  // The axes are 30 µm/m from square, the circle is 5 µm too large.
  std::string text = "angle_deg;deviation_um\n";
  auto const add = [&text](double angle) {
    double const theta = angle * 3.14159265358979 / 180;
    text += std::to_string(angle) + ";" + std::to_string(5 - 100e3 * 30e-6 / 2 * std::sin(2 * theta)) + "\n";
  };
  for (int i = 0; i <= 720; ++i) add(i / 2.0);
  for (int i = 720; i >= 0; --i) add(i / 2.0);
  sample.folder.write("bar.csv", text);
  auto const found = sample.circle({"bar.csv", "--external", "--feed", "1000", "--radius", "100"});
  CHECK(found["recording"]["external"] == true);
  CHECK(found["recording"]["causes"]["squareness_um_per_m"].get<double>() == Approx(30).margin(0.01));
  CHECK(found["recording"]["mean_radial_deviation_um"].get<double>() == Approx(5).margin(0.01));
  auto const words = sample.run({"bar.csv", "--external", "--feed", "1000", "--radius", "100"}).out;
  CHECK(words.find("squareness") != std::string::npos);
  sample.check_refused({"bar.csv", "--external", "--radius", "100"}, "give it with --feed");
  sample.check_refused({"bar.csv", "--external", "--feed", "100"}, "give it with --radius");
}

TEST_CASE("circle: tolerance, axes out of step, and the picture") {
  Sample const sample;
  auto const list = read_source_file("samples/circle/x.lis");
  auto longer = list;
  longer.replace(longer.find("20\n"), 2, "24");
  sample.folder.write("x.lis", longer);
  // An error for every other command.
  sample.folder.write("axisc.json", R"({"severity": {"AX4011": "error"}})");
  CHECK(sample.run({"--feed", "3000", "--radius", "10"}).status == 0);
  auto const found = sample.circle({"--feed", "3000", "--radius", "10"});
  // 50 mm/s, 2 cycles of 2 ms.
  CHECK(found["prediction"]["circular_deviation_um"]["ccw"].get<double>() == Approx(200).epsilon(0.01));
  CHECK(run_axisc({"contour", "machine.json"}, in_folder(sample.folder.path())).status == 1);
  CHECK(sample.run({"--feed", "3000", "--radius", "10", "--tolerance", "150"}).status == 1);
  sample.folder.write("x.lis", list);
  CHECK(sample.run({"ccw.csv", "cw.csv", "--tolerance", "9.5"}).status == 1);
  auto const drawn = sample.run({"ccw.csv", "cw.csv", "--tolerance", "10", "-o", "-"});
  CHECK(drawn.status == 0);
  for (std::string const part : {"<svg", "deviations × 100", ">tolerance<", ">predicted, X → Y<", ">Y → X<",
                                 ">delay X - Y: 7.49 µm<", ">backlash X: 3.01 µm<"}) {
    INFO(part);
    CHECK(drawn.out.find(part) != std::string::npos);
  }
  sample.check_refused({"ccw.csv", "cw.csv", "-o", "ccw.csv"}, "ccw.csv");
}
