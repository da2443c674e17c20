#include "cli/compiled_machine.hpp"
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace inspect_test {

using namespace axisc::test;

namespace {

std::string const data = std::string(AXISC_SOURCE_DIR) + "/tests/cli/data/";

}  // namespace

TEST_CASE("an image as text and JSON") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  for (std::string const language : {"en", "de"}) {
    auto const outcome = run_axisc({"inspect", "m.axim", "--lang", language}, there);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    check_golden("tests/cli/data/golden/inspect." + language + ".text", outcome.out);
  }
  check_golden("tests/cli/data/golden/inspect.json",
               run_axisc({"inspect", "m.axim", "--format", "json"}, there).out);
}

TEST_CASE("a peak gain that no setpoint need reach is stated as a bound") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis",
               "kopf.achs_nr 1\nfilter[0].enable 1\nfilter[0].type BANDSTOP\nfilter[0].order 3\n"
               "filter[0].prototype BUTTERWORTH\nfilter[0].fg_f0 0.05\nfilter[0].guete 10\nEnde\n");
  REQUIRE(run_axisc({"compile", "x.lis", "-o", "x.axim", "--cycle-time", "125us", "-q"}, there).status == 0);
  auto const text = run_axisc({"inspect", "x.axim"}, there).out;
  CHECK_THAT(text, Catch::Matchers::Contains("at most 5.4433"));
  auto const german = run_axisc({"inspect", "x.axim", "--lang", "de"}, there).out;
  CHECK_THAT(german, Catch::Matchers::Contains("höchstens 5,4433"));
  auto const json = nlohmann::json::parse(run_axisc({"inspect", "x.axim", "--format", "json"}, there).out);
  auto const& axis = json["axes"][0];
  CHECK(axis["peak_gain"] > 3.357);
  CHECK(axis["peak_gain_is_reached"] == false);
  CHECK(axis["filters"][0]["peak_gain_is_reached"] == false);

  folder.write("y.lis",
               "kopf.achs_nr 1\nfilter[0].enable 1\nfilter[0].order 3\nfilter[0].type ALLPASS\n"
               "filter[0].prototype BESSEL\nfilter[0].fg_f0 30\nEnde\n");
  REQUIRE(run_axisc({"compile", "y.lis", "-o", "y.axim", "--cycle-time", "125us", "-q"}, there).status == 0);
  CHECK_THAT(run_axisc({"inspect", "y.axim"}, there).out, !Catch::Matchers::Contains("at most"));
}

TEST_CASE("one axis, and the memory it takes") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  auto const outcome = run_axisc({"inspect", "m.axim", "--axis", "Y", "--memory", "host"}, there);
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("axis Y") && !Catch::Matchers::Contains("axis X"));
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("bytes, aligned to 64"));
  std::size_t before = 0;
  for (std::string const target : {"portable", "x86-64-v2", "x86-64-v4", "aarch64"}) {
    auto const json = run_axisc({"inspect", "m.axim", "--memory", target, "--format", "json"}, there).out;
    std::string const key = "\"memory\": {\n    \"bytes\": ";
    REQUIRE(json.find(key) != std::string::npos);
    std::size_t const bytes = std::stoul(json.substr(json.find(key) + key.size()));
    CHECK(bytes % 64 == 0);
    if (target != "aarch64") CHECK(bytes >= before);  // wider lanes, more padding
    before = bytes;
  }
  auto const unknown = run_axisc({"inspect", "m.axim", "--axis", "Z"}, there);
  CHECK(unknown.status == 2);
  CHECK(unknown.err == "axisc: error: there is no axis \"Z\"; the axes are X, Y\n");
}

TEST_CASE("the list that comes back compiles to the same filters") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  auto const list = run_axisc({"inspect", "m.axim", "--axis", "X", "--as-list"}, there);
  CHECK(list.status == 0);
  check_golden("tests/cli/data/golden/inspect.as-list", list.out);
  folder.write("x.lis", list.out);
  REQUIRE(run_axisc({"compile", "x.lis", "-o", "x.axim", "--cycle-time", "1ms", "--werror"}, there).status ==
          0);
  CHECK(run_axisc({"run", "x.axim", "--port", "interface"}, there).out ==
        run_axisc({"run", "m.axim", "--port", "interface"}, there).out);
  CHECK(run_axisc({"response", "x.axim"}, there).out ==
        run_axisc({"response", "m.axim", "--axis", "X"}, there).out);
}

TEST_CASE("a stripped image has no names") {
  TemporaryFolder const folder;
  auto const there = compiled(folder, {"--strip", "--image-version", "7"});
  auto const outcome = run_axisc({"inspect", "m.axim"}, there);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out,
             Catch::Matchers::Contains("axis axis0") && Catch::Matchers::Contains("image version  7"));
  CHECK_THAT(run_axisc({"run", "m.axim", "--cycles", "1"}, there).out,
             Catch::Matchers::StartsWith("axis0,axis1\n"));
  CHECK(run_axisc({"inspect", "m.axim", "--as-list"}, there).status == 2);
}

TEST_CASE("a damaged image is one line") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  auto const bytes = folder.read("m.axim");
  auto changed = bytes;
  changed[changed.size() / 2] = static_cast<char>(changed[changed.size() / 2] ^ 1);
  folder.write("changed.axim", changed);
  folder.write("cut.axim", bytes.substr(0, bytes.size() - 1));
  folder.write("header.axim", bytes.substr(0, 20));
  folder.write("empty.axim", "");
  folder.write("text.axim", "kopf.achs_nr 1\n" + std::string(200, ' '));
  for (std::string const command : {"inspect", "run", "response"}) {
    for (std::string const name : {"changed", "cut", "header", "empty", "text"}) {
      auto const outcome = run_axisc({command, name + ".axim"}, there);
      INFO(command << " " << name);
      CHECK(outcome.status == 2);
      CHECK(outcome.out.empty());
      CHECK(lines_of(outcome.err) == 1);
      CHECK_THAT(outcome.err, Catch::Matchers::StartsWith("axisc: error[AX9004]: " + name + ".axim "));
    }
    CHECK_THAT(run_axisc({command, "missing.axim"}, there).err, Catch::Matchers::Contains("AX9001"));
    // Of folders and lists response makes the image itself.
    bool const wants_image = command != "response";
    CHECK_THAT(run_axisc({command, "."}, there).err,
               Catch::Matchers::Contains(wants_image ? "it is a folder" : "holds no list"));
    CHECK_THAT(run_axisc({command}, there).err,
               Catch::Matchers::Contains(wants_image ? "IMAGE.axim is missing" : "INPUT is missing"));
  }
}

TEST_CASE("an image from standard input") {
  TemporaryFolder const folder;
  auto there = compiled(folder);
  there.input = folder.read("m.axim");
  CHECK(run_axisc({"inspect", "-"}, there).status == 0);
}

TEST_CASE("figures of chains that are known without computing them") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  auto const chain_of = [&](std::string const& list) {
    folder.write("x.lis", list);
    REQUIRE(run_axisc({"compile", "x.lis", "--cycle-time", "1ms", "-o", "x.axim", "--quiet"}, there).status ==
            0);
    auto const json = run_axisc({"inspect", "x.axim", "--format", "json"}, there).out;
    return nlohmann::json::parse(json)["axes"][0]["chain"];
  };
  // A Butterworth filter passes half of the power at its cut-off frequency, whatever its order.
  auto const low_pass = chain_of(
      "filter[0].enable 1\nfilter[0].type LOWPASS\nfilter[0].prototype BUTTERWORTH\nfilter[0].order 3\n"
      "filter[0].fg_f0 37\n");
  CHECK(low_pass["corner_frequency_hz"].get<double>() == Approx(37).epsilon(1e-9));
  CHECK(low_pass["magnitudes"][0]["frequency_hz"] == 37);
  CHECK(low_pass["magnitudes"][0]["magnitude_db"].get<double>() == Approx(-3.0102999566398).epsilon(1e-9));
  // The mean of eleven setpoints: settled after ten cycles, no overshoot, sin(11ωT/2)/(11 sin(ωT/2)).
  auto const average = chain_of("filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 10\n");
  CHECK(average["settling_ms"] == 10);
  CHECK(average["overshoot_percent"] == 0);
  double const half = 3.141592653589793 * average["corner_frequency_hz"].get<double>() * 1e-3;
  CHECK(std::sin(11 * half) / (11 * std::sin(half)) == Approx(0.7071067811865476).epsilon(1e-9));
  CHECK(average["corner_frequency_hz"].get<double>() < 50);
  CHECK(average["magnitudes"].empty());
  // Nothing to weaken: a delay passes all frequencies.
  auto const delay = chain_of("filter_fir.enable 1\nfilter_fir.type 4\nfilter_fir.order 7\n");
  CHECK(delay["corner_frequency_hz"].is_null());
}

TEST_CASE("a filter of linear phase that only a program's command fills has no kernel at the start") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", "kopf.achs_nr 1\nfilter_fir.type 1\nfilter_fir.order 0\nfilter_fir.enable 0\nEnde\n");
  folder.write("y.lis",
               "kopf.achs_nr 2\nfilter_fir.type 1\nfilter_fir.order 20\nfilter_fir.enable 1\nEnde\n");
  folder.write("machine.json",
               R"({"cycle_time_us": 1000, "filter_sets": ["#FILTER ON [ORDER=60]"],
                   "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}]})");
  REQUIRE(run_axisc({"compile", "machine.json", "-o", "m.axim", "--quiet"}, there).status == 0);
  auto const json = run_axisc({"inspect", "m.axim", "--format", "json"}, there).out;
  CHECK(nlohmann::json::parse(json)["axes"][0]["linear_phase_filter"]["kernel"].is_null());
}

}  // namespace inspect_test
