#include "runtime/exact_filter.hpp"

#include <utility>

namespace axisc::test {
namespace {

/// (n2 s^2 + n1 s + n0) / (s^2 + A s + B), s normalised to the pre-warped frequency.
struct AnalogueSection {
  Quad n2 = 0, n1 = 0, n0 = 0, A = 0, B = 1;
};

/// s = (1 - z^-1) / (t (1 + z^-1)), t = tan(pi f T)
DirectSection bilinear(AnalogueSection const& h, Quad t) {
  Quad const scale = 1 + h.A * t + h.B * t * t;
  return {.b0 = (h.n2 + h.n1 * t + h.n0 * t * t) / scale,
          .b1 = 2 * (h.n0 * t * t - h.n2) / scale,
          .b2 = (h.n2 - h.n1 * t + h.n0 * t * t) / scale,
          .a1 = 2 * (h.B * t * t - 1) / scale,
          .a2 = (1 - h.A * t + h.B * t * t) / scale};
}

/// (n1 s + n0) / (s + 1)
DirectSection first_order_bilinear(Quad n1, Quad n0, Quad t) {
  Quad const scale = 1 + t;
  return {.b0 = (n1 + n0 * t) / scale, .b1 = (n0 * t - n1) / scale, .b2 = 0, .a1 = (t - 1) / scale, .a2 = 0};
}

ExactFilter one_section(DirectSection const& section, bool blocks_constant) {
  ExactFilter filter;
  filter.sections = {section};
  filter.blocks_constant = blocks_constant;
  return filter;
}

Quad warped(Quad f, Quad T) {
  return tangent(quad_pi * f * T);
}

}  // namespace

FilterRecord ExactFilter::record() const {
  FilterRecord filter;
  filter.realisation = is_delay ? 2 : 1;
  filter.blocks_constant = blocks_constant ? 1 : 0;
  filter.delay_cycles = delay_cycles;
  for (DirectSection const& section : sections) {
    Quad const p = blocks_constant ? section.b0 : section.b0 - 1;
    Quad const q = blocks_constant ? section.b0 + section.b1 : p + section.b1 - section.a1;
    filter.sections.push_back({.p = static_cast<double>(p),
                               .q = static_cast<double>(q),
                               .k = static_cast<double>(1 + section.a1 + section.a2),
                               .b = static_cast<double>(1 - section.a2)});
  }
  set_share(filter, share);
  return filter;
}

namespace exact {

ExactFilter lowpass(Quad f, Quad T, Quad quality) {
  return one_section(bilinear({.n0 = 1, .A = 1 / quality}, warped(f, T)), false);
}
ExactFilter highpass(Quad f, Quad T, Quad quality) {
  return one_section(bilinear({.n2 = 1, .A = 1 / quality}, warped(f, T)), true);
}
ExactFilter bandpass(Quad f, Quad T, Quad quality) {
  return one_section(bilinear({.n1 = 1 / quality, .A = 1 / quality}, warped(f, T)), true);
}
ExactFilter bandstop(Quad f, Quad T, Quad quality) {
  return one_section(bilinear({.n2 = 1, .n0 = 1, .A = 1 / quality}, warped(f, T)), false);
}
ExactFilter allpass(Quad f, Quad T, Quad quality) {
  return one_section(bilinear({.n2 = 1, .n1 = -1 / quality, .n0 = 1, .A = 1 / quality}, warped(f, T)), false);
}
ExactFilter pt1(Quad f, Quad T) {
  return one_section(first_order_bilinear(0, 1, warped(f, T)), false);
}
ExactFilter pt2(Quad f, Quad T) {
  return one_section(bilinear({.n0 = 1, .A = 2}, warped(f, T)), false);
}
ExactFilter first_order_highpass(Quad f, Quad T) {
  return one_section(first_order_bilinear(1, 0, warped(f, T)), true);
}
ExactFilter first_order_allpass(Quad f, Quad T) {
  return one_section(first_order_bilinear(-1, 1, warped(f, T)), false);
}

// s -> 1 / (Qa (s + 1/s)) turns a pole p of the prototype into the two roots of s^2 - s/(Qa p) + 1.
ExactFilter bandstop_of_order_3(Quad f, Quad T, Quad quality) {
  Quad const t = warped(f, T);
  Quad const Qa = sine(2 * quad_pi * f * T) / (2 * warped(f / quality, T));
  ExactFilter filter = one_section(bilinear({.n2 = 1, .n0 = 1, .A = 1 / Qa}, t), false);
  QuadComplex const p{-cosine(quad_pi / 3), sine(quad_pi / 3)};
  QuadComplex const c = inverse({2 * Qa * p.re, 2 * Qa * p.im});
  QuadComplex const squared = c * c;
  QuadComplex const root = square_root(QuadComplex{squared.re - 1, squared.im});
  for (Quad const sign : {Quad{1}, Quad{-1}}) {
    QuadComplex const pole{c.re + sign * root.re, c.im + sign * root.im};
    Quad const B = squared_magnitude(pole);
    filter.sections.push_back(bilinear({.n2 = B, .n0 = B, .A = -2 * pole.re, .B = B}, t));
  }
  return filter;
}

ExactFilter thiran(int order, Quad D) {
  if (order == 1) {
    Quad const a1 = (1 - D) / (1 + D);
    return one_section({.b0 = a1, .b1 = 1, .b2 = 0, .a1 = a1, .a2 = 0}, false);
  }
  Quad const a1 = -2 * (D - 2) / (D + 1);
  Quad const a2 = (D - 2) * (D - 1) / ((D + 1) * (D + 2));
  return one_section({.b0 = a2, .b1 = a1, .b2 = 1, .a1 = a1, .a2 = a2}, false);
}

ExactFilter delay(std::uint32_t cycles) {
  ExactFilter filter;
  filter.is_delay = true;
  filter.delay_cycles = cycles;
  return filter;
}

ExactFilter joined(ExactFilter first, ExactFilter const& second) {
  first.sections.insert(first.sections.end(), second.sections.begin(), second.sections.end());
  return first;
}

ExactFilter with_share(ExactFilter filter, double share) {
  filter.share = share;
  return filter;
}

}  // namespace exact

ExactFilter stored_filter(FilterRecord const& record) {
  ExactFilter filter{.sections = {},
                     .delay_cycles = record.delay_cycles,
                     .is_delay = record.realisation == 2,
                     .share = record.share};
  for (SectionRecord const& section : record.sections) {
    Quad const p = section.p, q = section.q, k = section.k, b = section.b;
    Quad const a1 = k + b - 2, a2 = 1 - b;
    filter.sections.push_back({.b0 = 1 + p, .b1 = q - p + a1, .b2 = a2 - q, .a1 = a1, .a2 = a2});
  }
  return filter;
}

ExactChain::ExactChain(std::vector<ExactFilter> filters, Quad position) : filters_(std::move(filters)) {
  Quad signal = position;
  for (ExactFilter const& filter : filters_) {
    FilterState state;
    Quad passed = signal;
    for (std::size_t i = 0; i < filter.sections.size(); ++i) {
      Quad const out = filter.blocks_constant ? Quad{0} : passed;
      state.sections.push_back({.x1 = passed, .x2 = passed, .y1 = out, .y2 = out});
      passed = out;
    }
    state.delayed.assign(filter.delay_cycles, signal);
    states_.push_back(state);
    Quad const share = filter.share;
    signal = share * passed + (1 - share) * signal;
  }
}

Quad ExactChain::step(Quad x) {
  for (std::size_t i = 0; i < filters_.size(); ++i) {
    ExactFilter const& filter = filters_[i];
    FilterState& state = states_[i];
    Quad y = x;
    for (std::size_t n = 0; n < filter.sections.size(); ++n) {
      DirectSection const& c = filter.sections[n];
      SectionState& s = state.sections[n];
      Quad const out = c.b0 * y + c.b1 * s.x1 + c.b2 * s.x2 - c.a1 * s.y1 - c.a2 * s.y2;
      s = {.x1 = y, .x2 = s.x1, .y1 = out, .y2 = s.y1};
      y = out;
    }
    if (filter.is_delay && filter.delay_cycles > 0) {
      state.delayed.push_back(x);
      y = state.delayed.front();
      state.delayed.pop_front();
    }
    Quad const share = filter.share;
    x = share * y + (1 - share) * x;
  }
  return x;
}

}  // namespace axisc::test
