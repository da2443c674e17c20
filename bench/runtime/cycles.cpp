#include "bench/runtime/cycles.hpp"

#include "image/runtime_host.hpp"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <vector>

namespace axisc::bench {
namespace {

constexpr std::size_t cycles = 1'000'000;
constexpr std::size_t frames = 64;

using Step = std::function<void(double const* in, double* out)>;

/// Nanoseconds of each cycle, sorted; with the time that reading the clock takes.
struct Distribution {
  std::vector<std::uint32_t> sorted;
  [[nodiscard]] double at(double share) const {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  }
};

std::vector<double> moving(std::size_t axes, double amplitude) {
  std::vector<double> inputs(frames * axes);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    double const phase = 2 * 3.14159265358979 * static_cast<double>(i / axes) / frames;
    inputs[i] = 1e9 + amplitude * std::sin(phase + static_cast<double>(i % axes));
  }
  return inputs;
}

template <class Before>
Distribution measure(std::vector<double> const& inputs, std::size_t axes, std::size_t count, Step const& step,
                     Before before) {
  std::vector<double> out(axes);
  Distribution result;
  result.sorted.reserve(count);
  for (std::size_t cycle = 0; cycle < count; ++cycle) {
    before();
    auto const begin = std::chrono::steady_clock::now();
    step(inputs.data() + cycle % frames * axes, out.data());
    auto const time = std::chrono::steady_clock::now() - begin;
    benchmark::DoNotOptimize(out.data());
    auto const ns = std::chrono::duration_cast<std::chrono::nanoseconds>(time).count();
    result.sorted.push_back(static_cast<std::uint32_t>(std::min<std::int64_t>(ns, 4'000'000'000)));
  }
  std::sort(result.sorted.begin(), result.sorted.end());
  return result;
}

void print(char const* name, Distribution const& d) {
  std::printf("%-28s %8.0f %8.0f %8.0f %8.0f %8.0f\n", name, d.at(0.5), d.at(0.99), d.at(0.999), d.at(0.9999),
              d.at(1));
}

/// ns per cycle of many in a row, the best of 15 rounds in which both take turns.
struct Pair {
  double first, second;
};
Pair take_turns(std::size_t rounds, std::size_t count, std::function<void()> const& first,
                std::function<void()> const& second) {
  Pair best{.first = 1e300, .second = 1e300};
  auto const time = [count](std::function<void()> const& call) {
    auto const begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < count; ++i) call();
    std::chrono::duration<double, std::nano> const passed = std::chrono::steady_clock::now() - begin;
    return passed.count() / static_cast<double>(count);
  };
  for (std::size_t round = 0; round < rounds; ++round) {
    best.first = std::min(best.first, time(first));
    best.second = std::min(best.second, time(second));
  }
  return best;
}

image::RuntimeHost host_of(Contender const& contender) {
  auto made = image::RuntimeHost::create(contender.image, std::nullopt, AXISRT_LEVEL_AUTOMATIC);
  auto host = std::get<image::RuntimeHost>(std::move(made));
  static_cast<void>(host.reset_all(1e9));
  return host;
}

void report_standstill(Contender const& contender, std::size_t axes) {
  auto still = host_of(contender);
  auto moved = host_of(contender);
  auto const inputs = moving(axes, 1e4);
  std::vector<double> const rest(axes, 1e9);
  std::vector<double> out(axes);
  std::size_t cycle = 0;
  // A push, then rest: the states decay towards zero all the while.
  static_cast<void>(still.step({inputs.data(), axes}, out));
  Pair const turns = take_turns(
      100, 10'000, [&] { static_cast<void>(still.step(rest, out)); },
      [&] {
        static_cast<void>(moved.step({inputs.data() + cycle++ % frames * axes, axes}, out));
      });
  std::printf("standstill %.1f ns, motion %.1f ns a cycle: %.3f\n", turns.first, turns.second,
              turns.first / turns.second);
  // At zero, with numbers that some processors need a hundred times as long for.
  static_cast<void>(still.reset_all(0));
  std::vector<double> const tiny[] = {std::vector<double>(axes, 0x1.8p-1060),
                                      std::vector<double>(axes, 0x1p-499)};
  Pair const at_zero = take_turns(
      100, 10'000, [&] { static_cast<void>(still.step(tiny[cycle++ / 50 % 2], out)); },
      [&] {
        static_cast<void>(moved.step({inputs.data() + cycle++ % frames * axes, axes}, out));
      });
  std::printf("tiny setpoints %.1f ns, motion %.1f ns a cycle: %.3f\n", at_zero.first, at_zero.second,
              at_zero.first / at_zero.second);
}

void report_recorder(Contender const& contender, std::size_t axes) {
  auto plain = host_of(contender);
  auto recorded = host_of(contender);
  static_cast<void>(recorded.record(1000));
  auto const inputs = moving(axes, 1e4);
  std::vector<double> out(axes);
  std::size_t cycle = 0;
  auto const next = [&] { return std::span<double const>(inputs.data() + cycle++ % frames * axes, axes); };
  Pair const turns = take_turns(
      15, 10'000, [&] { static_cast<void>(recorded.step(next(), out)); },
      [&] { static_cast<void>(plain.step(next(), out)); });
  std::printf("recorded %.1f ns, not recorded %.1f ns a cycle: %.2f\n", turns.first, turns.second,
              turns.first / turns.second);
}

}  // namespace

void report_cycles(Contender& contender, std::size_t axes) {
  auto host = host_of(contender);
  auto const inputs = moving(axes, 1e4);
  Step const runtime = [&](double const* in, double* out) {
    static_cast<void>(host.step({in, axes}, {out, axes}));
  };
  Step const plain = [&](double const* in, double* out) { step_plain(contender.plain, in, out); };
  Step const nothing = [](double const* /*in*/, double* /*out*/) {};
  auto const at_once = [] {};
  constexpr std::size_t larger_than_caches = std::size_t{64} << 20U;
  std::vector<std::uint8_t> other(larger_than_caches);
  auto const with_cold_caches = [&] {
    for (std::size_t i = 0; i < other.size(); i += 64) other[i] = static_cast<std::uint8_t>(other[i] + 1);
    benchmark::DoNotOptimize(other.data());
  };
  constexpr std::size_t cold_cycles = 300;
  std::printf("\nns of single cycles, %zu axes    median      p99    p99.9   p99.99  largest\n", axes);
  print("reading the clock", measure(inputs, axes, cycles, nothing, at_once));
  print("runtime", measure(inputs, axes, cycles, runtime, at_once));
  print("plain loop", measure(inputs, axes, cycles, plain, at_once));
  print("runtime, cold caches", measure(inputs, axes, cold_cycles, runtime, with_cold_caches));
  print("plain loop, cold caches", measure(inputs, axes, cold_cycles, plain, with_cold_caches));
  report_standstill(contender, axes);
  report_recorder(contender, axes);
}

}  // namespace axisc::bench
