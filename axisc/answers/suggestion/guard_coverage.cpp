#include "axisc/answers/suggestion/guard_coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace axisc::says {

constexpr Sentence within{
    "Vibration Guard leaves at most 5 % from {from} to {to} (a reading); the resonance, {resonance}, is "
    "within",
    "der Vibration Guard lässt von {from} bis {to} höchstens 5 % übrig (eine Lesart); die Resonanz, "
    "{resonance}, liegt darin"};
constexpr Sentence in_part{
    "Vibration Guard leaves at most 5 % from {from} to {to} (a reading); the resonance, {resonance}, may be "
    "outside",
    "der Vibration Guard lässt von {from} bis {to} höchstens 5 % übrig (eine Lesart); die Resonanz, "
    "{resonance}, kann außerhalb liegen"};
constexpr Sentence outside{
    "Vibration Guard leaves at most 5 % from {from} to {to} (a reading); the resonance, {resonance}, is "
    "outside",
    "der Vibration Guard lässt von {from} bis {to} höchstens 5 % übrig (eine Lesart); die Resonanz, "
    "{resonance}, liegt außerhalb"};
constexpr Sentence leaves{
    "Vibration Guard leaves {residual} at its own frequency and damping (a reading)",
    "der Vibration Guard lässt bei seiner eigenen Frequenz und Dämpfung {residual} übrig "
    "(eine Lesart)"};
constexpr Sentence widened{"{frequency} ± {uncertainty} (twice its uncertainty)",
                           "{frequency} ± {uncertainty} (das Doppelte ihrer Unsicherheit)"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

constexpr std::array<std::string_view, 4> coverage_symbols = {"within", "in_part", "outside", "no_interval"};

Coverage coverage_of(std::optional<design::Robustness> const& interval, double frequency,
                     double uncertainty) {
  if (!interval) return Coverage::no_interval;
  auto const contains = [&](double f) { return f >= interval->from.value && f <= interval->to.value; };
  if (!contains(frequency)) return Coverage::outside;
  bool const is_certain = contains(frequency - uncertainty) && contains(frequency + uncertainty);
  return is_certain ? Coverage::within : Coverage::in_part;
}

}  // namespace

std::optional<GuardCoverage> guard_coverage(tuning::Chain const& chain, tuning::Task const& task) {
  if (!chain.kernel || chain.kernel->type != design::KernelType::vibration_guard) return std::nullopt;
  auto const& guard = *chain.kernel;
  auto const kernel = design::design_kernel(guard, task.cycle_time);
  auto const ratio = [&](tuning::Resonance const& resonance) {
    return std::abs(std::log(resonance.frequency / guard.frequency.value));
  };
  auto const nearest = *std::min_element(
      task.resonances.begin(), task.resonances.end(),
      [&](tuning::Resonance const& a, tuning::Resonance const& b) { return ratio(a) < ratio(b); });
  GuardCoverage found{.guard = guard,
                      .interval = design::robustness(kernel, guard, task.cycle_time),
                      .residual = design::residual_at_design(kernel, guard, task.cycle_time),
                      .resonance = nearest,
                      .uncertainty = 2 * nearest.uncertainty};
  found.coverage = coverage_of(found.interval, nearest.frequency, found.uncertainty);
  return found;
}

Words coverage_words(GuardCoverage const& found) {
  constexpr int digits = 4;
  auto const hertz = [](double value) { return rounded(value, Unit::hertz, digits); };
  if (!found.interval) {
    return {says::leaves, {{"residual", fixed(found.residual, Unit::share, 1)}}};
  }
  constexpr std::array<SentenceRef, 3> sentences = {says::within, says::in_part, says::outside};
  Value resonance = hertz(found.resonance.frequency);
  if (found.uncertainty > 0) {
    constexpr int uncertain_digits = 2;
    resonance =
        Words(says::widened, {{"frequency", resonance},
                              {"uncertainty", rounded(found.uncertainty, Unit::hertz, uncertain_digits)}});
  }
  return {sentences.at(static_cast<std::size_t>(found.coverage)),
          {{"from", hertz(found.interval->from.value)},
           {"to", hertz(found.interval->to.value)},
           {"resonance", std::move(resonance)}}};
}

Section coverage_section(GuardCoverage const& found) {
  auto const bound = [&](design::Hertz design::Robustness::*member) {
    return found.interval ? std::optional(((*found.interval).*member).value) : std::nullopt;
  };
  return data_section(
      "guard", {data("mode", found.guard.order), data("frequency_hz", found.guard.frequency.value),
                data("damping", found.guard.quality), data("residual", found.residual),
                data("interval_from_hz", bound(&design::Robustness::from)),
                data("interval_to_hz", bound(&design::Robustness::to)),
                data("resonance_hz", found.resonance.frequency), data("uncertainty_hz", found.uncertainty),
                data("coverage", coverage_symbols.at(static_cast<std::size_t>(found.coverage)))});
}

}  // namespace axisc
