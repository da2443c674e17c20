#include "runtime/bounds/response.hpp"

#include "runtime/bounds/kept.hpp"
#include "runtime/bounds/outward.hpp"

namespace axisc::runtime::bounds {
namespace {

constexpr uint32_t cycles_between_rests = 64;
/// What is left counts no more below this part of what was found.
constexpr double negligible = 0x1p-44;

/// Excess over the final value, and increment.
template <class Number>
struct Signal {
  Number excess, d;
};

/// Upper bounds of the sums of magnitudes that are still to come.
using Rest = Signal<double>;

template <class Number>
struct SectionState {
  Number e, r;
  Number d, de;  ///< of the cycle before
};

/// What SectionSizes are sizes of, and at least the magnitude of all of a number.
double measured(double x) {
  return x;
}
double measured(Kept x) {
  return x.lost;
}
double whole(double x) {
  return magnitude(x);
}
double whole(Kept x) {
  return magnitude(x.value) + magnitude(x.lost);
}
double rounded(double x) {
  return x;
}
double rounded(Kept x) {
  return x.value + x.lost;
}

class CompensatedSum {
 public:
  void add(double value) {
    Twofold const sum = exact_sum(high_, value);
    high_ = sum.high;
    low_ += sum.low;
  }
  [[nodiscard]] double value() const { return high_ + low_; }

 private:
  double high_ = 0, low_ = 0;
};

template <class Number>
struct FilterState {
  Number share, direct;
  Signal<Number> ring[axim_most_delay];
  uint32_t position;
};

template <class Number>
struct Coefficients {
  Number p, g, k, b;
};

void set_coefficients(SectionBound const& section, Coefficients<double>& to) {
  to = {section.p, section.g, section.k, section.b};
}
void set_coefficients(SectionBound const& section, Coefficients<Kept>& to) {
  to = {{section.p}, {section.g, section.lost_of_g}, {section.k}, {section.b}};
}
double direct_of(FilterPart const& part, double /*share*/) {
  return part.direct;
}
Kept direct_of(FilterPart const& part, Kept share) {
  return {part.direct, (Kept{1} - share).lost};
}

/// `Number` is double, or Kept, whose values are the same.
template <class Number>
class Follower {
 public:
  Follower(Chain const& chain, SectionSizes* sizes) : chain_(chain), sizes_(sizes) {
    Number base{1};
    for (uint32_t i = 0; i < chain.filter_count; ++i) {
      FilterState<Number>& filter = filters_[i];
      filter.share = Number{chain.filters[i].share};
      filter.direct = direct_of(chain.filters[i], filter.share);
      filter.position = 0;
      // Before the step the delayed signal is 0, which is `base` below its final value.
      for (uint32_t k = 0; k < chain.filters[i].delay; ++k) filter.ring[k] = {Number{} - base, Number{}};
      if (chain.filters[i].blocks_constant) base = base * filter.direct;
    }
    for (uint32_t i = 0; i < chain.section_count; ++i) {
      set_coefficients(chain.sections[i], coefficients_[i]);
      states_[i] = {};
      sizes_[i] = {};
    }
  }

  Signal<Number> step(Signal<Number> x) {
    for (uint32_t i = 0; i < chain_.filter_count; ++i) {
      FilterPart const& part = chain_.filters[i];
      FilterState<Number>& filter = filters_[i];
      Signal<Number> const y = part.delay > 0 ? delayed(part, filter, x) : filtered(part, x);
      x = {filter.share * y.excess + filter.direct * x.excess, filter.share * y.d + filter.direct * x.d};
    }
    return x;
  }

  /// After the chain, where `x` is left before it.
  [[nodiscard]] Rest rest(Rest x) const {
    for (uint32_t i = 0; i < chain_.filter_count; ++i) {
      FilterPart const& part = chain_.filters[i];
      Rest const y = part.delay > 0 ? rest_of_delay(part, filters_[i], x) : rest_of_sections(part, x);
      x = {part.share * y.excess + part.direct * x.excess, part.share * y.d + part.direct * x.d};
    }
    return x;
  }

  /// Adds to the sizes what is left.
  void finish(Rest x) const {
    for (uint32_t i = 0; i < chain_.filter_count; ++i) {
      FilterPart const& part = chain_.filters[i];
      Rest before = x;
      for (uint32_t k = part.first; k < part.first + part.count; ++k) {
        add_rest(k, before.d);
        before.d = rest_behind(k, before.d);
      }
      Rest const y = part.delay > 0 ? rest_of_delay(part, filters_[i], x) : rest_of_sections(part, x);
      x = {part.share * y.excess + part.direct * x.excess, part.share * y.d + part.direct * x.d};
    }
  }

 private:
  ///     de = p d + r,   e += de,   r += g d - k e - b de
  Number run_section(uint32_t i, Number d) {
    auto const& [p, g, k, b] = coefficients_[i];
    SectionState<Number>& state = states_[i];
    Number const de = p * d + state.r;
    Number const e = state.e + de;
    Number const r = state.r + (g * d - k * e - b * de);
    SectionSizes& size = sizes_[i];
    add_size(size.d, measured(d), measured(state.d));
    add_size(size.de, measured(de), measured(state.de));
    size.e.increment += magnitude(measured(e));
    add_size(size.r, measured(r), measured(state.r));
    state = {e, r, d, de};
    return de;
  }

  static void add_size(Size& size, double value, double last) {
    size.increment += magnitude(value);
    size.position += magnitude(value - last);
  }

  Signal<Number> filtered(FilterPart const& part, Signal<Number> x) {
    Number d = x.d;
    if (part.blocks_constant) {
      for (uint32_t k = part.first; k < part.first + part.count; ++k) d = run_section(k, d);
      return {states_[part.first + part.count - 1].e, d};
    }
    Number sum = x.excess;
    for (uint32_t k = part.first; k < part.first + part.count; ++k) {
      d = d + run_section(k, d);
      sum = sum + states_[k].e;
    }
    return {sum, d};
  }

  static Signal<Number> delayed(FilterPart const& part, FilterState<Number>& state, Signal<Number> x) {
    Signal<Number> const y = state.ring[state.position];
    state.ring[state.position] = x;
    state.position = state.position + 1 == part.delay ? 0 : state.position + 1;
    return y;
  }

  [[nodiscard]] double rest_behind(uint32_t k, double d) const {
    SectionBound const& section = chain_.sections[k];
    SectionState<Number> const& state = states_[k];
    return section.re * whole(state.e) + section.rr * whole(state.r) + section.passed * d;
  }
  [[nodiscard]] double rest_of_e(uint32_t k, double d) const {
    SectionBound const& section = chain_.sections[k];
    SectionState<Number> const& state = states_[k];
    return section.ee * whole(state.e) + section.er * whole(state.r) + section.excess * d;
  }

  [[nodiscard]] Rest rest_of_sections(FilterPart const& part, Rest x) const {
    Rest y{.excess = part.blocks_constant ? 0 : x.excess, .d = x.d};
    for (uint32_t k = part.first; k < part.first + part.count; ++k) {
      double const e = rest_of_e(k, y.d);
      y.excess = part.blocks_constant ? e : y.excess + e;
      y.d = rest_behind(k, y.d);
    }
    return y;
  }

  static Rest rest_of_delay(FilterPart const& part, FilterState<Number> const& state, Rest x) {
    for (uint32_t k = 0; k < part.delay; ++k) {
      x.excess += whole(state.ring[k].excess);
      x.d += whole(state.ring[k].d);
    }
    return x;
  }

  /// A change is at most the sum of the two values.
  static void add(Size& size, Number last, double rest) {
    size.increment += rest;
    size.position += 2 * rest + whole(last);
  }

  void add_rest(uint32_t k, double d) const {
    SectionBound const& section = chain_.sections[k];
    SectionState<Number> const& state = states_[k];
    SectionSizes& size = sizes_[k];
    double const of_r = section.re * whole(state.e) + section.rr * whole(state.r);
    size.e.increment += rest_of_e(k, d);
    add(size.d, state.d, d);
    add(size.de, state.de, of_r + (magnitude(section.p) + section.following) * d);
    add(size.r, state.r, of_r + section.following * d);
    size.e.position = size.de.increment;
  }

  Chain const& chain_;
  SectionSizes* sizes_;
  FilterState<Number> filters_[most_filters];
  Coefficients<Number> coefficients_[most_sections];
  SectionState<Number> states_[most_sections];
};

struct Sums {
  CompensatedSum gain{}, distance{};
  double change = 0, last = 0;
  double highest;

  template <class Number>
  void add(Signal<Number> y) {
    double const d = rounded(y.d);
    double const excess = rounded(y.excess);
    gain.add(magnitude(d));
    distance.add(magnitude(excess));
    change += magnitude(d - last);
    last = d;
    highest = larger(highest, excess);
  }
};

/// A unit step behind the kernel.
template <class Number>
Signal<Number> input(KernelPart const& kernel, uint32_t n) {
  Number const tail{kernel.tail(n)};
  Number const before{n == 0 ? 1 : kernel.tail(n - 1)};
  return {Number{} - tail, before - tail};
}

void set_sums(Sums const& sums, Rest rest, Response& response) {
  response.gain = sums.gain.value();
  response.gain_rest = rest.d * second_order;
  response.distance = sums.distance.value();
  response.distance_rest = rest.excess * second_order;
  response.highest = sums.highest;
  response.output = {.increment = response.gain + rest.d,
                     .position = sums.change + 2 * rest.d + magnitude(sums.last)};
}

}  // namespace

void follow_response(Chain const& chain, KernelPart const& kernel, Response& response) {
  Follower<double> follower(chain, response.sections);
  Sums sums{.highest = -chain.final_value};
  Rest rest{};
  Rest const none{};
  bool ended = false;
  uint32_t n = 0;
  while (!ended && n < longest_response) {
    for (uint32_t const end = n + cycles_between_rests; n < end; ++n) {
      sums.add(follower.step(input<double>(kernel, n)));
    }
    if (n <= kernel.count) continue;
    rest = follower.rest(none);
    ended = rest.d <= negligible * sums.gain.value() && rest.excess <= negligible * sums.distance.value();
  }
  follower.finish(none);
  response.cycles = n;
  response.ended = ended;
  set_sums(sums, rest, response);
}

void repeat_response(Chain const& chain, KernelPart const& kernel, uint32_t cycles, Response& response) {
  Follower<Kept> follower(chain, response.sections);
  Sums sums{.highest = -chain.final_value};
  for (uint32_t n = 0; n < cycles; ++n) sums.add(follower.step(input<Kept>(kernel, n)));
  response.cycles = cycles;
  response.ended = true;
  set_sums(sums, follower.rest(Rest{}), response);
}

}  // namespace axisc::runtime::bounds
