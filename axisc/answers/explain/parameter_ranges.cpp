#include "axisc/answers/explain/parameter_ranges.hpp"

#include "design/filter_kinds.hpp"
#include "design/kernels/kernel_kinds.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::says {

constexpr Sentence between{"{lowest} {from} value {to} {highest}", "{lowest} {from} Wert {to} {highest}"};
constexpr Sentence above{"{lowest} {from} value", "{lowest} {from} Wert"};
constexpr Sentence below{"value {to} {highest}", "Wert {to} {highest}"};
constexpr Sentence nyquist{"0.5/T (500 Hz at T = 1 ms)", "0,5/T (500 Hz bei T = 1 ms)"};
constexpr Sentence used{"used", "wird verwendet"};
constexpr Sentence order_of_type{"the type gives the order; 0 switches the filter off",
                                 "der Typ gibt die Ordnung vor; 0 schaltet den Filter ab"};
constexpr Sentence hsc_order{"{range} cycles; with 0 `time_constant` counts",
                             "{range} Zyklen; bei 0 zählt `time_constant`"};
constexpr Sentence hsc_time{"{range}, with order 0", "{range}, bei Ordnung 0"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

Words range_words(Value lowest, bool excludes_lowest, Value highest, bool excludes_highest) {
  auto const sign = [](bool excludes) { return Wording(excludes ? "<" : "≤"); };
  bool const has_lowest = !lowest.is_nothing();
  bool const has_highest = !highest.is_nothing();
  return {!has_highest ? says::above
          : has_lowest ? says::between
                       : says::below,
          {{"lowest", std::move(lowest)},
           {"from", sign(excludes_lowest)},
           {"to", sign(excludes_highest)},
           {"highest", std::move(highest)}}};
}

namespace {

/// "6 T".
Words cycles(double count) {
  if (count == 0) return as_given("0");
  return as_given(count == 1 ? Wording("T") : exact_number(count) + " T");
}

Words frequency_range() {
  return range_words(0, true, Words(says::nyquist), true);
}

/// What a filter of the type allows; none where it does not use the parameter.
std::optional<Words> range_of(design::FilterKind const& kind, std::string_view name) {
  if (name == "fg_f0" && kind.uses_frequency) return frequency_range();
  if (name == "prototype" && kind.uses_prototype) return Words(says::used);
  if (name == "guete" && kind.quality) {
    return range_words(exact(kind.quality->lowest), false, exact(kind.quality->highest), false);
  }
  if (name == "order") {
    if (kind.order.source != design::OrderSource::configured) return Words(says::order_of_type);
    return range_words(1, false, kind.order.highest, false);
  }
  if (name == "time_constant" && kind.time_constant) {
    auto const& [meaning, lowest, limit] = *kind.time_constant;
    return range_words(cycles(lowest), false, std::isinf(limit) ? Value() : cycles(limit), true);
  }
  return std::nullopt;
}

void add(std::vector<TypeRange>& ranges, std::string type, Words range) {
  auto const text = text_of(range, Language::english);
  auto const known = std::find_if(ranges.begin(), ranges.end(), [&](TypeRange const& row) {
    return text_of(row.range, Language::english) == text;
  });
  if (known == ranges.end()) {
    ranges.push_back({.types = {std::move(type)}, .range = std::move(range)});
  } else {
    known->types.push_back(std::move(type));
  }
}

void add_hsc(std::vector<TypeRange>& ranges, std::string_view name) {
  constexpr auto longest = design::longest_kernel_order;
  if (name == "filter[].order") {
    add(ranges, "HSC", {says::hsc_order, {{"range", range_words(0, false, longest, false)}}});
  } else if (name == "filter[].time_constant") {
    add(ranges, "HSC", {says::hsc_time, {{"range", range_words(cycles(1), true, cycles(longest), true)}}});
  } else if (name == "filter[].fg_f0") {
    add(ranges, "HSC NoVib", frequency_range());
  }
}

/// Of filter_fir, whose types are numbers.
void add_kernels(std::vector<TypeRange>& ranges, std::string_view name) {
  for (auto const& kind : design::kernel_kinds) {
    bool const is_fir =
        kind.type != design::KernelType::novib && kind.type != design::KernelType::vibration_guard;
    if (!is_fir) continue;
    auto const type = std::to_string(static_cast<int>(kind.type) + 1);
    if (name == "filter_fir.order") add(ranges, type, range_words(0, false, kind.longest_order, false));
    if (name == "filter_fir.order_time") {
      add(ranges, type, range_words(cycles(1), false, cycles(kind.longest_order), false));
    }
    if (name == "filter_fir.fcut" && kind.uses_frequency) add(ranges, type, frequency_range());
  }
}

}  // namespace

std::vector<TypeRange> ranges_by_type(schema::Parameter const& parameter) {
  std::vector<TypeRange> ranges;
  auto const& name = parameter.name;
  if (parameter.kind != schema::ListKind::axis) return ranges;
  for (std::string_view const port : {"filter[].", "lr_param.add_interface.filter[]."}) {
    if (!name.starts_with(port)) continue;
    for (auto const& kind : design::filter_kinds) {
      if (auto range = range_of(kind, name.substr(port.size()))) add(ranges, std::string(kind.word), *range);
    }
  }
  add_hsc(ranges, name);
  add_kernels(ranges, name);
  constexpr std::string_view stage = "lr_param.improved_position_control.stage[].filter";
  if (name.starts_with(stage) && name.ends_with(".fg_f0")) ranges.push_back({{}, frequency_range()});
  return ranges;
}

}  // namespace axisc
