#include "analysis/tuning/suggestion/guard_candidates.hpp"

#include "design/kernels/vibration_guard.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace axisc::tuning {
namespace {

constexpr int lowest_percent = 85;  ///< of the resonance
constexpr int highest_percent = 115;
constexpr std::array usual_dampings = {0.02, 0.05, 0.1};

/// To a tenth of a hertz; where that is more than a step, to a hundredth.
design::Hertz rounded_frequency(double frequency) {
  constexpr double tenth_is_a_step = 10;
  double const per_hertz = frequency < tenth_is_a_step ? 100 : 10;
  return {std::round(frequency * per_hertz) / per_hertz};
}

std::vector<double> dampings_for(Resonance const& resonance) {
  std::vector<double> dampings(usual_dampings.begin(), usual_dampings.end());
  if (!resonance.damping) return dampings;
  constexpr double shown = 1000;
  double const known = std::round(*resonance.damping * shown) / shown;
  bool const is_usual = std::find(dampings.begin(), dampings.end(), known) != dampings.end();
  if (!is_usual && known < 1) dampings.insert(dampings.begin(), known);
  return dampings;
}

}  // namespace

std::vector<Chain> guard_candidates(Task const& task) {
  constexpr double lowest_frequency = 1;  // P-AXIS-00589
  auto const nyquist = design::as_read(task.cycle_time, task.readings.cycle_time).nyquist();
  std::vector<Chain> found;
  auto const add = [&](design::KernelSpecification const& guard) {
    if (design::guard_length(guard, task.cycle_time) > design::longest_usual_guard) return;
    Chain chain{.kernel = guard};
    if (std::find(found.begin(), found.end(), chain) == found.end()) found.push_back(std::move(chain));
  };
  for (auto const& resonance : task.resonances) {
    for (std::uint32_t mode = 1; mode <= design::guard_modes; ++mode) {
      for (int percent = lowest_percent; percent <= highest_percent; ++percent) {
        auto const frequency = rounded_frequency(resonance.frequency * percent / 100);
        if (frequency.value < lowest_frequency || !(frequency < nyquist)) continue;
        for (double const damping : dampings_for(resonance)) {
          add({.type = design::KernelType::vibration_guard,
               .order = mode,
               .frequency = frequency,
               .quality = damping,
               .reading = design::kernel_reading(task.readings.guard),
               .cycle_time = task.readings.cycle_time});
        }
      }
    }
  }
  return found;
}

bool is_coarse(design::KernelSpecification const& guard, ImpulseResponse const& response,
               design::CycleTime cycle_time) {
  design::KernelDesign kernel;
  kernel.taps = response.taps;
  return design::residual_at_design(kernel, guard, cycle_time) > design::usual_residual;
}

}  // namespace axisc::tuning
