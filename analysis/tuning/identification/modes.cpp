#include "analysis/tuning/identification/modes.hpp"

#include "analysis/tuning/identification/thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace axisc::tuning {
namespace {

/// Longer pieces at constant speed are cut: in a finer spectrum a resonance is no line any more.
constexpr double longest_piece = 1.5;
/// More pieces than these prove no more; those that count are spread over the recordings.
constexpr std::size_t most_pieces = 500;

bool agree(double a, double b) {
  return std::abs(a - b) <= largest_disagreement * std::min(a, b);
}

bool is_spectrum(Measurement const& recording) {
  return recording.kind == MeasurementKind::spectrum;
}

/// What the responses of the recordings have in common.
struct Responses {
  std::vector<FoundMode> modes;
  std::optional<Disagreement> disagreement;
};

/// A recording counts in the vote where it shows peaks, or would show them.
bool votes(Identification const& found) {
  return !found.peaks.empty() || found.doubt == Doubt::no_peak || found.doubt == Doubt::moving;
}

FoundMode found_mode(std::vector<Peak const*> const& peaks, Evidence evidence) {
  auto const* const best = *std::min_element(peaks.begin(), peaks.end(), [](Peak const* a, Peak const* b) {
    return a->frequency_uncertainty < b->frequency_uncertainty;
  });
  FoundMode mode{.frequency = 0,
                 .frequency_uncertainty = best->frequency_uncertainty,
                 .damping = best->damping,
                 .damping_uncertainty = best->damping_uncertainty,
                 .coherence = best->coherence,
                 .ratio = best->ratio,
                 .evidence = {evidence},
                 .is_told_from_shaking = evidence != Evidence::spectrum};
  double weights = 0;
  double low = best->frequency, high = best->frequency;
  for (auto const* const peak : peaks) {
    double const weight = 1 / (peak->frequency_uncertainty * peak->frequency_uncertainty);
    mode.frequency += weight * peak->frequency;
    weights += weight;
    low = std::min(low, peak->frequency);
    high = std::max(high, peak->frequency);
  }
  mode.frequency = peaks.size() == 1 || !std::isfinite(weights) ? best->frequency : mode.frequency / weights;
  mode.frequency_uncertainty = std::max(mode.frequency_uncertainty, (high - low) / 2);
  return mode;
}

/// Modes that more than half of the recordings that vote show.
Responses common_modes(std::span<Measurement const> recordings, std::vector<Identification> const& found) {
  Responses responses;
  auto const voters = static_cast<std::size_t>(std::count_if(found.begin(), found.end(), votes));
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (auto const& peak : found[i].peaks) {
      bool const is_known =
          std::any_of(responses.modes.begin(), responses.modes.end(), [&](auto const& mode) {
            return std::abs(mode.frequency - peak.frequency) <= largest_movement * mode.frequency;
          });
      if (is_known) continue;
      std::vector<Peak const*> same;
      for (auto const& other : found) {
        Peak const* nearest = nullptr;
        auto const distance = [&](Peak const& one) { return std::abs(one.frequency - peak.frequency); };
        for (auto const& one : other.peaks) {
          if (distance(one) > largest_movement * peak.frequency) continue;
          if (nearest == nullptr || distance(one) < distance(*nearest)) nearest = &one;
        }
        if (nearest != nullptr) same.push_back(nearest);
      }
      auto const kind = is_spectrum(recordings[i]) ? Evidence::spectrum : Evidence::response;
      if (2 * same.size() > voters) {
        responses.modes.push_back(found_mode(same, kind));
      } else if (!responses.disagreement) {
        responses.disagreement =
            Disagreement{.evidence = {kind, kind}, .frequencies = {peak.frequency, 0}, .recordings = {i, i}};
      } else if (auto& [of, frequencies, of_recordings] = *responses.disagreement;
                 frequencies[1] == 0 &&
                 std::abs(peak.frequency - frequencies[0]) > largest_movement * frequencies[0]) {
        frequencies[1] = peak.frequency;
        of_recordings[1] = i;
      }
    }
  }
  if (!responses.modes.empty()) responses.disagreement.reset();
  return responses;
}

struct Signals {
  std::vector<SteadySignal> resting, moving;
};

void cut(std::vector<SteadySignal>& into, Measurement const& recording, Piece const& piece) {
  double const seconds = static_cast<double>(piece.count) / recording.sampling_rate;
  auto const parts = static_cast<std::size_t>(std::max(1.0, std::ceil(seconds / longest_piece)));
  std::size_t const length = piece.count / parts;
  for (std::size_t i = 0; i < parts; ++i) {
    into.push_back({.values = std::span(recording.out).subspan(piece.first + i * length, length),
                    .sampling_rate = recording.sampling_rate,
                    .speed = piece.speed});
  }
}

/// Every n-th by speed: of each speed some stay.
void thin_out(std::vector<SteadySignal>& signals) {
  std::size_t const every = signals.size() / most_pieces + 1;
  if (every == 1) return;
  std::stable_sort(signals.begin(), signals.end(),
                   [](auto const& left, auto const& right) { return left.speed < right.speed; });
  std::vector<SteadySignal> kept;
  for (std::size_t i = 0; i < signals.size(); i += every) kept.push_back(signals[i]);
  signals = std::move(kept);
}

Signals signals_of(std::span<Measurement const> recordings) {
  Signals signals;
  for (auto const& recording : recordings) {
    if (recording.kind != MeasurementKind::signals) continue;
    auto const pieces = motion_pieces(recording.in, recording.sampling_rate, recording.input);
    for (auto const& rest : pieces.rests) {
      signals.resting.push_back({.values = std::span(recording.out).subspan(rest.first, rest.count),
                                 .sampling_rate = recording.sampling_rate});
    }
    for (auto const& piece : pieces.constant) cut(signals.moving, recording, piece);
  }
  return signals;
}

/// The strongest ones.
std::vector<FoundMode> modes_of(SpectralLines const& lines) {
  std::vector<SpectralLine> constant;
  std::copy_if(lines.lines.begin(), lines.lines.end(), std::back_inserter(constant),
               [](SpectralLine const& line) { return line.kind == LineKind::constant; });
  std::stable_sort(constant.begin(), constant.end(),
                   [](SpectralLine const& a, SpectralLine const& b) { return a.amplitude > b.amplitude; });
  if (constant.size() > most_peaks) constant.resize(most_peaks);
  std::vector<FoundMode> modes;
  modes.reserve(constant.size());
  for (auto const& line : constant) {
    modes.push_back({.frequency = line.frequency,
                     .frequency_uncertainty = line.frequency_uncertainty,
                     .evidence = {Evidence::lines},
                     .is_told_from_shaking = lines.were_rests_compared});
  }
  return modes;
}

/// One kind says what another one does not.
std::optional<Disagreement> disagreement_of(std::span<std::vector<FoundMode> const> kinds) {
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    for (std::size_t k = i + 1; k < kinds.size(); ++k) {
      if (kinds[i].empty() || kinds[k].empty()) continue;
      bool const has_common = std::any_of(kinds[i].begin(), kinds[i].end(), [&](FoundMode const& one) {
        return std::any_of(kinds[k].begin(), kinds[k].end(),
                           [&](FoundMode const& other) { return agree(one.frequency, other.frequency); });
      });
      if (has_common) continue;
      auto const& [one, other] = std::pair(kinds[i].front(), kinds[k].front());
      return Disagreement{.evidence = {one.evidence.front(), other.evidence.front()},
                          .frequencies = {one.frequency, other.frequency}};
    }
  }
  return std::nullopt;
}

/// The more certain frequency, with an uncertainty that reaches the other one.
void merge(FoundMode& mode, FoundMode const& other) {
  double const apart = std::abs(mode.frequency - other.frequency);
  if (other.frequency_uncertainty < mode.frequency_uncertainty) {
    mode.frequency = other.frequency;
    mode.frequency_uncertainty = other.frequency_uncertainty;
  }
  mode.frequency_uncertainty = std::max(mode.frequency_uncertainty, apart);
  // A response shows the mechanics, ring-down the closed loop.
  if (!mode.damping) {
    mode.damping = other.damping;
    mode.damping_uncertainty = other.damping_uncertainty;
  }
  mode.is_told_from_shaking |= other.is_told_from_shaking;
  mode.evidence.insert(mode.evidence.end(), other.evidence.begin(), other.evidence.end());
}

std::vector<FoundMode> united(std::span<std::vector<FoundMode> const> kinds) {
  std::vector<FoundMode> modes;
  for (auto const& kind : kinds) {
    for (auto const& mode : kind) {
      auto const same = std::find_if(modes.begin(), modes.end(), [&](FoundMode const& known) {
        return known.evidence.front() != mode.evidence.front() && agree(known.frequency, mode.frequency);
      });
      if (same == modes.end()) {
        modes.push_back(mode);
      } else {
        merge(*same, mode);
      }
    }
  }
  std::stable_sort(modes.begin(), modes.end(), [](FoundMode const& a, FoundMode const& b) {
    return a.evidence.size() > b.evidence.size();
  });
  if (modes.size() > most_peaks) modes.resize(most_peaks);
  std::sort(modes.begin(), modes.end(),
            [](FoundMode const& a, FoundMode const& b) { return a.frequency < b.frequency; });
  return modes;
}

/// How much a refused response says: one that is uncertain more than one that was not excited.
double weight_of(Identification const& found) {
  if (!found.doubt) return 0;
  switch (*found.doubt) {
    case Doubt::moving: return std::numeric_limits<double>::max();
    case Doubt::uncertain: return found.doubtful_ratio;
    case Doubt::incoherent:
    case Doubt::noisy: return lowest_ratio;
    case Doubt::no_peak: return -1;
    case Doubt::no_excitation: return -2;
    case Doubt::too_short: return -3;
  }
  return 0;
}

}  // namespace

ModeSearch find_modes(std::span<Measurement const> recordings, double highest) {
  std::vector<Identification> found;
  for (auto const& recording : recordings) found.push_back(identify(recording, highest));
  auto responses = common_modes(recordings, found);
  auto signals = signals_of(recordings);

  ModeSearch answer;
  answer.rests = signals.resting.size();
  auto const loudest = std::max_element(
      found.begin(), found.end(), [](auto const& a, auto const& b) { return weight_of(a) < weight_of(b); });
  answer.response = *loudest;
  std::array<std::vector<FoundMode>, 3> kinds{std::move(responses.modes)};
  auto const rung = ring_down(signals.resting, highest);
  if (auto const* const ring = std::get_if<RingDown>(&rung)) {
    kinds[1].push_back({.frequency = ring->frequency,
                        .frequency_uncertainty = ring->frequency_uncertainty,
                        .damping = ring->damping,
                        .damping_uncertainty = ring->damping_uncertainty,
                        .evidence = {Evidence::ring_down}});
  } else {
    answer.ring_down = std::get<BadRingDown>(rung);
  }
  thin_out(signals.resting);
  thin_out(signals.moving);
  answer.pieces = signals.moving.size();
  auto lines = spectral_lines(signals.moving, signals.resting, lowest_frequency, highest);
  kinds[2] = modes_of(lines);
  answer.lines = lines.doubt;
  std::copy_if(lines.lines.begin(), lines.lines.end(), std::back_inserter(answer.others),
               [](SpectralLine const& line) { return line.kind != LineKind::constant; });

  answer.disagreement = responses.disagreement ? responses.disagreement : disagreement_of(kinds);
  if (!answer.disagreement) answer.modes = united(kinds);
  return answer;
}

}  // namespace axisc::tuning
