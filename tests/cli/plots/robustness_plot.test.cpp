// The picture of a guard's robustness, against the residual vibration of input shapers in closed form.
#include "cli/program.hpp"
#include "presentation/pictures/projection.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace robustness_plot_test {

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

constexpr double pi = std::numbers::pi;
std::string const sample = AXISC_SOURCE_DIR "/samples/motion/guard/machine.json";

/// Half a period of 20 cycles, so that no impulse is split.
std::string guard(int mode, std::string const& damping = "0", std::string const& frequency = "25") {
  return "vib_guard.active 1\nvib_guard.mode " + std::to_string(mode) + "\nvib_guard.freq " + frequency +
         "\nvib_guard.damping " + damping + "\nEnde\n";
}

Outcome plot(TemporaryFolder const& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {"plot", "x.lis", "--cycle-time", "1ms", "--kind", "robustness"});
  return run_axisc(words, in_folder(folder.path()));
}

/// The value of a row of the printed table.
double value_of(std::string const& table, std::string const& quantity) {
  auto const at = table.find(" " + quantity + " ");
  INFO(table);
  REQUIRE(at != std::string::npos);
  return std::stod(table.substr(at + quantity.size() + 2));
}

struct Place {
  double x = 0, y = 0;
};

/// The first place of the first curve of that class.
Place begin_of(std::string const& svg, std::string const& kind) {
  auto const curve = svg.find("class=\"curve " + kind);
  REQUIRE(curve != std::string::npos);
  std::istringstream path(svg.substr(svg.find(" d=\"M", curve) + 5, 30));
  Place place;
  path >> place.x >> place.y;
  return place;
}

}  // namespace

TEST_CASE("robustness: intervals and curves of undamped shapers are powers of a cosine") {
  // Impulses of 1 : 1, 1 : 2 : 1 and 1 : 3 : 3 : 1, half a period apart, leave |cos(π r/2)|ⁿ of an
  // oscillation at r times the frequency; modes 2 and 4 are the same without damping.
  TemporaryFolder const folder;
  for (auto const& [mode, n] : std::map<int, double>{{1, 1}, {2, 2}, {3, 3}, {4, 2}}) {
    INFO(mode);
    folder.write("x.lis", guard(mode));
    auto const table = plot(folder, {"--table"});
    REQUIRE(table.status == 0);
    double const half = 2 / pi * std::asin(std::pow(0.05, 1 / n));
    CHECK(value_of(table.out, "left at its own frequency [%]") == Approx(0).margin(1e-9));
    CHECK(value_of(table.out, "at most 5 % from [Hz]") == Approx(25 * (1 - half)).epsilon(1e-3));
    CHECK(value_of(table.out, "at most 5 % to [Hz]") == Approx(25 * (1 + half)).epsilon(1e-3));
    CHECK(value_of(table.out, "configured/actual, lowest [%]") ==
          Approx(100 / (1 + half) - 100).epsilon(1e-3));
    CHECK(value_of(table.out, "configured/actual, highest [%]") ==
          Approx(100 / (1 - half) - 100).epsilon(1e-3));
    CHECK(value_of(table.out, "delay [ms]") == Approx(mode == 4 ? 20 : 10 * mode));
    // At half the frequency cos(π/4)ⁿ; the panel is as high as the next ten percent above that.
    double const expected = std::pow(std::cos(pi / 4), n);
    double const highest = std::ceil(10 * expected + 0.1) / 10;
    constexpr double height = 240;
    auto const svg = plot(folder, {"-o", "-"}).out;
    auto const at = svg.find(" y=\"", svg.find("<rect class=\"edge\"")) + 4;
    auto const begin = begin_of(svg, "whole");
    CHECK(begin.x == Approx(axisc::pictures::panel_left));
    double const left = highest * (1 - (begin.y - std::stod(svg.substr(at))) / height);
    CHECK(left == Approx(expected).margin(1e-3));
  }
}

TEST_CASE("robustness: the vendor's guide values lie in the intervals") {
  TemporaryFolder const folder;
  for (int mode = 1; mode <= 4; ++mode) {
    INFO(mode);
    folder.write("x.lis", guard(mode, "0.1", "30"));
    auto const table = plot(folder, {"--table"}).out;
    constexpr std::array<std::array<double, 2>, 4> documented{{{-3, 3}, {-13, 19}, {-20, 33}, {-10, 13}}};
    auto const& [lowest, highest] = documented.at(static_cast<std::size_t>(mode) - 1);
    CHECK(value_of(table, "documented for a damping of 0.1, lowest [%]") == lowest);
    CHECK(value_of(table, "documented for a damping of 0.1, highest [%]") == highest);
    CHECK(value_of(table, "configured/actual, lowest [%]") < lowest);
    CHECK(value_of(table, "configured/actual, highest [%]") > highest);
  }
}

TEST_CASE("robustness: guards of commands are beside those of the lists, equal axes are one curve") {
  TemporaryFolder const folder;
  folder.write("x.lis", "kopf.achs_nr 1\n" + guard(2, "0.1", "30"));
  folder.write("y.lis", "kopf.achs_nr 2\n" + guard(2, "0.1", "30"));
  folder.write("m.json", R"({"cycle_time_us": 1000, "filter_sets": ["#VIB GUARD ON [MODE=4 FREQ=40]"],
    "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}]})");
  auto const there = in_folder(folder.path());
  auto const drawn = run_axisc({"plot", "m.json", "--kind", "robustness", "-o", "-"}, there);
  REQUIRE(drawn.status == 0);
  CHECK_THAT(drawn.out, Contains(">X, Y: mode 2, 30 Hz, damping 0.1</text>") &&
                            Contains(">X, Y, #VIB GUARD ON [MODE=4 FREQ=40]: mode 4, 40 Hz, damping 0.1<"));
  // The image has them, too.
  REQUIRE(run_axisc({"compile", "m.json", "-o", "m.axim", "--quiet"}, there).status == 0);
  CHECK(run_axisc({"plot", "m.axim", "--kind", "robustness", "-o", "-"}, there).out == drawn.out);
  CHECK_THAT(run_axisc({"plot", "m.json", "--kind", "robustness", "--axis", "Y", "-o", "-"}, there).out,
             Contains(">Y: mode 2, 30 Hz, damping 0.1</text>"));
  folder.write("old/x.lis", "kopf.achs_nr 1\n" + guard(1, "0.1", "30"));
  folder.write("old/m.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}]})");
  auto const change = run_axisc(
      {"plot", "m.json", "--kind", "robustness", "--axis", "X", "--before", "old/m.json", "--table"}, there);
  CHECK(change.status == 0);
  // 7.064 and 14.128 ms.
  std::istringstream lines(change.out);
  std::string found;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("delay [ms]") != std::string::npos && found.empty()) found = line;
  }
  std::istringstream cells(found.substr(found.find("[ms]") + 4));
  double before = 0, now = 0, difference = 0;
  cells >> before >> now >> difference;
  CHECK(before == Approx(7.064).epsilon(1e-3));
  CHECK(now == Approx(14.13).epsilon(1e-3));
  CHECK(difference == Approx(7.064).epsilon(1e-3));
}

TEST_CASE("robustness: without a guard nothing is drawn, and options of other kinds are refused") {
  TemporaryFolder const folder;
  folder.write("x.lis", "kopf.achs_nr 1\nEnde\n");
  CHECK_THAT(plot(folder, {"-o", "-"}).out, Contains("No axis has a Vibration Guard."));
  CHECK_THAT(plot(folder, {"-o", "-", "--lang", "de"}).out,
             Contains("Keine Achse hat einen Vibration Guard."));
  for (auto const& wrong : std::vector<std::vector<std::string>>{
           {"--at", "0:#VIB GUARD ON"}, {"--feed", "1000"}, {"--mark", "30Hz"}}) {
    CHECK(plot(folder, wrong).status == 2);
  }
}

TEST_CASE("robustness: approved pictures, in both languages and in the terminal") {
  for (std::string const language : {"en", "de"}) {
    std::vector<std::string> words{"plot", sample, "--kind", "robustness", "--lang", language};
    check_golden("tests/cli/data/golden/plots/terminal.robustness." + language + ".txt",
                 run_axisc(words).out);
    words.insert(words.end(), {"-o", "-"});
    check_golden("tests/cli/data/golden/plots/robustness." + language + ".svg", run_axisc(words).out);
  }
}

}  // namespace robustness_plot_test
