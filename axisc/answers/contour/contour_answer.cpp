#include "axisc/answers/contour/contour_answer.hpp"

#include "analysis/motion/point.hpp"
#include "axisc/answers/contour/passage_blocks.hpp"
#include "axisc/answers/labels.hpp"
#include "axisc/checking/path_machine.hpp"
#include "configuration/machine/guards.hpp"
#include "design/units.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <functional>
#include <optional>

namespace axisc::says {

constexpr Sentence title{"contour deviations, NC cycle time {cycle_time}",
                         "Bahnabweichungen, NC-Zykluszeit {cycle_time}"};
constexpr Sentence group{"{group}: axes {axes}", "{group}: Achsen {axes}"};
constexpr Sentence channel{"channel: axes {axes}", "Kanal: Achsen {axes}"};
constexpr Sentence feed{"F", "F"};
constexpr Sentence shape{"contour", "Kontur"};
constexpr Sentence corner{"corner, {angle}", "Ecke, {angle}"};
constexpr Sentence passed_corner{"corner, as passed", "Ecke, wie gefahren"};
constexpr Sentence circle{"circle, r {radius}", "Kreis, r {radius}"};
constexpr Sentence line{"line, 45°", "Gerade, 45°"};
constexpr Sentence parallel{"there and back", "hin und zurück"};
constexpr Sentence bends{
    "the axes' delays differ (filters or time delays are not the same): straight lines are bent",
    "die Verzögerungen der Achsen sind verschieden (Filter oder Zeitverzögerungen sind nicht gleich): "
    "Geraden werden gekrümmt"};
constexpr Sentence delayed_after_filters{
    "after the filters, positions are delayed as well: {axes} cycles (a reading; `--budget` names the "
    "parameters)",
    "nach den Filtern sind Positionen ebenfalls verzögert: {axes} Zyklen (eine Lesart; `--budget` nennt die "
    "Parameter)"};
constexpr Sentence allowed_feed{
    "an axis error of {tolerance} is kept at the corner up to {feed}, on the circle up to {circle}",
    "ein Achsfehler von {tolerance} wird an der Ecke bis {feed} eingehalten, auf dem Kreis bis {circle}"};
constexpr Sentence any_feed{"any feed", "zu jedem Vorschub"};
constexpr Sentence allowed_order{"at {feed} the corner allows order {order}",
                                 "bei {feed} lässt die Ecke die Ordnung {order} zu"};
constexpr Sentence no_order{"at {feed} no order keeps the tolerance at the corner",
                            "bei {feed} hält keine Ordnung die Toleranz an der Ecke ein"};
constexpr Sentence feed_above_limit{
    "axis {axis} cannot move at {feed} mm/min; its vb_max (P-AXIS-00212) is {limit} mm/min",
    "Achse {axis} kann nicht mit {feed} mm/min fahren; ihr vb_max (P-AXIS-00212) ist {limit} mm/min"};

}  // namespace axisc::says

namespace axisc {

namespace {

using motion::ContourFigures;
using namespace presentation;

Quantity micrometres(double units) {
  return fixed(units / motion::units_per_um, Unit::micrometre, 3);
}

Value order_of(ContourCase const& one) {
  return one.order ? Value(*one.order) : Nothing{Words(labels::lists)};
}

Table table_of(GroupContour const& group, ContourRequest const& wanted) {
  Table table{.key = "table",
              .columns = {head_column("feed_mm_per_min", says::feed, Unit::millimetre_per_minute),
                          head_column("order", labels::order), head_column("contour", says::shape),
                          column("contour_deviation_um", labels::deviation, Unit::micrometre),
                          data_column("max_axis_error_um")},
              .rows = {}};
  for (auto const& axis : group.axes) {
    table.columns.push_back(
        column("axis_error_um", Words(says::as_given, {{"text", axis}}), Unit::micrometre, axis));
  }
  auto const passage = passage_columns();
  for (auto const& one : passage) table.columns.push_back(data_column(one.key));
  std::size_t const per_feed = group.cases.size() / group.passages.size();
  for (std::size_t k = 0; k < group.cases.size(); ++k) {
    auto const& one = group.cases[k];
    auto const add = [&](std::string_view shape, Words words, std::optional<double> deviation,
                         ContourFigures const* figures) {
      Row row{exact(one.feed_mm_per_min), order_of(one), Symbol{shape, std::move(words)},
              deviation ? Value(micrometres(*deviation)) : Value(),
              figures != nullptr ? Value(micrometres(figures->largest_axis_error())) : Value()};
      for (std::size_t i = 0; i < group.axes.size(); ++i) {
        row.push_back(figures != nullptr ? Value(micrometres(figures->axis_error[i])) : Value());
      }
      row.resize(table.columns.size());
      table.rows.push_back(std::move(row));
    };
    add("corner", Words(says::corner, {{"angle", exact(wanted.angle_deg, Unit::degree)}}),
        one.corner.deviation, &one.corner);
    auto const* const passed = one.passed_corner ? &*one.passed_corner : nullptr;
    add("corner_as_passed", says::passed_corner,
        passed != nullptr ? std::optional(passed->deviation) : std::nullopt, passed);
    auto figures = passage_figures(group.passages[k / per_feed].passage, group.dynamics.cycle_time);
    std::move(figures.begin(), figures.end(), table.rows.back().end() - std::ssize(passage));
    add("circle", Words(says::circle, {{"radius", exact(wanted.radius_mm, Unit::millimetre)}}),
        one.circle.deviation, &one.circle);
    add("line", says::line, one.line.deviation, &one.line);
    add("parallel", says::parallel, one.parallel, nullptr);
  }
  return table;
}

/// For programs: the table's first case, the corner's figures as direct members, the others as objects by
/// name.
void add_first_case(std::vector<Block>& blocks, Table const& table) {
  constexpr std::size_t shape = 2;
  constexpr std::size_t shapes = 5;
  auto const& first = table.rows.front();
  blocks.emplace_back(Facts{{data(table.columns[0].key, first[0]), data(table.columns[1].key, first[1])}});
  for (std::size_t k = 0; k < shapes; ++k) {
    auto const& row = table.rows[k];
    std::vector<Field> fields;
    for (std::size_t i = shape + 1; i < row.size() - passage_columns().size(); ++i) {
      fields.push_back(data(table.columns[i].key, row[i], table.columns[i].member));
    }
    std::string const name(std::get<Symbol>(row[shape].form()).symbol);
    blocks.emplace_back(k == 0 ? Block(Facts{std::move(fields)}) : data_section(name, std::move(fields)));
  }
}

Value feed_or_any(std::optional<double> const& value) {
  return quantity_or(Nothing{Words(says::any_feed)}, value, Unit::millimetre_per_minute, Digits::decimals(1));
}

/// What keeps the tolerance.
void add_limits(std::vector<Block>& blocks, GroupContour const& group) {
  auto const& limits = *group.limits;
  Facts facts{{data("tolerance_mm", limits.tolerance_mm),
               data("allowed_feed_mm_per_min", feed_or_any(limits.corner_feed)),
               data("circle_allowed_feed_mm_per_min", feed_or_any(limits.circle_feed))}};
  blocks.emplace_back(Paragraph{kept_feeds(limits)});
  if (limits.has_order) {
    Value const order(limits.order);
    facts.fields.push_back(data("allowed_order", order));
    auto const at = exact(group.cases.front().feed_mm_per_min, Unit::millimetre_per_minute);
    blocks.emplace_back(Paragraph{limits.order ? Words(says::allowed_order, {{"feed", at}, {"order", order}})
                                               : Words(says::no_order, {{"feed", at}})});
  }
  blocks.emplace_back(std::move(facts));
}

/// The slowest of the axes that none of the feeds may exceed.
std::optional<Message> unreachable_feed(machine::Machine const& machine, machine::MachineGroup const& group,
                                        std::vector<double> const& feeds) {
  double const fastest = *std::max_element(feeds.begin(), feeds.end());
  for (auto const index : group.axes) {
    auto const& axis = machine.axes[index];
    double const limit = axis.velocity_limit * design::mm_per_min_of_um_per_s;
    if (axis.type != machine::AxisType::translatory || !(limit > 0) || fastest <= limit) continue;
    return Message{
        .sentence = says::feed_above_limit,
        .arguments = {
            {"feed", exact_number(fastest)}, {"axis", axis.name}, {"limit", format_rounded(limit, 6)}}};
  }
  return std::nullopt;
}

/// What delays the positions after their filters, where it differs.
void add_unequal_delays(std::vector<Block>& blocks, GroupContour const& group) {
  auto const& delays = group.position_delays;
  if (std::adjacent_find(delays.begin(), delays.end(), std::not_equal_to<>()) == delays.end()) return;
  Names axes;
  for (std::size_t i = 0; i < delays.size(); ++i) {
    axes.push_back(group.axes[i] + " " + format_rounded(delays[i].cycles + delays[i].lag, 4).written());
  }
  blocks.emplace_back(Paragraph{Words(says::delayed_after_filters, {{"axes", axes}})});
}

}  // namespace

Words kept_feeds(ContourLimits const& limits) {
  return {says::allowed_feed,
          {{"tolerance", exact(limits.tolerance_mm, Unit::millimetre)},
           {"feed", feed_or_any(limits.corner_feed)},
           {"circle", feed_or_any(limits.circle_feed)}}};
}

std::vector<Block> contour_blocks(GroupContour const& group, ContourRequest const& wanted) {
  std::vector<Block> blocks{table_of(group, wanted)};
  if (!group.synchronous) blocks.emplace_back(Paragraph{says::bends});
  add_unequal_delays(blocks, group);
  if (group.limits) add_limits(blocks, group);
  for (auto& block : passage_blocks(group, wanted)) blocks.push_back(std::move(block));
  return blocks;
}

presentation::Document contour_answer(ContourQuestion const& question, machine::Machine const& machine,
                                      std::function<void(Message const&)> const& remark) {
  auto const& wanted = question.wanted;
  auto const cycle_time = exact(machine.cycle_time.microseconds(), Unit::microsecond);
  Sections groups{.key = "groups", .items = {}};
  for (auto i = chosen_group(machine, question.group, question.machine); i < machine.groups.size(); ++i) {
    auto const& group = machine.groups[i];
    if (group.axes.empty()) continue;
    if (auto const message = unreachable_feed(machine, group, wanted.feeds); message && remark) {
      remark(*message);
    }
    auto const commands =
        question.filter
            ? std::vector{read_filter_command(machine, group, *question.filter, question.language)}
            : filters_on();
    // #VIB GUARD gives every axis a guard, whatever the lists say.
    std::optional<machine::Machine> guarded;
    if (commands.front().parameters.guard) machine::add_guards(guarded.emplace(machine), i);
    auto const found = predict_contour(
        {.machine = guarded ? *guarded : machine, .group = i, .commands = commands, .path = question.machine},
        wanted);
    auto blocks = contour_blocks(found, wanted);
    blocks.insert(blocks.begin(),
                  Facts{{data("axes", Names(found.axes)), data("synchronous", found.synchronous),
                         data("angle_deg", wanted.angle_deg), data("radius_mm", wanted.radius_mm)}});
    add_first_case(blocks, table_of(found, wanted));
    groups.items.push_back({.key = {},
                            .title = found.name.empty() ? Words(says::channel, {{"axes", Names(found.axes)}})
                                                        : Words(says::group, {{"group", found.name},
                                                                              {"axes", Names(found.axes)}}),
                            .blocks = std::move(blocks),
                            .identity = {data("group", found.name)}});
    if (question.group) break;
  }
  return {.version = 2,
          .title = Words(says::title, {{"cycle_time", cycle_time}}),
          .blocks = {Facts{{data("cycle_time_us", cycle_time)}}, std::move(groups)},
          .csv_table = "table"};
}

}  // namespace axisc
