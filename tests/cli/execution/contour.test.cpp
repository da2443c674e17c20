#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

using namespace axisc::test;

namespace {

/// A machine of two axes with one list each.
Surroundings machine(TemporaryFolder const& folder, std::string const& x, std::string const& y,
                     std::string const& cycle_time_us = "1000") {
  std::string const dynamics = "getriebe[0].dynamik.vb_max 500000\ngetriebe[0].dynamik.a_max 10000\nEnde\n";
  folder.write("x.lis", x + dynamics);
  folder.write("y.lis", y + dynamics);
  folder.write("m.json", R"({"machine": "m", "cycle_time_us": )" + cycle_time_us +
                             R"(, "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}],
                              "groups": [{"name": "mill", "axes": ["X", "Y"]}]})");
  return in_folder(folder.path());
}

std::string average(int order) {
  return "filter_fir.type 1\nfilter_fir.order " + std::to_string(order) + "\n";
}

nlohmann::json contour(Surroundings const& there, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"contour", "m.json", "--format", "json"});
  auto const outcome = run_axisc(arguments, there);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return nlohmann::json::parse(outcome.out)["groups"][0];
}

}  // namespace

TEST_CASE("contour deviations as text, CSV and JSON") {
  TemporaryFolder const folder;
  auto const there = machine(folder, average(40), average(40));
  std::vector<std::string> const words = {"contour", "m.json", "--feed",      "1000,2000",
                                          "--order", "40",     "--tolerance", "0.05"};
  for (std::string const form : {"text", "csv", "json"}) {
    auto arguments = words;
    arguments.insert(arguments.end(), {"--format", form});
    auto const outcome = run_axisc(arguments, there);
    CHECK(outcome.status == 0);
    check_golden("tests/cli/data/golden/contour." + form, outcome.out);
  }
  auto arguments = words;
  arguments.insert(arguments.end(), {"--lang", "de"});
  check_golden("tests/cli/data/golden/contour.de.text", run_axisc(arguments, there).out);
}

TEST_CASE("a feed that no axis reaches is remarked") {
  TemporaryFolder const folder;
  auto const there = machine(folder, average(40), average(40));
  CHECK(run_axisc({"contour", "m.json", "--feed", "30000"}, there).err.empty());
  auto const outcome = run_axisc({"contour", "m.json", "--feed", "1000,400000"}, there);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err, Catch::Matchers::Contains("axis X cannot move at 400000 mm/min; its vb_max"));
}

TEST_CASE("the manual's corner and its formula") {
  TemporaryFolder const folder;
  auto const there = machine(folder, average(40), average(40));
  auto const found = contour(there, {"--feed", "1000"});
  CHECK(found["axis_error_um"]["X"].get<double>() == Approx(85.366).margin(0.001));
  CHECK(found["contour_deviation_um"].get<double>() == Approx(120.726).margin(0.001));
  auto const slow = machine(folder, average(40), average(40), "2000");
  CHECK(contour(slow, {})["axis_error_um"]["Y"].get<double>() == Approx(2 * 85.366).margin(0.01));
}

TEST_CASE("feed and order that a tolerance allows") {
  TemporaryFolder const folder;
  auto const there = machine(folder, average(40), average(40));
  auto const found = contour(there, {"--feed", "1000", "--tolerance", "0.02"});
  CHECK(found["allowed_feed_mm_per_min"].get<double>() == Approx(1000 * 20 / 85.3659).epsilon(1e-5));
  // e = v h (h + 1) / (2 (2 h + 1)) of 16.67 µm per cycle: 18.06 µm for h = 4, 22.1 µm for h = 5
  CHECK(found["allowed_order"] == 8);
  // Orders do not widen a windowed sinc without end: its error settles where 1/fcut says.
  std::string const sinc = "filter_fir.type 3\nfilter_fir.fcut 100\nfilter_fir.order 40\n";
  auto const wide = contour(machine(folder, sinc, sinc), {"--feed", "1000", "--tolerance", "0.03"});
  CHECK(wide["allowed_order"] == 200);
}

TEST_CASE("asynchronous axes bend straight lines") {
  TemporaryFolder const folder;
  auto const there = machine(folder, average(40), average(20));
  auto const found = contour(there, {"--feed", "6000"});
  CHECK(found["synchronous"] == false);
  // 100 µm per cycle, 10 cycles apart, halved across a line at 45°
  CHECK(found["line"]["contour_deviation_um"].get<double>() == Approx(500).epsilon(1e-6));
  CHECK_THAT(run_axisc({"contour", "m.json"}, there).out, Catch::Matchers::Contains("lines are bent\n"));
}

TEST_CASE("filters as a command wants them") {
  TemporaryFolder const folder;
  auto const there = machine(folder, average(40), average(40));
  CHECK(contour(there, {"--filter", "#FILTER OFF"})["contour_deviation_um"] == 0);
  auto const half = contour(there, {"--filter", "#FILTER ON [SHARE=50]"});
  CHECK(half["axis_error_um"]["X"].get<double>() == Approx(85.3659 / 2).epsilon(1e-5));
  CHECK_THAT(run_axisc({"contour", "m.json", "--filter", "#FILTER ON [ORDER=999]"}, there).err,
             Catch::Matchers::Contains("is not a #FILTER command"));
}

TEST_CASE("machines with NC programs of their own, whose bytes the image remembers") {
  for (std::string const machine : {"samples/mill/machine.json", "samples/motion/square/machine.json"}) {
    INFO(machine);
    auto const result = run_axisc({"contour", AXISC_SOURCE_DIR "/" + machine, "--feed", "1000"});
    CHECK(result.status == 0);
    CHECK(result.out.find("corner, 90") != std::string::npos);
  }
}

TEST_CASE("what contour refuses") {
  TemporaryFolder const folder;
  auto const there = machine(folder, average(40), average(40));
  for (auto const& words : std::vector<std::vector<std::string>>{{"--feed", "0"},
                                                                 {"--feed", ""},
                                                                 {"--order", "201"},
                                                                 {"--angle", "181"},
                                                                 {"--radius", "-1"},
                                                                 {"--tolerance", "nan"},
                                                                 {"--group", "lathe"}}) {
    auto arguments = words;
    arguments.insert(arguments.begin(), {"contour", "m.json"});
    CHECK(run_axisc(arguments, there).status == 2);
  }
  CHECK(run_axisc({"contour"}, there).status == 2);
  CHECK(run_axisc({"contour", "x.lis", "--alone"}, there).status == 2);
  CHECK(run_axisc({"contour", "x.lis", "--alone", "--cycle-time", "1ms"}, there).status == 0);
  CHECK(run_axisc({"contour", "x.lis"}, there).out == run_axisc({"contour", "m.json"}, there).out);
  machine(folder, "filter[0].enable 1\nfilter[0].type HIGHPASS\nfilter[0].order 1\nfilter[0].fg_f0 10\n", "");
  CHECK_THAT(run_axisc({"contour", "m.json"}, there).err,
             Catch::Matchers::Contains("blocks the constant part"));
  folder.write("x.lis", "filter_fir.type 99\nEnde\n");
  CHECK(run_axisc({"contour", "m.json"}, there).status == 1);
}

TEST_CASE("a channel deviates as in a machine that has no other channel") {
  TemporaryFolder const folder;
  auto const there = machine(folder, average(40), "filter_fir.type 2\nfilter_fir.order 20\n");
  folder.write("z.lis",
               "filter[0].enable 1\nfilter[0].type LOWPASS\nfilter[0].order 2\nfilter[0].fg_f0 30\nEnde\n");
  auto const axis = [](std::string const& name, std::string const& list) {
    return R"({"name": ")" + name + R"(", "list": ")" + list + R"("})";
  };
  auto const write = [&](std::string const& axes, std::string const& groups) {
    folder.write("m.json", R"({"machine": "m", "cycle_time_us": 1000, "axes": [)" + axes +
                               R"(], "groups": [)" + groups + "]}");
  };
  std::string const mill = R"({"name": "mill", "axes": ["X", "Y"]})";
  std::string const lathe = R"({"name": "lathe", "axes": ["C", "Z"]})";
  write(
      axis("Z", "z.lis") + ", " + axis("Y", "y.lis") + ", " + axis("C", "x.lis") + ", " + axis("X", "x.lis"),
      lathe + ", " + mill);
  auto const both_mill = contour(there, {"--group", "mill"});
  auto const both_lathe = contour(there, {"--group", "lathe", "--order", "10"});
  // In the same order: a corner leads from the first axis to the second.
  write(axis("Y", "y.lis") + ", " + axis("X", "x.lis"), mill);
  CHECK(contour(there, {"--group", "mill"}) == both_mill);
  write(axis("Z", "z.lis") + ", " + axis("C", "x.lis"), lathe);
  CHECK(contour(there, {"--group", "lathe", "--order", "10"}) == both_lathe);
}
