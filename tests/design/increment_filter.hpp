// The recursion of the increment form as the specification writes it, over any number type.
#pragma once

#include "design/filter_design.hpp"

#include <cstddef>
#include <deque>
#include <vector>

/// A chain of filters, starting from the steady state for 0.
template <typename Number>
class BasicIncrementFilter {
 public:
  explicit BasicIncrementFilter(std::vector<axisc::design::FilterDesign> chain)
      : chain_(std::move(chain)), states_(chain_.size()) {
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      states_[i].sections.resize(chain_[i].sections.size());
      states_[i].line.resize(chain_[i].delay_cycles);
    }
  }

  Number step(Number const& x) {
    Number value = x;
    Number d = x - previous_;
    previous_ = x;
    for (std::size_t i = 0; i < chain_.size(); ++i) step_filter(chain_[i], states_[i], value, d);
    return value;
  }

 private:
  struct SectionState {
    Number r{0}, e{0};
  };
  struct FilterState {
    std::vector<SectionState> sections;
    std::deque<Number> line;
    Number previous{0};
  };

  static void step_filter(axisc::design::FilterDesign const& filter, FilterState& state, Number& x,
                          Number& dx) {
    if (filter.realisation == axisc::design::Realisation::pass_through) return;
    Number const s = filter.share.filtered;
    Number const direct = Number(filter.share.direct) + Number(filter.share.direct_low);
    if (filter.realisation == axisc::design::Realisation::delay) {
      state.line.push_back(x);
      x = direct * x + s * state.line.front();
      state.line.pop_front();
    } else {
      Number sum{0}, d = dx;
      for (std::size_t i = 0; i < filter.sections.size(); ++i) {
        auto const& [p, q, k, b] = filter.sections[i];
        auto& [r, e] = state.sections[i];
        Number const de = p * d + r;
        e = e + de;
        r = de + q * d - k * e - b * de;
        d = filter.blocks_constant ? de : Number(d + de);
        sum = filter.blocks_constant ? e : Number(sum + e);
      }
      x = filter.blocks_constant ? Number(direct * x + s * sum) : Number(x + s * sum);
    }
    dx = x - state.previous;
    state.previous = x;
  }

  std::vector<axisc::design::FilterDesign> chain_;
  std::vector<FilterState> states_;
  Number previous_{0};
};

using IncrementFilter = BasicIncrementFilter<double>;
