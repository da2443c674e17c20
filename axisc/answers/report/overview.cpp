#include "axisc/answers/report/overview.hpp"

#include "analysis/motion/point.hpp"
#include "axisc/answers/contour/contour_answer.hpp"
#include "axisc/answers/figures/axis_delays.hpp"
#include "axisc/answers/figures/filter_words.hpp"
#include "axisc/answers/labels.hpp"
#include "image/chain_difference.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::says {

constexpr Sentence overview_filters{"filters", "Filter"};
constexpr Sentence overview_no_filter{"none", "keine"};
constexpr Sentence overview_start{"from start-up", "ab Hochlauf"};
constexpr Sentence overview_corner{"corner of {angle}", "Ecke von {angle}"};
constexpr Sentence overview_passed{"as passed", "wie gefahren"};
constexpr Sentence overview_circle{"circle, r {radius}", "Kreis, r {radius}"};
constexpr Sentence overview_margin{"margin to {tolerance}", "Reserve bis {tolerance}"};
constexpr Sentence channels_off{"At {feed} the contour of each channel is off by:",
                                "Bei {feed} weicht die Bahn jedes Kanals ab um:"};
constexpr Sentence kept_at_corner{"tolerance kept at the corner up to",
                                  "Toleranz an der Ecke eingehalten bis"};
constexpr Sentence kept_on_circle{"on the circle up to", "auf dem Kreis bis"};
constexpr Sentence overview_findings{"findings", "Befunde"};
constexpr Sentence overview_others{"several axes, machine", "mehrere Achsen, Maschine"};
constexpr Sentence no_delay{"Nothing delays a setpoint.", "Nichts verzögert einen Sollwert."};
constexpr Sentence same_delay{"With all filters on, every setpoint arrives {delay} late.",
                              "Mit allen Filtern kommt jeder Sollwert {delay} später an."};
constexpr Sentence delays_between{
    "With all filters on, setpoints arrive late: by {low} ({fast}) to {high} ({slow}).",
    "Mit allen Filtern kommen Sollwerte später an: um {low} ({fast}) bis {high} ({slow})."};
constexpr Sentence blocks_position{
    "{axes}: a filter does not let a constant position pass, so that no delay can be given.",
    "{axes}: ein Filter lässt eine konstante Position nicht durch, daher gibt es keine Verzögerung."};
constexpr Sentence contour_costs{
    "{channel}: at {feed} the contour is off by {corner} at a corner of {angle}, by {passed} as the control "
    "passes it (a reading), and by {circle} on a circle of radius {radius}.",
    "{channel}: bei {feed} weicht die Bahn an einer Ecke von {angle} um {corner} ab, so wie die Steuerung "
    "sie fährt (eine Lesart) um {passed}, und auf einem Kreis mit Radius {radius} um {circle}."};
constexpr Sentence contour_costs_alone{
    "{channel}: at {feed} the contour is off by {corner} at a corner of {angle} and by {circle} on a circle "
    "of radius {radius}.",
    "{channel}: bei {feed} weicht die Bahn an einer Ecke von {angle} um {corner} ab und auf einem Kreis mit "
    "Radius {radius} um {circle}."};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

Words corner_label(ReportSubject const& subject) {
  return {says::overview_corner, {{"angle", exact(subject.contour.angle_deg, Unit::degree)}}};
}

Words circle_label(ReportSubject const& subject) {
  return {says::overview_circle, {{"radius", exact(subject.contour.radius_mm, Unit::millimetre)}}};
}

/// Of the position.
std::vector<AxisDelay> position_delays(PlotSubject const& subject) {
  std::vector<AxisDelay> delays;
  for (auto const axis : subject.axes) {
    PlotSubject one = subject;
    one.axes = {axis};
    one.before.reset();
    delays.push_back(*delays_of(one).front().is);
  }
  return delays;
}

/// That of a filter without a constant part is not a number.
bool is_same(double one, double other) {
  return one == other || (std::isnan(one) && std::isnan(other));
}

bool delay_alike(AxisDelay const& one, AxisDelay const& other) {
  bool const starts_alike = one.at_start.has_value() == other.at_start.has_value() &&
                            is_same(one.at_start.value_or(0), other.at_start.value_or(0));
  return starts_alike && std::equal(one.shares.begin(), one.shares.end(), other.shares.begin(),
                                    other.shares.end(), [](DelayShare const& left, DelayShare const& right) {
                                      return left.name == right.name &&
                                             is_same(left.milliseconds, right.milliseconds);
                                    });
}

bool alike(PlotSubject const& subject, std::size_t a, std::size_t b) {
  auto const& contents = subject.contents();
  if (contents.axes[a].type != contents.axes[b].type) return false;
  if (!image::filter_alike(contents, a, contents, b)) return false;
  auto const old_a = subject.axis_before(a);
  auto const old_b = subject.axis_before(b);
  if (!old_a || !old_b) return !old_a && !old_b;
  auto const& old = subject.before->contents();
  return image::filter_alike(old, *old_a, old, *old_b);
}

double micrometres(double units) {
  return units / motion::units_per_um;
}

void raise(std::optional<double>& largest, double value) {
  largest = std::max(largest.value_or(0), value);
}

Value micrometre_cell(std::optional<double> value) {
  return value ? Value(fixed(*value, Unit::micrometre, 1)) : Value();
}

std::size_t findings_of(ReportSubject const& subject, EqualAxes const& axes) {
  return static_cast<std::size_t>(
      std::count_if(subject.findings.begin(), subject.findings.end(), [&](ReportedFinding const& finding) {
        return std::any_of(axes.axes.begin(), axes.axes.end(), [&](std::size_t axis) {
          return !finding.axis.empty() && finding.axis == axis_label(subject.plots->contents(), axis);
        });
      }));
}

/// The contour's case at the highest feed.
ContourCase const& fastest(GroupContour const& contour) {
  return *std::max_element(contour.cases.begin(), contour.cases.end(),
                           [](ContourCase const& one, ContourCase const& other) {
                             return one.feed_mm_per_min < other.feed_mm_per_min;
                           });
}

ReportBlocks delay_sentences(ReportSubject const& subject) {
  struct Late {
    double delay;
    std::string names;
  };
  std::vector<Late> all;
  ReportBlocks blocks;
  for (auto const& axes : equal_axes(*subject.plots)) {
    double const delay = cost_of(subject, axes).delay_ms;
    if (std::isfinite(delay)) {
      all.push_back({.delay = delay, .names = axes.names});
    } else {
      blocks.emplace_back(Paragraph{Words(says::blocks_position, {{"axes", axes.names}})});
    }
  }
  if (all.empty()) return blocks;
  auto const [low, high] = std::minmax_element(
      all.begin(), all.end(), [](Late const& one, Late const& other) { return one.delay < other.delay; });
  auto const delay = [](Late const& late) { return rounded(late.delay, Unit::millisecond, 4); };
  Words const sentence =
      high->delay == 0 ? Words(says::no_delay)
      : low->delay == high->delay
          ? Words(says::same_delay, {{"delay", delay(*high)}})
          : Words(
                says::delays_between,
                {{"low", delay(*low)}, {"fast", low->names}, {"high", delay(*high)}, {"slow", high->names}});
  blocks.emplace(blocks.begin(), Paragraph{sentence});
  return blocks;
}

Words contour_sentence(ReportSubject const& subject, GroupContour const& contour) {
  auto const& one = fastest(contour);
  auto const um = [](double units) { return fixed(micrometres(units), Unit::micrometre, 1); };
  bool const is_passed = one.passed_corner.has_value();
  Value const channel = contour.name.empty() ? Value(Names(contour.axes))
                                             : Words(labels::one_channel, {{"name", contour.name}});
  return {is_passed ? says::contour_costs : says::contour_costs_alone,
          {{"feed", exact(one.feed_mm_per_min, Unit::millimetre_per_minute)},
           {"channel", channel},
           {"angle", exact(subject.contour.angle_deg, Unit::degree)},
           {"radius", exact(subject.contour.radius_mm, Unit::millimetre)},
           {"corner", um(one.corner.deviation)},
           {"passed", um(is_passed ? one.passed_corner->deviation : 0)},
           {"circle", um(one.circle.deviation)}}};
}

/// The contours of several channels.
Table channels_table(ReportSubject const& subject) {
  auto const um = [](double units) { return fixed(micrometres(units), Unit::micrometre, 1); };
  auto const feed = [](std::optional<double> const& value) {
    return quantity_or({}, value, Unit::millimetre_per_minute, Digits::decimals(0));
  };
  Table table{.key = {}};
  for (auto const& [contour, reason] : subject.contours) {
    if (!contour) continue;
    auto const& one = fastest(*contour);
    auto const limits = contour->limits.value_or(ContourLimits());
    add_row(table, {{"channel", labels::channel,
                     contour->name.empty() ? Value(Names(contour->axes)) : contour->name},
                    {"corner_um", corner_label(subject), um(one.corner.deviation)},
                    {"passed_um", says::overview_passed,
                     one.passed_corner ? Value(um(one.passed_corner->deviation)) : Value()},
                    {"circle_um", circle_label(subject), um(one.circle.deviation)},
                    {"corner_feed", says::kept_at_corner, feed(limits.corner_feed)},
                    {"circle_feed", says::kept_on_circle, feed(limits.circle_feed)}});
  }
  return table;
}

}  // namespace

std::vector<EqualAxes> equal_axes(PlotSubject const& subject) {
  std::vector<EqualAxes> all;
  auto const delays = position_delays(subject);
  std::vector<std::size_t> firsts;
  for (std::size_t i = 0; i < subject.axes.size(); ++i) {
    auto const axis = subject.axes[i];
    std::size_t k = 0;
    while (k < all.size() &&
           !(delay_alike(delays[firsts[k]], delays[i]) && alike(subject, all[k].axes.front(), axis))) {
      ++k;
    }
    if (k == all.size()) {
      all.push_back({});
      firsts.push_back(i);
    }
    all[k].axes.push_back(axis);
    all[k].names += (all[k].names.empty() ? "" : ", ") + subject.name(axis);
  }
  return all;
}

AxisCost cost_of(ReportSubject const& subject, EqualAxes const& axes) {
  PlotSubject one = *subject.plots;
  one.axes = {axes.axes.front()};
  one.before.reset();
  auto const delay = position_delays(one).front();
  AxisCost cost{.delay_ms = delay.total, .start_ms = delay.at_start};
  for (std::size_t i = 0; i < subject.contours.size(); ++i) {
    auto const& contour = subject.contours[i].figures;
    if (!contour) continue;
    auto const& members = subject.machine->groups[i].axes;
    auto const& shown = fastest(*contour);
    for (std::size_t k = 0; k < members.size(); ++k) {
      if (std::find(axes.axes.begin(), axes.axes.end(), members[k]) == axes.axes.end()) continue;
      raise(cost.corner_um, micrometres(shown.corner.axis_error[k]));
      if (shown.passed_corner) raise(cost.passed_um, micrometres(shown.passed_corner->axis_error[k]));
      raise(cost.circle_um, micrometres(shown.circle.axis_error[k]));
    }
  }
  return cost;
}

std::optional<double> margin_um(ReportSubject const& subject, AxisCost const& cost) {
  if (!subject.contour.tolerance_mm || !cost.corner_um) return std::nullopt;
  return *subject.contour.tolerance_mm * motion::um_per_mm - cost.largest_um();
}

Table overview_table(ReportSubject const& subject, OverviewOrder order) {
  if (!subject.plots) return {.key = {}};
  auto const& contents = subject.plots->contents();
  auto const tolerance = subject.contour.tolerance_mm;
  Table table{.key = "overview"};
  std::size_t rest = subject.findings.size();
  auto const add = [&](Value names, Value filters, AxisCost const* cost, std::size_t findings) {
    auto const of = [cost](auto member) {
      return cost != nullptr ? micrometre_cell(cost->*member) : Value();
    };
    Value const margin = cost != nullptr ? micrometre_cell(margin_um(subject, *cost)) : Value();
    add_row(table,
            {{"axes", labels::axes, std::move(names)},
             {"filters", says::overview_filters, std::move(filters)},
             {"delay_ms", labels::delay,
              cost != nullptr ? Value(rounded(cost->delay_ms, Unit::millisecond, 4)) : Value()},
             {"start_ms", says::overview_start,
              quantity_or({}, cost != nullptr ? cost->start_ms : std::nullopt, Unit::millisecond)},
             {"corner_um", corner_label(subject), of(&AxisCost::corner_um)},
             {"passed_um", says::overview_passed, of(&AxisCost::passed_um)},
             {"circle_um", circle_label(subject), of(&AxisCost::circle_um)},
             {"margin_um",
              Words(says::overview_margin, {{"tolerance", exact(tolerance.value_or(0), Unit::millimetre)}}),
              margin},
             {"findings", says::overview_findings, findings}});
  };
  std::vector<std::pair<AxisCost, EqualAxes>> all;
  for (auto& axes : equal_axes(*subject.plots)) {
    auto const cost = cost_of(subject, axes);
    all.emplace_back(cost, std::move(axes));
  }
  if (order == OverviewOrder::costliest_first) {
    std::stable_sort(all.begin(), all.end(), [](auto const& one, auto const& other) {
      return one.first.largest_um() > other.first.largest_um();
    });
  }
  for (auto const& [cost, axes] : all) {
    auto const findings = findings_of(subject, axes);
    rest -= findings;
    add(axes.names, filter_words(contents, axes.axes.front()).value_or(Words(says::overview_no_filter)),
        &cost, findings);
  }
  if (rest > 0) add(Words(says::overview_others), {}, nullptr, rest);
  return table;
}

ReportBlocks cost_blocks(ReportSubject const& subject) {
  if (!subject.plots) return {};
  auto blocks = delay_sentences(subject);
  auto channels = channels_table(subject);
  bool const is_one = channels.rows.size() == 1;
  Names reasons;
  for (auto const& [contour, reason] : subject.contours) {
    if (!contour) {
      bool const is_new = std::find(reasons.begin(), reasons.end(), reason) == reasons.end();
      if (!reason.empty() && is_new) reasons.push_back(reason);
    } else if (is_one) {
      blocks.emplace_back(Paragraph{contour_sentence(subject, *contour)});
      if (contour->limits) blocks.emplace_back(Paragraph{kept_feeds(*contour->limits)});
    }
  }
  constexpr std::size_t most_reasons = 3;
  reasons.resize(std::min(reasons.size(), most_reasons));
  for (auto const& reason : reasons) blocks.emplace_back(Paragraph{as_given(reason)});
  if (channels.rows.size() > 1) {
    auto const feed = exact(subject.highest_feed(), Unit::millimetre_per_minute);
    blocks.emplace_back(Paragraph{Words(says::channels_off, {{"feed", feed}})});
    blocks.emplace_back(std::move(channels));
  }
  return blocks;
}

}  // namespace axisc
