#include "axisc/answers/inspect/filters_answer.hpp"

#include "axisc/answers/figures/filter_words.hpp"
#include "axisc/answers/inspect/inspect_parts.hpp"
#include "axisc/answers/labels.hpp"
#include "image/chain_figures.hpp"

#include <numeric>
#include <vector>

namespace axisc::says {

constexpr Sentence filters_of{"filters of {machine}", "Filter von {machine}"};
constexpr Sentence filters_in_order{"filters, in the order in which they act",
                                    "Filter in der Reihenfolge ihrer Wirkung"};
constexpr Sentence without_filter{"none", "keine"};
constexpr Sentence minus_3_db{"−3 dB", "−3 dB"};
constexpr Sentence settled_after{"settled to 0.01 % after", "auf 0,01 % eingeschwungen nach"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

Document filters_answer(std::string const& name, ImageFile const& image) {
  auto const& contents = image.contents;
  std::vector<std::size_t> all(contents.axes.size());
  std::iota(all.begin(), all.end(), 0U);
  auto const figures = image::chain_figures(image.bytes.bytes(), contents, all);
  double const cycle_ms = contents.cycle_time.seconds() * 1e3;
  constexpr int digits = 4;
  auto const figure = [](double value, Unit unit) { return Value(rounded(value, unit, digits)); };
  Table axes{.key = "axes"};
  for (auto const axis : all) {
    auto const& chain = figures[axis];
    auto const corner = image::corner_frequency(contents, axis);
    auto const& cycles = chain.settling_cycles;
    auto const words = filter_words(contents, axis);
    add_row(
        axes,
        {{"axis", labels::axis, axis_label(contents, axis)},
         {"filters", says::filters_in_order, words ? Value(*words) : Nothing{Words(says::without_filter)}},
         {"delay_ms", labels::delay, figure(chain.delay_cycles * cycle_ms, Unit::millisecond)},
         {"corner_frequency_hz", says::minus_3_db, corner ? figure(corner->value, Unit::hertz) : Value()},
         {"overshoot_percent", labels::overshoot, figure(chain.overshoot * 100, Unit::percent)},
         {"settling_ms", says::settled_after,
          cycles ? figure(static_cast<double>(*cycles) * cycle_ms, Unit::millisecond) : Value()}});
  }
  return {.version = 1,
          .title = Words(says::filters_of, {{"machine", name}}),
          .blocks = {std::move(axes)},
          .csv_table = "axes"};
}

}  // namespace axisc
