#include "runtime/bounds/response.hpp"

#include "runtime/bounds/outward.hpp"
#include "runtime/twofold.hpp"

namespace axisc::runtime::bounds {
namespace {

constexpr uint32_t cycles_between_rests = 64;
/// What is left counts no more below this part of what was found.
constexpr double negligible = 0x1p-44;

/// Excess over the final value, and increment.
struct Signal {
  double excess, d;
};

/// Upper bounds of the sums of magnitudes that are still to come.
struct Rest {
  double excess, d;
};

struct SectionState {
  double e, r;
  double d, de;  ///< of the cycle before
};

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

/// Where a filter begins, the step has the height `base`.
struct FilterState {
  double base;
  Signal ring[axim_most_delay];
  uint32_t position;
};

class Follower {
 public:
  Follower(Chain const& chain, SectionSizes* sizes) : chain_(chain), sizes_(sizes) {
    double base = 1;
    for (uint32_t i = 0; i < chain.filter_count; ++i) {
      filters_[i].base = base;
      filters_[i].position = 0;
      // Before the step the delayed signal is 0, which is `base` below its final value.
      for (uint32_t k = 0; k < chain.filters[i].delay; ++k) filters_[i].ring[k] = {-base, 0};
      if (chain.filters[i].blocks_constant) base *= chain.filters[i].direct;
    }
    for (uint32_t i = 0; i < chain.section_count; ++i) {
      states_[i] = {};
      sizes_[i] = {};
    }
  }

  Signal step(Signal x) {
    for (uint32_t i = 0; i < chain_.filter_count; ++i) {
      FilterPart const& part = chain_.filters[i];
      Signal const y = part.delay > 0 ? delayed(part, filters_[i], x) : filtered(part, x);
      x = {part.share * y.excess + part.direct * x.excess, part.share * y.d + part.direct * x.d};
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
  double run_section(uint32_t i, double d) {
    SectionBound const& section = chain_.sections[i];
    SectionState& state = states_[i];
    double const de = section.p * d + state.r;
    double const e = state.e + de;
    double const r = state.r + (section.g * d - section.k * e - section.b * de);
    SectionSizes& size = sizes_[i];
    size.d.increment += magnitude(d);
    size.d.position += magnitude(d - state.d);
    size.de.increment += magnitude(de);
    size.de.position += magnitude(de - state.de);
    size.e.increment += magnitude(e);
    size.r.increment += magnitude(r);
    size.r.position += magnitude(r - state.r);
    state = {e, r, d, de};
    return de;
  }

  Signal filtered(FilterPart const& part, Signal x) {
    double d = x.d;
    if (part.blocks_constant) {
      for (uint32_t k = part.first; k < part.first + part.count; ++k) d = run_section(k, d);
      return {states_[part.first + part.count - 1].e, d};
    }
    double sum = x.excess;
    for (uint32_t k = part.first; k < part.first + part.count; ++k) {
      d += run_section(k, d);
      sum += states_[k].e;
    }
    return {sum, d};
  }

  static Signal delayed(FilterPart const& part, FilterState& state, Signal x) {
    Signal const y = state.ring[state.position];
    state.ring[state.position] = x;
    state.position = state.position + 1 == part.delay ? 0 : state.position + 1;
    return y;
  }

  [[nodiscard]] double rest_behind(uint32_t k, double d) const {
    SectionBound const& section = chain_.sections[k];
    SectionState const& state = states_[k];
    return section.re * magnitude(state.e) + section.rr * magnitude(state.r) + section.passed * d;
  }
  [[nodiscard]] double rest_of_e(uint32_t k, double d) const {
    SectionBound const& section = chain_.sections[k];
    SectionState const& state = states_[k];
    return section.ee * magnitude(state.e) + section.er * magnitude(state.r) + section.excess * d;
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

  static Rest rest_of_delay(FilterPart const& part, FilterState const& state, Rest x) {
    for (uint32_t k = 0; k < part.delay; ++k) {
      x.excess += magnitude(state.ring[k].excess);
      x.d += magnitude(state.ring[k].d);
    }
    return x;
  }

  /// A change is at most the sum of the two values.
  static void add(Size& size, double last, double rest) {
    size.increment += rest;
    size.position += 2 * rest + magnitude(last);
  }

  void add_rest(uint32_t k, double d) const {
    SectionBound const& section = chain_.sections[k];
    SectionState const& state = states_[k];
    SectionSizes& size = sizes_[k];
    double const of_r = section.re * magnitude(state.e) + section.rr * magnitude(state.r);
    size.e.increment += rest_of_e(k, d);
    add(size.d, state.d, d);
    add(size.de, state.de, of_r + (magnitude(section.p) + section.following) * d);
    add(size.r, state.r, of_r + section.following * d);
    size.e.position = size.de.increment;
  }

  Chain const& chain_;
  SectionSizes* sizes_;
  FilterState filters_[most_filters];
  SectionState states_[most_sections];
};

}  // namespace

void follow_response(Chain const& chain, KernelPart const& kernel, Response& response) {
  Follower follower(chain, response.sections);
  CompensatedSum gain;
  CompensatedSum distance;
  double change = 0;
  double before = 0;
  double highest = -chain.final_value;
  Rest rest{};
  Rest const none{};
  bool ended = false;
  uint32_t n = 0;
  while (!ended && n < longest_response) {
    for (uint32_t const end = n + cycles_between_rests; n < end; ++n) {
      Signal const y = follower.step({.excess = -kernel.tail(n), .d = n <= kernel.count ? kernel.tap(n) : 0});
      gain.add(magnitude(y.d));
      distance.add(magnitude(y.excess));
      change += magnitude(y.d - before);
      before = y.d;
      highest = larger(highest, y.excess);
    }
    if (n <= kernel.count) continue;
    rest = follower.rest(none);
    ended = rest.d <= negligible * gain.value() && rest.excess <= negligible * distance.value();
  }
  follower.finish(none);
  response.cycles = n;
  response.ended = ended;
  response.gain = gain.value();
  response.gain_rest = rest.d * second_order;
  response.distance = distance.value();
  response.distance_rest = rest.excess * second_order;
  response.highest = highest;
  response.output = {.increment = gain.value() + rest.d, .position = change + 2 * rest.d + magnitude(before)};
}

}  // namespace axisc::runtime::bounds
