// `design` of axisc.json: what a control makes of its filters, from the settings to the setpoints that a
// runtime makes.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <iterator>
#include <sstream>

#include <nlohmann/json.hpp>

namespace readings_test {

using namespace axisc::test;

namespace {

std::string const moving_average = "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 4\nEnde\n";

/// Setpoints behind the filters of an image, of a step by 1 in the first cycle.
std::vector<double> step_answer(Surroundings const& there, std::string const& image) {
  auto const outcome = run_axisc({"run", image, "--signal", "step", "--cycles", "6"}, there);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  std::istringstream rows(outcome.out.substr(outcome.out.find('\n')));
  return {std::istream_iterator<double>(rows), {}};
}

void compile(Surroundings const& there, std::string const& list, std::string const& image) {
  auto const outcome = run_axisc({"compile", list, "-o", image, "--cycle-time", "1ms", "--quiet"}, there);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
}

}  // namespace

TEST_CASE("a runtime executes the reading that the settings ask for") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", moving_average);
  compile(there, "x.lis", "documented.axim");
  folder.write("axisc.json", R"({"design": {"kernels": "documented"}})");
  compile(there, "x.lis", "again.axim");
  CHECK(folder.read("again.axim") == folder.read("documented.axim"));

  folder.write("axisc.json", R"({"design": {"kernels": "taps-n"}})");
  compile(there, "x.lis", "read.axim");
  CHECK(folder.read("read.axim") != folder.read("documented.axim"));
  auto const documented = step_answer(there, "documented.axim");
  auto const read = step_answer(there, "read.axim");
  REQUIRE(documented.size() == 6);
  REQUIRE(read.size() == 6);
  for (std::size_t n = 0; n < read.size(); ++n) {
    CHECK(documented[n] == Approx(std::min(1.0, 0.2 * static_cast<double>(n + 1))));
    CHECK(read[n] == Approx(std::min(1.0, 0.25 * static_cast<double>(n + 1))));
  }
}

TEST_CASE("inspect shows the reading of an image, and diff names it") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write(
      "x.lis",
      "filter[0].enable 1\nfilter[0].type LOWPASS\nfilter[0].order 2\nfilter[0].fg_f0 40\n" + moving_average);
  compile(there, "x.lis", "documented.axim");
  folder.write("axisc.json",
               R"({"design": {"filters": "backward-euler", "kernels": "taps-n", "cycle_time": "double"}})");
  compile(there, "x.lis", "read.axim");
  std::string const readings = "filters: backward-euler, kernels: taps-n, cycle_time: double";
  auto const shown = run_axisc({"inspect", "read.axim"}, there).out;
  CHECK_THAT(shown, Catch::Matchers::Contains("computed as") &&
                        Catch::Matchers::Contains("filters: backward-euler, kernels: taps-n,"));
  CHECK_THAT(run_axisc({"inspect", "documented.axim"}, there).out, !Catch::Matchers::Contains("computed as"));
  auto const json = nlohmann::json::parse(run_axisc({"inspect", "read.axim", "--format", "json"}, there).out);
  CHECK(json["axes"][0]["filters"][0]["reading"] == "backward-euler");
  CHECK(json["axes"][0]["filters"][0]["computed_for"] == "double");
  CHECK(json["kernels"][0]["reading"] == "taps-n");
  CHECK(json["kernels"][0]["computed_for"].is_null());
  auto const difference = run_axisc({"diff", "documented.axim", "read.axim"}, there).out;
  CHECK_THAT(difference, Catch::Matchers::Contains("documented") &&
                             Catch::Matchers::Contains("filters: backward-euler,"));
}

TEST_CASE("what cannot be computed in a reading is named and not compiled") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 150\nEnde\n");
  folder.write("axisc.json", R"({"design": {"kernels": "order-is-half-width"}})");
  auto const wide = run_axisc({"compile", "x.lis", "-o", "x.axim", "--cycle-time", "1ms"}, there);
  CHECK(wide.status == 1);
  CHECK_THAT(wide.err, Catch::Matchers::Contains("filter_fir"));

  folder.write("x.lis",
               "filter[0].enable 1\nfilter[0].type LOWPASS\nfilter[0].order 2\nfilter[0].fg_f0 300\nEnde\n");
  folder.write("axisc.json", R"({"design": {"cycle_time": "double"}})");
  auto const fast = run_axisc({"compile", "x.lis", "-o", "x.axim", "--cycle-time", "1ms"}, there);
  CHECK(fast.status == 2);
  CHECK_THAT(fast.err, Catch::Matchers::Contains("filter[0]"));

  folder.write("axisc.json", R"({"design": {"filters": "forward-euler"}})");
  auto const unstable = run_axisc({"lint", "x.lis", "--cycle-time", "1ms"}, there);
  CHECK(unstable.status == 1);
  CHECK_THAT(unstable.out, Catch::Matchers::Contains("AX6001"));
}

TEST_CASE("readings that nobody knows are refused with those there are") {
  TemporaryFolder const folder;
  folder.write("x.lis", moving_average);
  folder.write("axisc.json", R"({"design": {"filters": "tustin"}})");
  auto const outcome = run_axisc({"lint", "x.lis"}, in_folder(folder.path()));
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Catch::Matchers::Contains("axisc.json:1:24") &&
                              Catch::Matchers::Contains("documented, no-prewarping"));
}

TEST_CASE("settings that compare emits make the recording agree") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  std::string const sample = std::string(AXISC_SOURCE_DIR) + "/samples/recording/";
  std::filesystem::copy(sample + "x.lis", folder / "x.lis");
  std::vector<std::string> const arguments{"compare", "x.lis", sample + "scope.csv", "--cycle-time", "1ms"};
  CHECK(run_axisc(arguments, there).status == 1);
  auto emitting = arguments;
  emitting.insert(emitting.end(), {"--emit", "settings"});
  auto const settings = run_axisc(emitting, there);
  REQUIRE(settings.status == 0);
  CHECK(nlohmann::json::parse(settings.out) == nlohmann::json{{"design", {{"kernels", "taps-n-plus-1"}}}});
  folder.write("axisc.json", settings.out);
  auto const after = run_axisc(arguments, there);
  CHECK(after.status == 0);
  // What already fits is emitted again.
  CHECK(run_axisc(emitting, there).out == settings.out);
  // A reading that the settings ask for, and the control does not have, leads back.
  folder.write("axisc.json", R"({"design": {"kernels": "order-is-half-width"}})");
  CHECK(run_axisc(emitting, there).out == settings.out);
}

TEST_CASE("a recording with #FILTER commands is compared with what they make of the filter") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", "filter_fir.enable 0\nfilter_fir.type 1\nfilter_fir.order 10\nEnde\n");
  folder.write("machine.json",
               R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}], "programs": ["p.nc"]})");
  folder.write("p.nc", "N10 #FILTER ON\nN20 #FILTER OFF\nN30 M30\n");
  auto const compiled = run_axisc({"compile", "machine.json", "-o", "m.axim", "--quiet"}, there);
  INFO(compiled.err);
  REQUIRE(compiled.status == 0);
  std::string setpoints = "X\n";
  for (int n = 0; n < 6000; ++n)
    setpoints += std::to_string(n % 300 < 150 ? 40 * (n % 300) : 12000 - 40 * (n % 300)) + "\n";
  folder.write("setpoints.csv", setpoints);
  std::vector<std::string> const commands{"--at", "1000:#FILTER ON", "--at", "3500:#FILTER OFF"};
  auto const with = [&](std::vector<std::string> words, std::vector<std::string> const& more) {
    words.insert(words.end(), more.begin(), more.end());
    return run_axisc(words, there);
  };
  auto const control = with({"run", "m.axim", "--input", "setpoints.csv"}, commands);
  INFO(control.err);
  REQUIRE(control.status == 0);
  std::istringstream before(setpoints);
  std::istringstream behind(control.out);
  std::string recording;
  for (std::string in, out; std::getline(before, in) && std::getline(behind, out);) {
    recording +=
        recording.empty() ? "in;out\n" : in + ";" + std::to_string(std::lround(std::stod(out))) + "\n";
  }
  folder.write("scope.csv", recording);

  auto const same = with({"compare", "machine.json", "scope.csv"}, commands);
  CHECK(same.status == 0);
  CHECK_THAT(same.out, Catch::Matchers::Contains("the same: the control does what axisc computes"));
  auto const unsaid = with({"compare", "machine.json", "scope.csv"}, {});
  CHECK(unsaid.status == 0);
  CHECK_THAT(unsaid.out, Catch::Matchers::Contains(
                             "found: #FILTER ON at cycle 1000\nfound: #FILTER OFF at cycle 3500\n"));
  auto const early =
      with({"compare", "machine.json", "scope.csv"}, {"--at", "900:#FILTER ON", "--at", "3500:#FILTER OFF"});
  CHECK(early.status == 1);
  CHECK_THAT(early.out, Catch::Matchers::Contains("different"));

  auto const late = with({"compare", "machine.json", "scope.csv"}, {"--at", "6000:#FILTER ON"});
  CHECK(late.status == 2);
  CHECK_THAT(late.err, Catch::Matchers::Contains("there are the cycles 0 to 5999"));
  auto const hasty =
      with({"compare", "machine.json", "scope.csv"}, {"--at", "100:#FILTER ON", "--at", "101:#FILTER OFF"});
  CHECK(hasty.status == 2);
  CHECK_THAT(hasty.err, Catch::Matchers::Contains("still changing over"));
}

}  // namespace readings_test
