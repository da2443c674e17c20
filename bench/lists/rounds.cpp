#include "lists/rounds.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace axisc::bench {
namespace {

double seconds_of(std::function<void()> const& run) {
  auto const begin = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
  auto const middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

void measure(std::vector<Contender> const& contenders, std::size_t reference, std::size_t rounds,
             char const* items) {
  std::vector<std::vector<double>> times(contenders.size());
  for (std::size_t round = 0; round <= rounds; ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      // Whoever runs behind the slowest one shall not always be the same.
      std::size_t const turn = (i + round) % contenders.size();
      if (contenders[turn].prepare) contenders[turn].prepare();
      double const seconds = seconds_of(contenders[turn].run);
      // The first round fills caches.
      if (round > 0) times[turn].push_back(seconds);
    }
  }
  std::printf("%-34s %10s %9s %12s %9s\n", "", "ms", "MB/s", items, "ratio");
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    Contender const& contender = contenders[i];
    auto const count = static_cast<double>(contender.items);
    std::vector<double> ratios;
    for (std::size_t round = 0; round < rounds; ++round) {
      double const own = times[i][round] / count;
      ratios.push_back(times[reference][round] / static_cast<double>(contenders[reference].items) / own);
    }
    double const seconds = median(times[i]);
    std::printf("%-34s %10.2f %9.0f %12.0f %9.2f\n", contender.name, 1e3 * seconds,
                static_cast<double>(contender.bytes) / seconds / 1e6, count / seconds, median(ratios));
  }
  std::printf("\n");
}

}  // namespace axisc::bench
