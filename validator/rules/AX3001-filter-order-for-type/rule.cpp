#include "validator/engine/rule.hpp"

#include "design/filter_kinds.hpp"
#include "diagnostics/format_number.hpp"
#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/sentences.hpp"
#include "validator/views/fir_view.hpp"

#include <optional>
#include <string>

namespace axisc::validator::checks::ax3001::says {

constexpr Sentence headline{"order {order} is not allowed for `{type}`",
                            "die Ordnung {order} ist für `{type}` nicht zulässig"};
constexpr Sentence range{"allowed are 0 to {limit}", "zulässig sind 0 bis {limit}"};
constexpr Sentence either{"allowed are 0 and {limit}", "zulässig sind 0 und {limit}"};
constexpr Sentence limit{"{p_axis}: 0 ≤ order ≤ {limit} for `{type}`",
                         "{p_axis}: 0 ≤ order ≤ {limit} für `{type}`"};
constexpr Sentence limit_either{"{p_axis}: order = 0 or {limit} for `{type}`",
                                "{p_axis}: order = 0 oder {limit} für `{type}`"};
constexpr Sentence fix{"set the order to {limit}", "die Ordnung auf {limit} setzen"};

}  // namespace axisc::validator::checks::ax3001::says

namespace axisc::validator::checks::ax3001 {
namespace {

// Message numbers of the control.
constexpr std::string_view order_refused = "50553";
constexpr std::string_view order_clipped = "50911";

enum class Range : std::uint8_t { up_to, zero_or };
enum class Reaction : std::uint8_t { refused, clipped };

struct AllowedOrder {
  double highest = 0;
  Range range = Range::up_to;
  Reaction reaction = Reaction::refused;

  [[nodiscard]] bool allows(double order) const {
    return range == Range::up_to ? order <= highest : order == 0 || order == highest;
  }
};

// None if any order is allowed, or if the type is reported anyway.
std::optional<AllowedOrder> allowed_order(FilterView const& filter) {
  bool const interface = filter.port == FilterPort::additional_interface;
  if (!filter.standard_type) {
    bool const kernel = filter.is_hsc() || design::find_hsc_kind(filter.type_number()) != nullptr;
    if (interface || !kernel) return std::nullopt;
    return AllowedOrder{.highest = design::longest_kernel_order, .reaction = Reaction::clipped};
  }
  design::OrderRange const& order = design::kind_of(*filter.standard_type).order;
  if (order.source == design::OrderSource::configured) {
    return AllowedOrder{.highest = static_cast<double>(order.highest)};
  }
  // The additional interface computes the order of PT1 and PT2 itself.
  if (interface || order.source == design::OrderSource::computed) return std::nullopt;
  return AllowedOrder{.highest = static_cast<double>(order.highest), .range = Range::zero_or};
}

Finding* check(EffectiveValue const& order, AllowedOrder const& allowed, std::string const& type,
               Report& report) {
  if (order.unusable || !order.set() || allowed.allows(order.value.number)) return nullptr;
  std::string const limit = format_exact(allowed.highest);
  bool const up_to = allowed.range == Range::up_to;
  Finding& finding =
      report.add(order, {says::headline, {{"order", number(order.value.number)}, {"type", type}}});
  finding.label = Message{up_to ? says::range : says::either, {{"limit", limit}}};
  finding.notes.push_back({up_to ? says::limit : says::limit_either,
                           {{"p_axis", parameter_number(order)}, {"limit", limit}, {"type", type}}});
  if (allowed.reaction == Reaction::clipped) {
    react(finding, order_clipped, {validator::says::filter_reaction_clipped, {}}, limit);
  } else {
    react(finding, order_refused, {validator::says::filter_reaction_refused, {}});
  }
  if (order.value_place() && !order.referenced) {
    finding.fix = Fix{.title = {says::fix, {{"limit", limit}}},
                      .edits = {{*order.value_place(), limit}},
                      .safety = FixSafety::changes_behaviour};
  }
  return &finding;
}

void filter_order_for_type(AxisContext const& axis, Report& report) {
  for (FilterView const& filter : axis.filters) {
    if (filter.type_unusable()) continue;
    auto const allowed = allowed_order(filter);
    if (!allowed) continue;
    Finding* const finding = check(filter.order, *allowed, std::string(filter.type_word()), report);
    if (finding != nullptr) relate_type(*finding, filter);
  }
  FirView const& fir = axis.fir;
  if (fir.type.unusable) return;
  bool const delay = fir.configured_type() == FirType::time_delay;
  check(fir.order, {.highest = static_cast<double>(fir.longest_order()), .reaction = Reaction::clipped},
        delay ? "filter_fir.type 4" : "filter_fir", report);
}

}  // namespace

extern constinit Rule const rule{
    .control = control_numbers<order_refused, order_clipped>,
    .parameters =
        "filters[].order filters[].type filters[].prototype filters[].enable filter_fir.order "
        "filter_fir.type",
    .check = filter_order_for_type,
};

}  // namespace axisc::validator::checks::ax3001
