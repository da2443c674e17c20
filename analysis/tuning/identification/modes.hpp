// Resonances of an axis in several recordings, with what proves each.
//
// Three kinds of evidence are looked for: a response (resonances.hpp), ring-down (ring_down.hpp) and lines
// (spectral_lines.hpp). The answer is one that all of them bear out, or none.
#pragma once

#include "analysis/tuning/identification/measurement.hpp"
#include "analysis/tuning/identification/ring_down.hpp"
#include "analysis/tuning/identification/spectral_lines.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace axisc::tuning {

enum class Evidence : std::uint8_t { response, ring_down, lines, spectrum };

/// A resonance. What the kind of evidence does not tell is absent.
struct FoundMode {
  double frequency = 0;              ///< natural, Hz
  double frequency_uncertainty = 0;  ///< Hz
  std::optional<double> damping{}, damping_uncertainty{};
  std::optional<double> coherence{}, ratio{};  ///< of a response
  std::vector<Evidence> evidence{};            ///< in the order of the enumeration
  /// Whether it is told from what shakes the axis at rest as well, a fan say. Lines tell where the axis rests
  /// for twice shortest_piece.
  bool is_told_from_shaking = true;
};

/// What two sources say about the resonance, where they do not agree.
struct Disagreement {
  std::array<Evidence, 2> evidence{};
  std::array<double, 2> frequencies{};      ///< Hz
  std::array<std::size_t, 2> recordings{};  ///< of two responses
};

struct ModeSearch {
  std::vector<FoundMode> modes;      ///< by rising frequency, at most most_peaks
  std::vector<SpectralLine> others;  ///< lines that are not resonances

  // Why there is no mode, where there is none.
  std::optional<Disagreement> disagreement{};
  Identification response{};          ///< of the recording that comes closest to showing a mode
  std::size_t rests = 0, pieces = 0;  ///< at rest after a motion, at constant speed
  std::optional<BadRingDown> ring_down{};
  std::optional<LinesDoubt> lines{};
};

/// Of one axis, at least one recording. Searches below `highest` Hz. Cost: that of the kinds of evidence.
[[nodiscard]] ModeSearch find_modes(std::span<Measurement const> recordings, double highest);

}  // namespace axisc::tuning
