#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace contour_test {

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

/// Without the line breaks of paragraphs.
std::string on_one_line(std::string const& text) {
  std::string joined;
  for (char const c : text) {
    bool const is_blank = c == '\n' || c == ' ';
    if (!is_blank || joined.empty() || joined.back() != ' ') joined += is_blank ? ' ' : c;
  }
  return joined;
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
             Catch::Matchers::Contains("cannot be used: `ORDER=999` is out of range (0 ≤ ORDER ≤ 200"));
}

TEST_CASE("machines with NC programs of their own, whose bytes the image remembers") {
  for (std::string const machine : {"samples/mill/machine.json", "samples/motion/square/machine.json"}) {
    INFO(machine);
    auto const result = run_axisc({"contour", AXISC_SOURCE_DIR "/" + machine, "--feed", "1000"});
    CHECK(result.status == 0);
    CHECK(result.out.find("corner, 90") != std::string::npos);
  }
}

TEST_CASE("a corner as the control passes it: slope, weights and ramps of the lists") {
  TemporaryFolder const folder;
  auto const there = machine(folder, average(40), average(40));
  // Without a channel list STEP and 1000 mm/s²: a T = 1 mm/s.
  auto const by_default = contour(there, {"--feed", "6000"});
  CHECK(by_default["slope"] == "STEP");
  CHECK(by_default["channel_list"] == false);
  CHECK(by_default["corner_passage"][0]["velocity_mm_s"].get<double>() == Approx(1));
  CHECK(by_default["corner_passage"][0]["braking_ms"].get<double>() == Approx(99));
  CHECK(by_default["corner_passage"][0]["slowed_by_axis"] == "X");

  // The vendor's stock lists with TRAPEZ: 2000 mm/s² in 300 ms, weight 0.
  std::string ramps;
  for (std::string const name : {"a_beschl 2000", "a_brems 2000", "tr_beschl_zu 300000",
                                 "tr_beschl_ab 300000", "tr_brems_zu 300000", "tr_brems_ab 300000"}) {
    ramps += "getriebe[0].slope_profil." + name + "\n";
  }
  machine(folder, average(40) + ramps, average(40) + ramps);
  folder.write("channel.lis", "prog_start.slope.profile 1\nEnde\n");
  folder.write("m.json", R"({"machine": "m", "cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"},
                             {"name": "Y", "list": "y.lis"}], "groups": [{"name": "mill", "axes": ["X", "Y"],
                             "channel_list": "channel.lis"}]})");
  auto const found = contour(there, {"--feed", "6000,4000"});
  CHECK(found["slope"] == "TRAPEZ");
  CHECK(found["channel_list"] == true);
  auto const& passage = found["corner_passage"][0];
  // a T²/tr; from 100 mm/s √(2 Δ t̄ / a), as 600 mm/s would take the acceleration's ramps.
  CHECK(passage["velocity_mm_s"].get<double>() == Approx(2000 * 1e-6 / 0.3));
  CHECK(passage["braking_ms"].get<double>() ==
        Approx(1000 * std::sqrt(2 * 99.99333 * 0.6 / 2000)).epsilon(1e-6));
  CHECK(passage["axis_step_mm_s"].get<double>() == Approx(2000 * 1e-6 / 0.3));
  CHECK(found["corner_passage"][1]["feed_mm_per_min"] == 4000);
  // What is left of the corner is what the ramps pass within the filter's reach: j t³/6 along each leg, with
  // j = q a / (q tr) = 6667 mm/s³, 41 taps: Σ k³ j T³ / 6 / 41 = 44100 · 6.667 µm / 6000 / 41.
  double const left = 44100 * 6.6667 / 6000 / 41 + 210 * 0.0066667 / 41;
  CHECK(found["corner_as_passed"]["max_axis_error_um"].get<double>() == Approx(left).epsilon(1e-3));
  for (std::string const form : {"text", "de.text", "markdown", "html"}) {
    std::vector<std::string> words{"contour", "m.json", "--feed", "6000"};
    if (form == "de.text") words.insert(words.end(), {"--lang", "de"});
    if (form == "markdown" || form == "html") words.insert(words.end(), {"--format", form});
    auto const text = on_one_line(run_axisc(words, there).out);
    INFO(text);
    CHECK(text.find(form == "de.text" ? "hält dort fast an" : "nearly stops there") != std::string::npos);
  }
  auto const csv = run_axisc({"contour", "m.json", "--format", "csv"}, there).out;
  CHECK(csv.find("mill,1000,,corner_as_passed,") != std::string::npos);
  // The second row of the answer at 6000 mm/min, whose other rows have none.
  CHECK(found["table"][1]["velocity_mm_s"] == passage["velocity_mm_s"]);
  CHECK(found["table"][1]["braking_mm"] == passage["braking_mm"]);
  CHECK(found["table"][0]["velocity_mm_s"].is_null());
  CHECK(found["table"][6]["braking_ms"] == found["corner_passage"][1]["braking_ms"]);

  // A weight, and a slow feed that needs none.
  std::string const weight = "getriebe[0].dynamik.a_trans_weight 500\n";
  folder.write("x.lis", ramps + weight + "getriebe[0].dynamik.a_max 2000\nEnde\n");
  folder.write("y.lis", ramps + weight + "getriebe[0].dynamik.a_max 2000\nEnde\n");
  auto const weighted = contour(there, {"--angle", "45"});
  CHECK(weighted["corner_passage"][0]["velocity_mm_s"].get<double>() == Approx(1.41421).epsilon(1e-5));
  CHECK_THAT(run_axisc({"contour", "m.json"}, there).out, Catch::Matchers::Contains("500 ‰ of a T"));
  auto const slow = contour(there, {"--feed", "30"});
  CHECK(slow["corner_passage"][0]["slowed_by_axis"].is_null());
  CHECK(slow["corner_passage"][0]["braking_ms"] == 0);
  CHECK_THAT(run_axisc({"contour", "m.json", "--feed", "30"}, there).out,
             Catch::Matchers::Contains("passes this corner without braking"));
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

}  // namespace contour_test
