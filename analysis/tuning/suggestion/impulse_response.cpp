#include "analysis/tuning/suggestion/impulse_response.hpp"

#include "codegen/image_writer.hpp"
#include "image/runtime_host.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace axisc::tuning {
namespace {

constexpr std::size_t longest_response = std::size_t{1} << 17U;
/// Longer than any kernel: if nothing changes for this long, nothing follows.
constexpr std::size_t settled_cycles = design::longest_guard + 64;
constexpr double settled_within = 1e-13;
constexpr double negligible = 1e-9;

machine::Machine machine_of(std::span<Chain const> chains, design::CycleTime cycle_time) {
  machine::Machine machine;
  machine.name = "candidates";
  machine.cycle_time = cycle_time;
  for (auto const& chain : chains) {
    auto& axis = machine.axes.emplace_back();
    axis.number = static_cast<std::uint32_t>(machine.axes.size());
    axis.name = std::to_string(axis.number);
    std::uint32_t index = 0;
    for (auto const& filter : chain.filters) {
      axis.filters.push_back({.index = index, .specification = filter});
      ++index;
    }
    if (!chain.kernel) continue;
    axis.kernel = machine::ConfiguredKernel{.family = family_of(chain, machine::KernelFamily::fir),
                                            .index = 0,
                                            .specification = *chain.kernel,
                                            .on_at_start = true};
  }
  return machine;
}

void cut_off_end(std::vector<double>& taps) {
  double left = 0;
  while (taps.size() > 1 && left + std::abs(taps.back()) < negligible) {
    left += std::abs(taps.back());
    taps.pop_back();
  }
}

double delay_of(std::vector<double> const& taps) {
  double delay = 0;
  for (std::size_t n = 0; n < taps.size(); ++n) delay += static_cast<double>(n) * taps[n];
  return delay;
}

}  // namespace

bool ImpulseResponse::blocks_constant() const {
  constexpr double half = 0.5;
  return std::accumulate(taps.begin(), taps.end(), 0.0) < half;
}

std::vector<ImpulseResponse> impulse_responses(std::span<Chain const> chains, design::CycleTime cycle_time) {
  if (chains.empty()) return {};
  auto created = image::RuntimeHost::create(
      codegen::write_image(machine_of(chains, cycle_time), {.strip = true, .image_version = 0}));
  if (!std::holds_alternative<image::RuntimeHost>(created)) {
    throw std::logic_error("the runtime refuses a candidate");
  }
  auto& host = std::get<image::RuntimeHost>(created);
  static_cast<void>(host.reset_all(0));
  std::vector<double> const in(chains.size(), 1.0);
  std::vector<double> out(chains.size());
  std::vector<double> before(chains.size(), 0.0);
  std::vector<ImpulseResponse> responses(chains.size(), ImpulseResponse{.taps = {}, .delay = 0});
  std::size_t steady = 0;
  for (std::size_t n = 0; n < longest_response && steady < settled_cycles; ++n) {
    static_cast<void>(host.step(in, out));
    bool changes = false;
    for (std::size_t i = 0; i < out.size(); ++i) {
      double const tap = out[i] - before[i];
      responses[i].taps.push_back(tap);
      changes = changes || std::abs(tap) > settled_within;
    }
    before = out;
    steady = changes ? 0 : steady + 1;
  }
  for (auto& response : responses) {
    cut_off_end(response.taps);
    response.delay = delay_of(response.taps);
  }
  return responses;
}

ImpulseResponse in_series(ImpulseResponse const& first, ImpulseResponse const& second) {
  auto const& [a, b] =
      std::minmax(first.taps, second.taps, [](auto const& x, auto const& y) { return x.size() < y.size(); });
  ImpulseResponse both{.taps = std::vector<double>(a.size() + b.size() - 1),
                       .delay = first.delay + second.delay};
  for (std::size_t i = 0; i < a.size(); ++i) {
    double const factor = a[i];
    if (factor == 0) continue;
    double* const target = both.taps.data() + i;
    for (std::size_t k = 0; k < b.size(); ++k) target[k] += factor * b[k];
  }
  return both;
}

}  // namespace axisc::tuning
