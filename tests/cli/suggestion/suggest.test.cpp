#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <sstream>

#include <nlohmann/json.hpp>

namespace suggest_test {

using namespace axisc::test;

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string const resonance = "48Hz:0.02";

/// The sample in a folder of its own.
Surroundings sample(TemporaryFolder const& folder) {
  fs::copy(std::string(AXISC_SOURCE_DIR) + "/samples/resonance", folder.path());
  return in_folder(folder.path());
}

Outcome suggest(Surroundings const& there, std::vector<std::string> more) {
  std::vector<std::string> arguments{"suggest", "machine.json", "--axis", "X", "--resonance", resonance};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_axisc(arguments, there);
}

json suggested(Surroundings const& there, std::vector<std::string> more = {}) {
  more.insert(more.end(), {"--format", "json"});
  auto const outcome = suggest(there, more);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return json::parse(outcome.out);
}

}  // namespace

TEST_CASE("suggest answers in two languages and as JSON") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  check_golden("tests/cli/data/golden/suggest.de.text", suggest(there, {"--lang", "de"}).out);
  auto const found = suggested(there);
  // The balanced one is the calmest as well.
  CHECK(found["alternatives"].size() == 2);
  CHECK(found["alternatives"][1]["number"] == 2);
  CHECK(found["alternatives"][1]["senses"] == json{"balanced", "least_vibration"});
  CHECK(found["recommended"] == 2);
  CHECK(found["axes"] == json{"X", "Y", "Z"});
  for (auto const& alternative : found["alternatives"]) {
    CHECK(alternative["axes"].size() == 3);
    CHECK(alternative["findings"].empty());
    std::string const kind = alternative.contains("guard") ? "#VIB GUARD" : "#FILTER";
    CHECK(alternative["command"] == kind + " ON [AX_DEV=0.01]");
    CHECK(alternative["circle"]["max_axis_error_um"] <= 10.0);
    CHECK(alternative["remaining_vibration"] < found["present"]["remaining_vibration"]);
  }
}

TEST_CASE("ramp times whose zeros lie on the resonance stand beside the filters") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  // Without a channel list STEP, which no ramp time acts on.
  auto const step = suggested(there);
  CHECK(step["slope"] == "STEP");
  CHECK(step["slope_from"] == "default");
  CHECK(step["excitation"][0]["share_of_step"] == 1);
  CHECK_FALSE(step.contains("ramp_times"));
  // 1000 mm/s² and 50 ms: 66.7 mm/s reach the acceleration. |sin x / x| and |cos x / (1 - (2x/π)²)|.
  auto const trapez = suggested(there, {"--slope", "TRAPEZ"});
  CHECK(trapez["slope_from"] == "option");
  CHECK(trapez["excitation"][0]["share_of_step"].get<double>() == Approx(0.126).epsilon(1e-2));
  auto const sine = suggested(there, {"--slope", "SIN2"});
  CHECK(sine["excitation"][0]["share_of_step"].get<double>() == Approx(0.0140).epsilon(1e-2));
  CHECK(sine["ramp_times"]["candidates"][0]["ramp_time_ms"].get<double>() == Approx(31.25));
  auto const& first = trapez["ramp_times"]["candidates"][0];
  CHECK(first["ramp_time_ms"].get<double>() == Approx(1000.0 / 48).epsilon(1e-4));
  CHECK(first["time_to_feed_ms"].get<double>() == Approx(200.0 / 3 + 1000.0 / 48).epsilon(1e-4));
  CHECK(first["longer_by_ms"].get<double>() == Approx(2 * (1000.0 / 48 - 50)).epsilon(1e-3));
  CHECK_THAT(suggest(there, {"--slope", "HSC"}).out, Catch::Matchers::Contains("this is a reading"));
}

TEST_CASE("ramp times are written into the list of the axis, and are then present") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  folder.write("channel.lis", "prog_start.slope.profile 1\nEnde\n");
  folder.write(
      "machine.json",
      R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"},
             {"name": "Z", "list": "z.lis"}],
             "groups": [{"name": "mill", "axes": ["X", "Y", "Z"], "channel_list": "channel.lis"}]})");
  std::string list = folder.read("x.lis");
  std::string short_ramps;
  for (std::string const name : {"tr_beschl_zu", "tr_beschl_ab", "tr_brems_zu", "tr_brems_ab"}) {
    short_ramps += "getriebe[0].slope_profil." + name + " 10000\n";
  }
  list.insert(list.find("Ende"), short_ramps);
  folder.write("x.lis", list);

  // Of a band of ±10 % around its zero |sin x / x| leaves at most sin(0.1 π)/(0.9 π) = 0.109 of STEP; ramps
  // of 10 ms leave 0.66 at 48 Hz.
  auto const found = suggested(there)["ramp_times"];
  CHECK(found["number"] == 5);
  CHECK(found["candidates"][0]["remaining_vibration"] < 0.25);
  CHECK(found["axes"].size() == 1);
  CHECK(found["axes"][0]["lines"].size() == 4);
  CHECK(found.at("findings").empty());
  auto const written = suggest(there, {"--apply", "5"});
  INFO(written.err);
  CHECK(written.status == 0);
  CHECK_THAT(written.out, Catch::Matchers::Contains("5 ramp times of 20.834 ms"));
  std::string const text = folder.read("x.lis");
  CHECK(text.find("tr_beschl_zu 20834\n") != std::string::npos);
  CHECK(text.find("tr_brems_ab 20834\n") != std::string::npos);
  CHECK(run_axisc({"lint", "machine.json"}, there).status == 0);
  auto const again = suggested(there)["ramp_times"];
  CHECK(again["candidates"][0]["remaining_vibration"].get<double>() == Approx(1));
  CHECK(again["candidates"][0]["longer_by_ms"].get<double>() == Approx(0).margin(1e-6));
}

TEST_CASE("each suggestion can be written, is then present, and has no findings") {
  for (std::string const number : {"1", "2", "3"}) {
    TemporaryFolder const folder;
    auto const there = sample(folder);
    // 3 is what 2 is.
    auto const wanted = suggested(there)["alternatives"][number == "1" ? 0 : 1];
    auto const outcome = suggest(there, {"--apply", number});
    CHECK(outcome.status == 0);
    auto const chosen =
        std::string(number == "1" ? "1 least deviation" : "2 balanced (recommended), 3 least vibration") +
        ": " + wanted["chain"].get<std::string>() + "\nNC program: " + wanted["command"].get<std::string>() +
        "\n";
    // The sentence is longer than a line.
    auto const in_one_line = [](std::string text) {
      std::replace(text.begin(), text.end(), '\n', ' ');
      return text;
    };
    CHECK(in_one_line(outcome.out) == in_one_line(chosen));
    CHECK(outcome.err == "axisc: written: x.lis\naxisc: written: y.lis\naxisc: written: z.lis\n");
    CHECK(run_axisc({"lint", "machine.json", "--pedantic"}, there).out == "4 files: no findings\n");
    auto const present = suggested(there)["present"];
    CHECK(present["chain"] == wanted["chain"]);
    for (std::string const key : {"remaining_vibration", "delay_ms"}) {
      CHECK(present[key].get<double>() == Approx(wanted[key].get<double>()).epsilon(1e-6));
    }
    CHECK(present["corner"]["contour_deviation_um"] == wanted["corner"]["contour_deviation_um"]);
    auto const again = suggest(there, {"--apply", number});
    CHECK(again.err == "axisc: nothing to write: the lists have this setting already\n");
  }
}

TEST_CASE("--diff shows what --apply would write, as a patch, and writes nothing") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  auto const before = folder.read("x.lis");
  auto const outcome = suggest(there, {"--apply", "2", "--diff"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.rfind("--- x.lis\n+++ x.lis\n@@ ", 0) == 0);
  CHECK(folder.read("x.lis") == before);
  CHECK(suggest(there, {"--apply", "2"}).status == 0);
  // Every line that the patch adds is in the list now, and each that it takes away was in it.
  auto const after = folder.read("x.lis");
  std::istringstream patch(outcome.out.substr(0, outcome.out.find("--- y.lis")));
  std::size_t changed = 0;
  for (std::string line; std::getline(patch, line);) {
    if (line.empty() || line.rfind("+++", 0) == 0 || line.rfind("---", 0) == 0) continue;
    if (line[0] == '+') CHECK(after.find(line.substr(1) + "\n") != std::string::npos);
    if (line[0] == '-') CHECK(before.find(line.substr(1) + "\n") != std::string::npos);
    changed += line[0] == '+' || line[0] == '-' ? 1 : 0;
  }
  CHECK(changed > 2);
  CHECK(suggest(there, {"--apply", "2", "--diff"}).out.empty());
  for (auto const& wrong :
       std::vector<std::vector<std::string>>{{"--diff"},
                                             {"--apply", "2", "--diff", "--format", "json"},
                                             {"--apply", "2", "--diff", "-o", "-"}}) {
    CHECK(suggest(there, wrong).status == 2);
  }
}

TEST_CASE("other filters of the axes are switched off, and what new ones do not use is reset") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  auto const list = folder.read("y.lis");
  folder.write("y.lis", "filter[2].enable 1\r\nfilter[2].order 1\r\nfilter[2].type PT1\r\n" + list);
  folder.write("z.lis", "filter_fir.quality 0.5\n" + folder.read("z.lis"));
  CHECK(suggest(there, {"--apply", "2"}).status == 0);
  auto const y = folder.read("y.lis");
  CHECK(y.rfind("filter[2].enable 0\r\nfilter[2].order 1\r\nfilter[2].type PT1\r\n", 0) == 0);
  CHECK(y.find("\r\r") == std::string::npos);
  CHECK(run_axisc({"lint", "machine.json"}, there).out == "4 files: no findings\n");
}

TEST_CASE("nothing is written where a list must not be changed", "[posix]") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  TemporaryFolder const elsewhere;
  fs::rename(folder / "z.lis", elsewhere / "z.lis");
  fs::create_symlink(elsewhere / "z.lis", folder / "z.lis");
  auto const before = folder.read("x.lis");
  auto const outcome = suggest(there, {"--apply", "1"});
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("z.lis lies outside") != std::string::npos);
  CHECK(folder.read("x.lis") == before);
}

TEST_CASE("a setting that the check objects to is not written") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  // A program switches HSC filters on, which FIR filters replace.
  for (std::string const axis : {"x", "y", "z"}) {
    auto const list = folder.read(axis + ".lis");
    folder.write(axis + ".lis",
                 list.substr(0, list.find("filter_fir.enable")) +
                     "filter[0].prototype HSC\nfilter[0].type HSC_MEAN\nfilter[0].order 20\nEnde\n");
  }
  folder.write("part.nc", "#FILTER ON [HSC]\nM30\n");
  auto const machine = folder.read("machine.json");
  folder.write("machine.json", machine.substr(0, machine.rfind('}')) + R"(, "programs": ["part.nc"]})");
  auto const found = suggested(there);
  CHECK(found["alternatives"][1]["findings"] == json{"AX5010"});
  auto const outcome = suggest(there, {"--apply", "2"});
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("AX5010") != std::string::npos);
}

TEST_CASE(
    "a control without FIR filters is suggested HSC filters, and programs in inches their own tolerance") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  for (std::string const list : {"x.lis", "y.lis", "z.lis"}) {
    auto const text = folder.read(list);
    folder.write(list, text.substr(0, text.find("filter_fir")) + "Ende\n");
  }
  folder.write("axisc.json", R"({"build": "V3.1.3070.0"})");
  auto const found = suggested(there, {"--apply", "2"})["alternatives"][1];
  CHECK(found["axes"][0]["lines"][0] == json{{"name", "filter[0].prototype"}, {"value", "HSC"}});
  CHECK(found["command"] == "#FILTER ON [HSC]");
  CHECK(run_axisc({"lint", "machine.json"}, there).out == "4 files: no findings\n");

  fs::remove(folder / "axisc.json");
  auto machine = json::parse(folder.read("machine.json"));
  machine["inch"] = true;
  folder.write("machine.json", machine.dump());
  CHECK(suggested(there)["alternatives"][1]["command"] == "#VIB GUARD ON [AX_DEV=0.000393]");
}

TEST_CASE("suggest refuses what it cannot answer") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  CHECK(suggest(there, {"--apply", "6"}).status == 2);
  auto const without_ramps = suggest(there, {"--apply", "5"});
  CHECK(without_ramps.status == 2);
  CHECK(without_ramps.err.find("have no effect with STEP") != std::string::npos);
  CHECK(suggest(there, {"--slope", "ROUND"}).status == 2);
  CHECK(suggest(there, {"--feed", "0"}).status == 2);
  CHECK(run_axisc({"suggest", "machine.json", "--axis", "Q", "--resonance", "48Hz"}, there).status == 2);
  for (std::string const bad : {"", "48Hz,", "500Hz", "x", "48:1", "48:0", "1,2,3,4", "0.5"}) {
    INFO(bad);
    auto const outcome = run_axisc({"suggest", "machine.json", "--axis", "X", "--resonance", bad}, there);
    CHECK((outcome.status == 2) == (bad != "48Hz,"));
  }
  auto const strict = suggest(there, {"--tolerance", "1e-14"});
  CHECK(strict.status == 1);
  CHECK(strict.err.find("keeps 1e-14 mm") != std::string::npos);
  CHECK(strict.out.empty());
  auto const weak = suggest(there, {"--tolerance", "0.0005"});
  CHECK(weak.status == 1);
  CHECK(weak.err.find("% of the vibration") != std::string::npos);
}

namespace {

/// The response of a column at 48 Hz, of 3 % damping, as a measuring program exports it.
std::string measured_response(double coherence) {
  std::string text = "frequency_hz;magnitude_db;phase_deg;coherence\n";
  for (int i = 0; i < 600; ++i) {
    double const f = 5 + 0.25 * i;
    std::complex<double> const s(0, f / 48);
    auto const h = 1.0 / (1.0 + 0.06 * s + s * s);
    text += std::to_string(f) + ";" + std::to_string(20 * std::log10(std::abs(h))) + ";" +
            std::to_string(std::arg(h) * 57.29577951308232) + ";" + std::to_string(coherence) + "\n";
  }
  return text;
}

Outcome measured(Surroundings const& there, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"suggest", "machine.json", "--axis", "X", "--measured", "bode.csv"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_axisc(arguments, there);
}

}  // namespace

TEST_CASE("a measured resonance is suggested for like a named one, and doubtful data are refused") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  folder.write("bode.csv", measured_response(0.97));
  auto const outcome = measured(there);
  CHECK(outcome.status == 0);
  CHECK(outcome.out.find("  measured [Hz]  ± [Hz]  damping      ±  coherence  evidence\n"
                         "          48.00    0.12    0.030  0.003       0.97  response\n") !=
        std::string::npos);
  auto const found = json::parse(measured(there, {"--format", "json"}).out);
  CHECK(found["measured"][0]["coherence"].get<double>() == Approx(0.97));
  CHECK(found["resonances"][0]["damping"].get<double>() == Approx(0.03).epsilon(0.01));

  folder.write("bode.csv", measured_response(0.6));
  auto const doubtful = measured(there);
  CHECK(doubtful.status == 2);
  CHECK(doubtful.out.empty());
  CHECK(doubtful.err.find("(48 Hz) (coherence below 0.8); record longer") != std::string::npos);
  CHECK(measured(there, {"--lang", "de"}).err.find("Kohärenz unter 0,8") != std::string::npos);

  folder.write("bode.csv", "time,a,b\n0,1,2\n0.001,2,x\n");
  auto const broken = measured(there);
  CHECK(broken.status == 2);
  CHECK(broken.err.find(R"(bode.csv:3: "x" in column "b" is not a number)") != std::string::npos);
  CHECK(measured(there, {"--resonance", "48Hz"}).status == 2);
  CHECK(suggest(there, {"--in", "a"}).status == 2);
}

TEST_CASE("several recordings show a resonance by lines, and one says what is missing") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  auto const measuring = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"suggest", "machine.json", "--axis", "X"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_axisc(arguments, there);
  };
  // The recordings are of an axis whose closed loop has a pole at 48.06 Hz.
  auto const both = measuring({"--measured", "full.csv", "60-percent.csv", "--format", "json"});
  INFO(both.err);
  REQUIRE(both.status == 0);
  auto const found = json::parse(both.out);
  REQUIRE(found["measured"].size() == 1);
  auto const& mode = found["measured"][0];
  CHECK(mode["evidence"] == json{"lines"});
  CHECK(mode["damping"].is_null());
  double const uncertainty = mode["frequency_uncertainty_hz"];
  CHECK(mode["frequency_hz"].get<double>() == Approx(48.06).margin(3 * uncertainty));
  CHECK(found["mapping"].size() == 4);
  CHECK(found["mapping"][2]["signal"] == "60-percent.csv: in");
  CHECK(measuring({"--measured", "full.csv", "--measured", "60-percent.csv", "--format", "json"}).out ==
        both.out);

  auto const one = measuring({"--measured", "full.csv"});
  CHECK(one.status == 2);
  CHECK(one.out.empty());
  CHECK(one.err.find("repeat at 60 % override") != std::string::npos);
  CHECK(measuring({"--measured", "full.csv", "--lang", "de"}).err.find("mit 60 % Override") !=
        std::string::npos);
  // The same without a header and without times: a row is an NC cycle.
  for (std::string const name : {"full.csv", "60-percent.csv"}) {
    std::istringstream lines(folder.read(name));
    std::string text;
    std::string line;
    for (std::getline(lines, line); std::getline(lines, line);)
      text += line.substr(line.find(',') + 1) + "\n";
    folder.write("plain-" + name, text);
  }
  auto const plain = json::parse(
      measuring({"--measured", "plain-full.csv", "plain-60-percent.csv", "--format", "json"}).out);
  CHECK(plain["measured"] == found["measured"]);
  // Speeds in mm and in rows of another setpoint cannot be compared.
  auto const mixed = measuring({"--measured", "full.csv", "plain-60-percent.csv"});
  CHECK(mixed.status == 2);
  CHECK(mixed.err.find("plain-60-percent.csv: its setpoint has another unit") != std::string::npos);
}

TEST_CASE("the suggestions are drawn with the resonance marked") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  CHECK(suggest(there, {"-o", "x.svg"}).status == 0);
  auto const picture = folder.read("x.svg");
  check_golden("docs/pictures/suggest.svg", picture);
  for (std::string const words : {"48 Hz", "present", "1 least deviation", "2 balanced, 3 least vibration"}) {
    INFO(words);
    CHECK(picture.find(words) != std::string::npos);
  }
  auto const drawn = suggest(there, {"-o", "-"});
  CHECK(drawn.out == picture);
  CHECK(suggest(there, {"-o", "x.lis"}).status == 2);
  CHECK(suggest(there, {"-o", "machine.png"}).status == 2);
}

}  // namespace suggest_test
