#include "analysis/tuning/suggestion/largest_swing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace axisc::tuning {
namespace {

constexpr double found_within = 1e-4;
/// Points that are computed at once, so that the processor's vectors are used.
constexpr std::size_t lanes = 8;

/// One of the four parts of the edge.
struct BoundaryPart {
  bool is_arc = false;
  double fixed = 0;      ///< of a ray its angle in the plane of s, of an arc its frequency
  double curvature = 0;  ///< a bound of |q''| on it

  [[nodiscard]] std::complex<double> at(double t) const {
    return is_arc ? std::polar(fixed, t) : std::polar(t, fixed);
  }
  [[nodiscard]] std::complex<double> slope(double t) const {
    return is_arc ? std::complex<double>(0, 1) * at(t) : std::polar(1.0, fixed);
  }
  /// |s'| and |s''|.
  [[nodiscard]] double speed() const { return is_arc ? fixed : 1; }
  [[nodiscard]] double bend() const { return is_arc ? fixed : 0; }
};

struct Interval {
  BoundaryPart const* part;
  double from, to;

  [[nodiscard]] double middle() const { return (from + to) / 2; }
  [[nodiscard]] double half() const { return (to - from) / 2; }
};

/// Σ |a[k]| m² |e^s|^m with m = n - k, at its largest over the cycles that count.
double curvature_bound(Drive const& drive, double radius) {
  double zeroth = 0;
  double first = 0;
  double second = 0;
  double largest = 0;
  std::size_t const end = std::max(drive.jumps.size(), drive.rest + 1);
  for (std::size_t n = 0; n < end; ++n) {
    second = radius * (second + 2 * first + zeroth);
    first = radius * (first + zeroth);
    zeroth = radius * zeroth + (n < drive.jumps.size() ? std::abs(drive.jumps[n]) : 0);
    if (n >= drive.rest) largest = std::max(largest, second);
  }
  return largest;
}

/// Squares, at their largest over the cycles that count: of q in the middle, of q + q' ds at both ends, of
/// q'.
struct Squares {
  std::array<double, lanes> middle{}, low{}, high{}, slope{};
};

class Pass {
 public:
  /// One pass for up to `lanes` intervals.
  Pass(Drive const& drive, Interval const* intervals, std::size_t count) {
    std::array<double, lanes> pr{}, pi{}, hr{}, hi{};
    for (std::size_t i = 0; i < lanes; ++i) {
      auto const& interval = intervals[std::min(i, count - 1)];
      auto const p = std::exp(interval.part->at(interval.middle()));
      auto const reach = interval.half() * interval.part->slope(interval.middle());
      pr[i] = p.real();
      pi[i] = p.imag();
      hr[i] = reach.real();
      hi[i] = reach.imag();
    }
    std::array<double, lanes> qr{}, qi{}, dr{}, di{};
    std::size_t const end = std::max(drive.jumps.size(), drive.rest + 1);
    for (std::size_t n = 0; n < end; ++n) {
      double const jump = n < drive.jumps.size() ? drive.jumps[n] : 0;
      for (std::size_t i = 0; i < lanes; ++i) {
        double const sr = dr[i] + qr[i];
        double const si = di[i] + qi[i];
        dr[i] = sr * pr[i] - si * pi[i];
        di[i] = sr * pi[i] + si * pr[i];
        double const next = qr[i] * pr[i] - qi[i] * pi[i] + jump;
        qi[i] = qr[i] * pi[i] + qi[i] * pr[i];
        qr[i] = next;
      }
      if (n < drive.rest) continue;
      for (std::size_t i = 0; i < lanes; ++i) {
        double const er = dr[i] * hr[i] - di[i] * hi[i];
        double const ei = dr[i] * hi[i] + di[i] * hr[i];
        take(squares_.middle[i], qr[i], qi[i]);
        take(squares_.low[i], qr[i] - er, qi[i] - ei);
        take(squares_.high[i], qr[i] + er, qi[i] + ei);
        take(squares_.slope[i], dr[i], di[i]);
      }
    }
  }

  [[nodiscard]] double found(std::size_t i, Interval const& interval) const {
    return std::sqrt(squares_.middle.at(i)) / interval.part->at(interval.middle()).imag();
  }
  [[nodiscard]] double bound(std::size_t i, Interval const& interval) const {
    auto const& part = *interval.part;
    double const low = part.at(interval.from).imag();
    double const high = part.at(interval.to).imag();
    double const h = interval.half();
    double const way = h * part.speed();
    double const rest =
        (part.bend() * h * h * std::sqrt(squares_.slope.at(i)) + part.curvature * way * way) / 2;
    return std::max(std::sqrt(squares_.low.at(i)) / low, std::sqrt(squares_.high.at(i)) / high) +
           rest / std::min(low, high);
  }

 private:
  static void take(double& largest, double re, double im) {
    double const square = re * re + im * im;
    largest = square > largest ? square : largest;
  }

  Squares squares_;
};

/// The angle of a ray in the plane of s.
double angle_of(double damping) {
  return std::numbers::pi / 2 + std::asin(damping);
}

}  // namespace

double swing(Drive const& drive, double frequency, double damping) {
  BoundaryPart const ray{.is_arc = false, .fixed = angle_of(damping)};
  Interval const point{.part = &ray, .from = frequency, .to = frequency};
  return Pass(drive, &point, 1).found(0, point);
}

double swing_at_least(Drive const& drive, SwingBand const& band) {
  // Most often it is largest with the least damping, or at one of the other corners.
  constexpr std::size_t places = 16;
  constexpr std::size_t on_ray = 11;
  std::array<double, places> pr{}, pi{}, qr{}, qi{}, largest{}, scale{};
  for (std::size_t i = 0; i < places; ++i) {
    auto const share = [](std::size_t at, std::size_t of) {
      return static_cast<double>(at) / static_cast<double>(of);
    };
    double const along = i < on_ray ? share(i, on_ray - 1) : share((i - on_ray) % 3, 2);
    double const frequency = band.lowest + along * (band.highest - band.lowest);
    double const middle = std::sqrt(band.least_damping * band.most_damping);
    double const damping = i < on_ray ? band.least_damping : i < on_ray + 3 ? band.most_damping : middle;
    auto const s = std::polar(frequency, angle_of(damping));
    pr.at(i) = std::exp(s).real();
    pi.at(i) = std::exp(s).imag();
    scale.at(i) = 1 / s.imag();
  }
  std::size_t const end = std::max(drive.jumps.size(), drive.rest + 1);
  for (std::size_t n = 0; n < end; ++n) {
    double const jump = n < drive.jumps.size() ? drive.jumps[n] : 0;
    for (std::size_t i = 0; i < places; ++i) {
      double const next = qr[i] * pr[i] - qi[i] * pi[i] + jump;
      qi[i] = qr[i] * pi[i] + qi[i] * pr[i];
      qr[i] = next;
    }
    if (n < drive.rest) continue;
    for (std::size_t i = 0; i < places; ++i) {
      double const square = qr[i] * qr[i] + qi[i] * qi[i];
      largest[i] = square > largest[i] ? square : largest[i];
    }
  }
  double found = 0;
  for (std::size_t i = 0; i < places; ++i) found = std::max(found, std::sqrt(largest[i]) * scale[i]);
  return found;
}

double largest_swing(Drive const& drive, SwingBand const& band, double negligible) {
  constexpr std::size_t pieces = 4;
  double const least = angle_of(band.least_damping);
  double const most = angle_of(band.most_damping);
  auto const bound = [&](double frequency, double damping) {
    return curvature_bound(drive, std::exp(-frequency * damping));
  };
  std::array const parts{
      BoundaryPart{.is_arc = false, .fixed = least, .curvature = bound(band.lowest, band.least_damping)},
      BoundaryPart{.is_arc = false, .fixed = most, .curvature = bound(band.lowest, band.most_damping)},
      BoundaryPart{.is_arc = true, .fixed = band.lowest, .curvature = bound(band.lowest, band.least_damping)},
      BoundaryPart{
          .is_arc = true, .fixed = band.highest, .curvature = bound(band.highest, band.least_damping)}};
  std::vector<Interval> open;
  for (auto const& part : parts) {
    double const from = part.is_arc ? least : band.lowest;
    double const to = part.is_arc ? most : band.highest;
    // The corners are on the rays: as intervals of one point.
    if (!part.is_arc) {
      open.push_back({.part = &part, .from = from, .to = from});
      open.push_back({.part = &part, .from = to, .to = to});
    }
    for (std::size_t i = 0; i < pieces; ++i) {
      double const width = (to - from) / pieces;
      double const begin = from + width * static_cast<double>(i);
      open.push_back({.part = &part, .from = begin, .to = i + 1 == pieces ? to : begin + width});
    }
  }
  double largest = swing_at_least(drive, band);
  std::vector<double> bounds;
  std::vector<Interval> halves;
  while (!open.empty()) {
    bounds.clear();
    for (std::size_t first = 0; first < open.size(); first += lanes) {
      std::size_t const count = std::min(lanes, open.size() - first);
      Pass const pass(drive, open.data() + first, count);
      for (std::size_t i = 0; i < count; ++i) {
        largest = std::max(largest, pass.found(i, open[first + i]));
        bounds.push_back(pass.bound(i, open[first + i]));
      }
    }
    halves.clear();
    double const enough = largest * (1 + found_within) + negligible;
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (!(bounds[i] > enough)) continue;
      auto const& [part, from, to] = open[i];
      halves.push_back({.part = part, .from = from, .to = open[i].middle()});
      halves.push_back({.part = part, .from = open[i].middle(), .to = to});
    }
    std::swap(open, halves);
  }
  return largest;
}

}  // namespace axisc::tuning
