#include "design/filter_analysis.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace axisc::design {
namespace {

using Complex = std::complex<double>;

/// A transfer function at one u = z^-1, with its derivative there.
struct Value {
  Complex h = 1;
  Complex dh_du = 0;
  bool vanishes = false;  ///< nothing but rounding is left of h
};

Value operator*(Value const& x, Value const& y) {
  return {x.h * y.h, x.dh_du * y.h + x.h * y.dh_du, x.vanishes || y.vanishes};
}

/// A sum of two parts that cancel down to this share of them is zero.
constexpr double cancelled = 4 * std::numeric_limits<double>::epsilon();

/// Where on the unit circle: u = z^-1 = e^(-jθ), w = 1 - u = 2 sin²(θ/2) + j sin θ without cancellation.
struct Point {
  Complex u;
  Complex w;
};

double angle(Hertz frequency, CycleTime cycle_time) {
  return 2 * std::numbers::pi * cycle_time.periods_in<double>(frequency);
}

Point point_at(double theta) {
  double const half_sine = std::sin(theta / 2);
  return {std::polar(1.0, -theta), {2 * half_sine * half_sine, std::sin(theta)}};
}

/// With A = w² + (1 - w)(k + b w) and G = (p + q u) w/A:  H = 1 + G, or G where the constant part is blocked.
Value section_at(IncrementSection const& section, bool blocks_constant, Point const& at) {
  auto const [p, q, k, b] = section;
  Complex const& w = at.w;
  Complex const a = w * w + at.u * (k + b * w);
  Complex const da_du = -(2.0 * w - (k + b * w) + b * at.u);
  Complex const numerator =
      (p + q) - q * w;  // p + q u; p and q nearly cancel at low characteristic frequencies
  Complex const m = numerator * w;
  Complex const dm_du = q * w - numerator;
  Complex const g = m / a;
  Complex const dg_du = (dm_du - g * da_du) / a;
  if (blocks_constant) {
    return {g, dg_du, std::abs(m) <= cancelled * std::abs(w) * (std::abs(p) + std::abs(q))};
  }
  return {1.0 + g, dg_du, std::abs(1.0 + g) <= cancelled * (1 + std::abs(g))};
}

Value delay_at(std::uint32_t cycles, double theta) {
  if (cycles == 0) return {};
  double const n = cycles;
  return {std::polar(1.0, -n * theta), n * std::polar(1.0, -(n - 1) * theta)};
}

/// direct + filtered·H
Value blended(Share const& share, Value const& full) {
  if (share.filtered == 1) return full;
  Complex const part = share.filtered * full.h;
  Complex const h = share.direct + part;
  return {h, share.filtered * full.dh_du,
          (share.direct == 0 && full.vanishes) || std::abs(h) <= cancelled * (share.direct + std::abs(part))};
}

Value filter_at(FilterDesign const& filter, double theta) {
  switch (filter.realisation) {
    case Realisation::pass_through: return {};
    case Realisation::delay: return blended(filter.share, delay_at(filter.delay_cycles, theta));
    case Realisation::sections: break;
  }
  Point const at = point_at(theta);
  Value full;
  for (IncrementSection const& section : filter.sections) {
    full = full * section_at(section, filter.blocks_constant, at);
  }
  return blended(filter.share, full);
}

Value chain_at(std::span<FilterDesign const> chain, double theta) {
  Value total;
  for (FilterDesign const& filter : chain) total = total * filter_at(filter, theta);
  return total;
}

ResponsePoint point_of(Value const& total, double theta, CycleTime cycle_time) {
  // dφ/dθ = Im((dH/dθ)/H), du/dθ = -j u
  double const delay = (std::polar(1.0, -theta) * total.dh_du / total.h).real();
  bool const undefined = total.vanishes || total.h == 0.0;
  return {
      .magnitude = std::abs(total.h),
      .phase_rad = std::arg(total.h),
      .group_delay_s = undefined ? std::numeric_limits<double>::quiet_NaN() : delay * cycle_time.seconds()};
}

}  // namespace

std::complex<double> response(FilterDesign const& filter, Hertz frequency, CycleTime cycle_time) {
  return filter_at(filter, angle(frequency, cycle_time)).h;
}

ResponsePoint chain_response(std::span<FilterDesign const> chain, Hertz frequency, CycleTime cycle_time) {
  double const theta = angle(frequency, cycle_time);
  return point_of(chain_at(chain, theta), theta, cycle_time);
}

ResponsePoint parallel_response(std::span<WeightedChain const> chains, Hertz frequency,
                                CycleTime cycle_time) {
  double const theta = angle(frequency, cycle_time);
  Value sum{.h = 0, .dh_du = 0, .vanishes = false};
  double parts = 0;
  for (WeightedChain const& chain : chains) {
    Value const part = chain_at(chain.filters, theta);
    sum.h += chain.weight * part.h;
    sum.dh_du += chain.weight * part.dh_du;
    if (!part.vanishes) parts += std::abs(chain.weight * part.h);
  }
  sum.vanishes = std::abs(sum.h) <= cancelled * parts;
  return point_of(sum, theta, cycle_time);
}

double chain_delay_cycles(std::span<FilterDesign const> chain) {
  double cycles = 0;
  for (FilterDesign const& filter : chain) cycles += filter.group_delay_cycles;
  return cycles;
}

}  // namespace axisc::design
