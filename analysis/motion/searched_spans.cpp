#include "analysis/motion/searched_spans.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace axisc::motion {
namespace {

/// The sine of an angle halfway between two places is within 0.12 % of the larger one next to its peak.
constexpr double places_per_turn = 64;

/// Places at which a steady stretch of this many cycles is searched, its two ends not counted.
std::size_t places_within(TimedPiece const& piece, double cycles) {
  auto const* const arc = piece.path.arc();
  if (arc == nullptr) return 0;
  double const way = piece.phase.velocity * std::max(0.0, cycles);
  double const share = std::min(1.0, way / arc->length);
  double const turns = share * std::abs(arc->sweep) / (2 * std::numbers::pi);
  return static_cast<std::size_t>(std::ceil(turns * places_per_turn));
}

}  // namespace

std::vector<TrialSpan> searched_spans(std::span<TimedPiece const> path, TrialSpan const& span, double before,
                                      double after) {
  std::vector<TrialSpan> parts;
  double begun = span.from;
  auto const add = [&](double from, double to) {
    auto& part = parts.emplace_back(span);
    part.from = from;
    part.to = to;
  };
  auto const first = std::partition_point(path.begin(), path.end(),
                                          [&](TimedPiece const& piece) { return piece.end() < span.from; });
  for (auto piece = first; piece != path.end() && piece->start < span.to; ++piece) {
    if (!piece->phase.is_steady()) continue;
    double const from = std::max(begun, piece->start + before);
    double const to = std::min(span.to, piece->end() - after);
    std::size_t const places = places_within(*piece, to - from);
    double const apart = (to - from) / static_cast<double>(places + 1);
    // A place costs as much as the cycles that lead to it.
    if (!(apart > 2 * (before + after))) continue;
    add(begun, from);
    for (std::size_t i = 1; i <= places; ++i) {
      double const place = from + static_cast<double>(i) * apart;
      add(place, place + 1);
    }
    begun = to;
  }
  add(begun, span.to);
  return parts;
}

}  // namespace axisc::motion
