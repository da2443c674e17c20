// How long each construct of NC programs takes.
#include "constructs.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace constructs_test {

using namespace axisc::test;
using std::numbers::pi;
using std::numbers::sqrt2;

TEST_CASE("constructs: circles and helices") {
  // A circle accelerates along the path with a = √(a_max² - (v²/r)²), which for 10 mm/s is a_max but for
  // 1e-8, and a_max is that of the weaker axis. On a helix the plane's axes have the share 2πr / L of it: a =
  // a_max L / 2πr.
  double const weak = 5000;
  auto const helix = [](double r, double h, double a) {
    double const L = std::hypot(2 * pi * r, h);
    return rest_to_rest(L, 10, a * L / (2 * pi * r));
  };
  check_times(simulated_construct("circles.nc"), {{"N20", rest_to_rest(pi / 2 * 10)},
                                                  {"N30", rest_to_rest(3 * pi / 2 * 10)},
                                                  {"N40", rest_to_rest(pi * 5)},
                                                  {"N50", rest_to_rest(pi / 3 * 10)},
                                                  {"N60", rest_to_rest(5 * pi / 3 * 10)},
                                                  {"N70", rest_to_rest(2 * pi * 5)},
                                                  {"N80", rest_to_rest(2 * pi * std::hypot(3, 4))},
                                                  {"N90", rest_to_rest(pi / 2 * 10, 10, weak)},
                                                  {"N100", rest_to_rest(3 * pi / 2 * 10, 10, weak)},
                                                  {"N110", rest_to_rest(pi / 2 * 10, 10, weak)},
                                                  {"N120", rest_to_rest(pi / 2 * 10, 10, weak)},
                                                  {"N130", helix(3, 4, 10000)},
                                                  {"N140", helix(3, 8, weak)},
                                                  {"N150", helix(2, 6, weak)},
                                                  {"N160", rest_to_rest(pi * (2 + 0.003) / 2)}});
}

TEST_CASE("constructs: subprograms") {
  double const step = rest_to_rest(5);
  check_times(simulated_construct("subprograms.nc"),
              {{"N10", step}, {"N10", step}, {"N40", step}, {"N90", step}, {"N90", step}});
}

TEST_CASE("constructs: parameters, conditions and loops") {
  std::vector<TimedBlock> expected;
  auto const block = [&](std::string const& label, double L) {
    expected.push_back({label, rest_to_rest(L)});
  };
  block("N30", 3 * 2);
  block("N40", 3 * 2 - (3 + 1));
  block("N60", 2.0 / 4 * 6);  // √16 sin 30° + 1 - 1 = 2
  block("N80", 8 - 7);
  block("N150", 10 - 8);
  for (double const L : {3, 2, 1}) block("N190", L);
  for (double const L : {1, 3}) block("N290", L);  // 2 is left out, at 4 the loop ends
  for (int round = 0; round < 3; ++round) block("N320", 4);
  check_times(simulated_construct("parameters.nc"), expected);
}

TEST_CASE("constructs: units of lengths and feed rates") {
  double const inch = 25.4;
  check_times(simulated_construct("units.nc"), {{"N20", rest_to_rest(10, 600 / 60.0)},
                                                {"N30", rest_to_rest(inch - 10, 60 * inch / 60)},
                                                {"N40", rest_to_rest(inch, 60 * inch / 60)},
                                                {"N50", rest_to_rest(inch, 0.02 * inch * 1000 / 60)},
                                                {"N60", rest_to_rest(10, 0.5 * 1000 / 60)},
                                                {"N70", rest_to_rest(10, 0.5 * 1200 / 60)},
                                                {"N80", rest_to_rest(10, 1200 / 60.0)},
                                                {"N90", rest_to_rest(3 * inch + 30, 1200 / 60.0)}});
}

TEST_CASE("constructs: G00 has the limits of the axes") {
  // Too short for a velocity: half of the way up, half down, L = a t² / 4.
  double const short_way = 2 * std::sqrt(9 / 10000.0);
  // Along two axes at once path velocity and acceleration are √2 those of the slower one.
  check_times(simulated_construct("rapid.nc"),
              {{"N20", rest_to_rest(100, 500)},
               {"N30", short_way},
               {"N40", rest_to_rest(100 * sqrt2, 500 * sqrt2, 10000 * sqrt2)},
               {"N50", rest_to_rest(100, 250, 5000)},
               {"N60", rest_to_rest(100 * sqrt2, 250 * sqrt2, 5000 * sqrt2)},
               {"N70", rest_to_rest(1)},
               {"N80", short_way}});
}

TEST_CASE("constructs: slopes") {
  // Ramps of 50 ms reach 10 m/s² only above 500 mm/s: a ramp to v takes √(2 v t̄ / a) with t̄ = 0.1 s, and
  // SIN2 takes the time of TRAPEZ. A short way has a quarter for each ramp: L = 2 j t³.
  double const smooth = 1 + std::sqrt(2 * 100 * 0.1 / 10000);
  check_times(simulated_construct("slopes.nc"), {{"N20", rest_to_rest(100, 100)},
                                                 {"N40", smooth},
                                                 {"N60", smooth},
                                                 {"N80", 4 * std::cbrt(0.5 / (2 * 10000 / 0.05))},
                                                 {"N100", 2 * std::sqrt(0.5 / 10000)}});
}

}  // namespace constructs_test
