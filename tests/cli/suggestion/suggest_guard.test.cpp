// Vibration Guard among the suggestions: what is proposed, written, and excluded.
#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <complex>
#include <filesystem>
#include <numbers>

#include <nlohmann/json.hpp>

namespace suggest_guard_test {

using namespace axisc::test;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

/// The sample in a folder of its own.
Surroundings sample(TemporaryFolder const& folder) {
  std::filesystem::copy(std::string(AXISC_SOURCE_DIR) + "/samples/resonance", folder.path());
  return in_folder(folder.path());
}

Outcome suggest(Surroundings const& there, std::vector<std::string> more = {}) {
  std::vector<std::string> words{"suggest", "machine.json", "--axis", "X", "--resonance", "48Hz:0.02"};
  words.insert(words.end(), more.begin(), more.end());
  return run_axisc(words, there);
}

json suggested(Surroundings const& there) {
  auto const outcome = suggest(there, {"--format", "json"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return json::parse(outcome.out);
}

void add_program(TemporaryFolder const& folder, std::string const& program) {
  folder.write("part.nc", program);
  auto machine = json::parse(folder.read("machine.json"));
  machine["programs"] = json{"part.nc"};
  folder.write("machine.json", machine.dump());
}

/// Lists without a FIR filter.
void remove_filters(TemporaryFolder const& folder) {
  for (std::string const axis : {"x", "y", "z"}) {
    auto const list = folder.read(axis + ".lis");
    folder.write(axis + ".lis", list.substr(0, list.find("filter_fir.enable")) + "Ende\n");
  }
}

/// What n pairs of impulses 1 : K, half a damped period of f apart, leave at fa, counted at the last one.
double left(int n, double f, double D, double fa) {
  double const root = std::sqrt(1 - D * D);
  double const K = std::exp(-std::numbers::pi * D / root);
  double const h = 1 / (2 * f * root);
  std::complex<double> const s(2 * std::numbers::pi * fa * D, 2 * std::numbers::pi * fa * root);
  return std::pow(std::abs(1.0 + K * std::exp(s * h)) / (1 + K) * std::exp(-s.real() * h), n);
}

}  // namespace

TEST_CASE("suggest proposes a guard where it does better, with its interval") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  auto const found = suggested(there);
  auto const& balanced = found["alternatives"][1];
  REQUIRE(balanced.contains("guard"));
  auto const& guard = balanced["guard"];
  CHECK(balanced["command"] == "#VIB GUARD ON [AX_DEV=0.01]");
  CHECK(balanced["overshoot"].get<double>() == Approx(0).margin(1e-9));
  CHECK(guard["resonance_hz"] == 48);
  CHECK(guard["coverage"] == "within");
  // 5 % at both ends; what splitting impulses between cycles adds is less than half a percent.
  for (std::string const end : {"interval_from_hz", "interval_to_hz"}) {
    CHECK(left(guard["mode"], guard["frequency_hz"], guard["damping"], guard[end]) ==
          Approx(0.05).margin(0.005));
  }
  for (auto const& axis : balanced["axes"]) {
    auto const& lines = axis["lines"];
    auto const has = [&](std::string const& name, std::string const& value) {
      return std::find(lines.begin(), lines.end(), json{{"name", name}, {"value", value}}) != lines.end();
    };
    CHECK(has("vib_guard.active", "1"));
    CHECK(has("filter_fir.type", "0"));
  }
  CHECK_THAT(suggest(there).out, Contains("(a reading); the\nresonance, 48 Hz, is within"));
}

TEST_CASE("a suggested guard is written, is then the present setting, and is named where it is replaced") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  auto const wanted = suggested(there)["alternatives"][1];
  CHECK(suggest(there, {"--apply", "2", "--diff"}).out.find("+vib_guard.active") != std::string::npos);
  REQUIRE(suggest(there, {"--apply", "2"}).status == 0);
  CHECK(run_axisc({"lint", "machine.json", "--pedantic"}, there).out == "4 files: no findings\n");
  auto const present = suggested(there)["present"];
  CHECK(present["chain"] == wanted["chain"]);
  CHECK(present["guard"] == wanted["guard"]);
  CHECK(present["remaining_vibration"].get<double>() ==
        Approx(wanted["remaining_vibration"].get<double>()).epsilon(1e-6));
  auto const answer = suggest(there);
  CHECK_THAT(answer.out, Contains("present: LOWPASS") && Contains("is switched off"));
  CHECK(suggest(there, {"--apply", "2"}).err ==
        "axisc: nothing to write: the lists have this setting already\n");

  // FIR again: what is left of the guard is a note.
  REQUIRE(suggest(there, {"--apply", "1"}).status == 0);
  CHECK_THAT(folder.read("x.lis"), Contains("vib_guard.active") && Contains("filter_fir.type"));
  auto const lint = run_axisc({"lint", "machine.json", "--pedantic"}, there);
  CHECK(lint.status == 0);
  CHECK_THAT(lint.out, Contains("AX3029") && !Contains("error"));
}

TEST_CASE("what programs command excludes the other kernels") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  add_program(folder, "#FILTER ON\nM30\n");
  for (auto const& alternative : suggested(there)["alternatives"]) {
    CHECK_FALSE(alternative.contains("guard"));
    CHECK(alternative["findings"].empty());
  }
  CHECK_THAT(suggest(there).out, Contains("a program uses #FILTER") || Contains("overshoots by"));

  remove_filters(folder);
  add_program(folder, "#VIB GUARD ON\nM30\n");
  for (auto const& alternative : suggested(there)["alternatives"]) {
    CHECK(alternative["chain"].get<std::string>().find("order 34") == std::string::npos);
    CHECK((alternative.contains("guard") || alternative["command"].is_null()));
    CHECK(alternative["findings"].empty());
  }
  CHECK(suggest(there, {"--apply", "2"}).status == 0);
  CHECK(run_axisc({"lint", "machine.json"}, there).status == 0);
}

TEST_CASE("a control older than Vibration Guard is not suggested one") {
  TemporaryFolder const folder;
  auto const there = sample(folder);
  remove_filters(folder);
  folder.write("axisc.json", R"({"build": "V3.1.3070.0"})");
  for (auto const& alternative : suggested(there)["alternatives"]) CHECK_FALSE(alternative.contains("guard"));
}

}  // namespace suggest_guard_test
