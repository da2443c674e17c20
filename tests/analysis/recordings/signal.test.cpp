#include "analysis/recordings/signal.hpp"

#include "support/catch.hpp"

#include <limits>
#include <random>

namespace axisc::recordings::signal_test {
namespace {

TEST_CASE("a packed signal has the values that were pushed") {
  std::mt19937_64 random(7);
  auto const pick = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  std::vector<double> values{0.0, -0.0, 1e300, -1e-300, 123456789012345678.0, 0.1, 0.3};
  for (double const size : {100.0, 1e5, 1e9, 1e14}) {
    for (double const per_unit : {1.0, 10.0, 1000.0, 1e6}) {
      for (int i = 0; i < 300; ++i) values.push_back(std::round(pick(-size, size)) / per_unit);
    }
  }
  for (int i = 0; i < 300; ++i) values.push_back(pick(-1, 1));
  Signal const signal(values);
  REQUIRE(signal.size() == values.size());
  auto const back = signal.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    CHECK((back[i] == values[i] && std::signbit(back[i]) == std::signbit(values[i])));
  }
  std::vector<double> part(500);
  signal.read(77, part);
  CHECK(std::equal(part.begin(), part.end(), values.begin() + 77));
  CHECK(signal.back() == values.back());
}

}  // namespace
}  // namespace axisc::recordings::signal_test
