// Units and modulo ranges of recordings, and what to record where one tells too little.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <functional>

#include <nlohmann/json.hpp>

namespace compare_test {

using namespace axisc::test;
using nlohmann::json;

namespace {

constexpr std::size_t cycles = 1200;

/// From rest with jumps of the velocity, so that whatever filters it is seen.
std::vector<double> setpoints(double velocity) {
  std::vector<double> values(cycles, 0.0);
  for (std::size_t n = 1; n < cycles; ++n) {
    double const now = n < 50 || n >= 1100 ? 0 : n < 500 ? velocity : n < 600 ? 0 : -velocity / 3;
    values[n] = values[n - 1] + now;
  }
  return values;
}

/// By its definition: the mean of the setpoint and of those of `order` cycles before it.
std::vector<double> averaged(std::vector<double> const& values, std::size_t order) {
  std::vector<double> mean(values.size());
  for (std::size_t n = 0; n < values.size(); ++n) {
    double sum = 0;
    for (std::size_t k = 0; k <= order; ++k) sum += n >= k ? values[n - k] : values[0];
    mean[n] = sum / static_cast<double>(order + 1);
  }
  return mean;
}

std::string recorded(std::vector<double> const& in, std::vector<double> const& out,
                     std::function<double(double)> const& shown) {
  std::string text = "setpoint\tfiltered\n";
  for (std::size_t n = 0; n < in.size(); ++n) {
    text += std::to_string(static_cast<long long>(shown(in[n]))) + "\t" +
            std::to_string(static_cast<long long>(shown(out[n]))) + "\n";
  }
  return text;
}

Outcome compare(TemporaryFolder const& folder, std::vector<std::string> const& more,
                std::string const& input = "x.lis") {
  std::vector<std::string> arguments{"compare", input, "scope.csv", "--cycle-time", "1ms"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_axisc(arguments, in_folder(folder.path()));
}

json told(TemporaryFolder const& folder, std::vector<std::string> more = {}) {
  more.insert(more.end(), {"--format", "json"});
  auto const outcome = compare(folder, more);
  INFO(outcome.err);
  return json::parse(outcome.out);
}

std::string const average_of_9 = "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 8\n";

}  // namespace

TEST_CASE("a modulo range that is not a full turn is taken out of a recording") {
  TemporaryFolder const folder;
  auto const in = setpoints(30'000);
  auto const out = averaged(in, 8);
  constexpr double low = -450'000;
  constexpr double range = 900'000;  // a quarter of a turn
  auto const wrapped = [](double value) {
    double const whole = std::round(value);
    return whole - range * std::floor((whole - low) / range);
  };
  folder.write("scope.csv", recorded(in, out, wrapped));
  std::string const rotary = "kenngr.achs_typ 2\n" + average_of_9;
  std::string const limits = "getriebe[0].moduloo 450000\ngetriebe[0].modulou -450000\n";
  folder.write("x.lis", rotary + limits + "Ende\n");
  auto const right = told(folder);
  CHECK(right["verdict"] == "same");
  CHECK(right["jumps"].get<int>() > 20);
  CHECK(right["unit"] == "0.001°");
  SECTION("a full turn is not what it jumps by") {
    folder.write("x.lis", rotary + "Ende\n");
    CHECK(told(folder)["verdict"] != "same");
  }
  SECTION("the range is that of the gear step after the start") {
    folder.write("x.lis", rotary + "kenngr.getriebe_stufe 2\ngetriebe[0].moduloo 3600000\n" +
                              "getriebe[1].moduloo 450000\ngetriebe[1].modulou -450000\nEnde\n");
    CHECK(told(folder)["verdict"] == "same");
  }
  SECTION("a translatory axis has one where its mode says so") {
    std::string const translatory = "kenngr.achs_typ 1\n" + average_of_9 + limits;
    folder.write("x.lis", translatory + "kenngr.achs_mode 0x4\nEnde\n");
    CHECK(told(folder)["verdict"] == "same");
    folder.write("x.lis", translatory + "kenngr.achs_mode 0x1\nEnde\n");
    CHECK(told(folder)["jumps"] == 0);
  }
}

TEST_CASE("increments are as long as the lists say") {
  TemporaryFolder const folder;
  auto const in = setpoints(800);
  folder.write("scope.csv", recorded(in, averaged(in, 8), [](double value) { return std::round(value); }));
  // 25 increments for 0.2 µm: one is 0.008 µm long.
  folder.write("x.lis", "kenngr.achs_typ 1\n" + average_of_9 +
                            "getriebe[0].wegaufz 25\ngetriebe[0].wegaufn 2\nEnde\n");
  auto const increments = told(folder, {"--unit", "incr"});
  CHECK(increments["verdict"] == "same");
  CHECK(increments["allowed_rms"].get<double>() == Approx(0.008 / std::sqrt(6)));
  CHECK(told(folder)["allowed_rms"].get<double>() == Approx(0.1 / std::sqrt(6)));

  auto const there = in_folder(folder.path());
  REQUIRE(run_axisc({"compile", "x.lis", "-o", "x.axim", "--cycle-time", "1ms", "--quiet"}, there).status ==
          0);
  REQUIRE(
      run_axisc({"compile", "x.lis", "-o", "bare.axim", "--cycle-time", "1ms", "--quiet", "--strip"}, there)
          .status == 0);
  std::vector<std::string> const arguments{"scope.csv", "--unit", "incr", "--format", "json"};
  auto const with = [&](std::string const& image) {
    std::vector<std::string> all{"compare", image};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_axisc(all, there);
  };
  CHECK(json::parse(with("x.axim").out)["allowed_rms"] == increments["allowed_rms"]);
  auto const bare = with("bare.axim");
  CHECK(bare.status == 2);
  CHECK_THAT(bare.err, Catch::Matchers::Contains("--unit 0.1um"));
}

TEST_CASE("a recording that tells too little says what to record instead") {
  TemporaryFolder const folder;
  auto const record = [&](std::vector<double> const& in) {
    folder.write("scope.csv", recorded(in, averaged(in, 8), [](double value) { return std::round(value); }));
  };
  // So slow that kernels with the same delay agree: sin² over all cycles.
  std::vector<double> slow(cycles);
  for (std::size_t n = 0; n < cycles; ++n) {
    constexpr double half_turn = 3.14159265358979;
    slow[n] = 1000 * (1 - std::cos(half_turn * static_cast<double>(n) / cycles));
  }
  record(slow);
  folder.write("x.lis", "kenngr.achs_typ 1\n" + average_of_9 + "Ende\n");
  auto const alike = told(folder);
  CHECK(alike["verdict"] == "same");
  CHECK_FALSE(alike["fitting"].empty());
  CHECK(alike["telling_motion"] == "velocity-jump");
  CHECK_THAT(compare(folder, {}).out, Catch::Matchers::Contains("velocity to 6000 mm/min"));
  CHECK_THAT(compare(folder, {"--lang", "de"}).out,
             Catch::Matchers::Contains("Geschwindigkeitssprung auf 6000 mm/min"));
  // That motion tells them apart.
  record(setpoints(1000));
  auto const apart = told(folder);
  CHECK(apart["verdict"] == "same");
  CHECK(apart["fitting"].empty());
  CHECK(apart["telling_motion"].is_null());
}

TEST_CASE("settings are emitted only where the lists and the recording determine them") {
  TemporaryFolder const folder;
  auto const in = setpoints(800);
  // Nine taps: order 9 as N taps, and as half a width of 9/2 rounded down.
  folder.write("scope.csv", recorded(in, averaged(in, 8), [](double value) { return std::round(value); }));
  folder.write("x.lis", "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 9\nEnde\n");
  auto const shown = told(folder);
  CHECK(shown["verdict"] == "different");
  CHECK(shown["fitting"].size() == 1);
  CHECK(shown["fitting"][0]["readings"] == json{"taps-n"});
  CHECK(shown["fitting"][0]["equal_with_these_lists"] == json::parse(R"([["half-width-rounded-down"]])"));
  CHECK_THAT(compare(folder, {}).out, Catch::Matchers::Contains("half the width is") &&
                                          Catch::Matchers::Contains("only lists with other values"));
  auto const emitted = compare(folder, {"--emit", "settings"});
  CHECK(emitted.status == 1);
  CHECK(emitted.out.empty());
  CHECK_THAT(emitted.err,
             Catch::Matchers::Contains("\"kernels\" is left open: taps-n, half-width-rounded-down explain"));
}

TEST_CASE("numbers that are no positions are refused") {
  TemporaryFolder const folder;
  folder.write("x.lis", "kenngr.achs_typ 1\n" + average_of_9 + "Ende\n");
  std::string text = "setpoint;filtered\n";
  for (int n = 0; n < 300; ++n) text += n % 2 == 0 ? "1e305;1e305\n" : "-1e305;-1e305\n";
  folder.write("scope.csv", text);
  auto const outcome = compare(folder, {});
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err,
             Catch::Matchers::Contains("scope.csv:2: 1e+305 in column \"setpoint\" is too large"));
}

}  // namespace compare_test
