#include "axisc/answers/contour/contour_formats.hpp"

#include "analysis/motion/point.hpp"
#include "axisc/answers/json_text.hpp"
#include "axisc/answers/text_table.hpp"
#include "axisc/files/csv.hpp"
#include "diagnostics/format_number.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace axisc::says {

constexpr Sentence group{"{group}: axes {axes}, NC cycle time {cycle_time} µs",
                         "{group}: Achsen {axes}, NC-Zykluszeit {cycle_time} µs"};
constexpr Sentence feed{"feed [mm/min]", "Vorschub [mm/min]"};
constexpr Sentence order{"order", "Ordnung"};
constexpr Sentence lists{"from lists", "aus Listen"};
constexpr Sentence what{"contour", "Kontur"};
constexpr Sentence axis{"{axis} [µm]", "{axis} [µm]"};
constexpr Sentence deviation{"deviation [µm]", "Abweichung [µm]"};
constexpr Sentence corner{"corner, {angle}°", "Ecke, {angle}°"};
constexpr Sentence circle{"circle, r = {radius} mm", "Kreis, r = {radius} mm"};
constexpr Sentence line{"line at 45°", "Gerade unter 45°"};
constexpr Sentence parallel{"there and back", "hin und zurück"};
constexpr Sentence bends{
    "the axes' delays differ (filters or time delays are not the same): straight lines are bent",
    "die Verzögerungen der Achsen sind verschieden (Filter oder Zeitverzögerungen sind nicht gleich): "
    "Geraden werden gekrümmt"};
constexpr Sentence allowed_feed{
    "an axis error of {tolerance} mm is kept at the corner up to {feed} mm/min, on the circle up to {circle} "
    "mm/min",
    "ein Achsfehler von {tolerance} mm wird an der Ecke bis {feed} mm/min eingehalten, auf dem Kreis bis "
    "{circle} mm/min"};
constexpr Sentence any_feed{"any", "beliebig"};
constexpr Sentence allowed_order{"at {feed} mm/min the corner allows order {order}",
                                 "bei {feed} mm/min lässt die Ecke die Ordnung {order} zu"};
constexpr Sentence no_order{"at {feed} mm/min no order keeps the tolerance at the corner",
                            "bei {feed} mm/min hält keine Ordnung die Toleranz an der Ecke ein"};
constexpr Sentence path_group_unnamed{"channel", "Kanal"};

}  // namespace axisc::says

namespace axisc {

namespace {

using motion::ContourFigures;
using motion::units_per_um;
using nlohmann::ordered_json;

std::string say(Language language, SentenceRef text, std::vector<Argument> arguments = {}) {
  return render({.sentence = text, .arguments = std::move(arguments)}, language);
}

Wording micrometres(double units) {
  return format_fixed(units / units_per_um, 3);
}

std::string order_text(ContourCase const& row, Language language) {
  return row.order ? std::to_string(*row.order) : say(language, says::lists);
}

using Rows = std::vector<std::vector<std::string>>;

void add_rows(Rows& rows, ShownContour const& shown, GroupContour const& group, ContourCase const& row,
              Language language) {
  auto const add = [&](std::string what, ContourFigures const& figures) {
    std::vector<std::string> cells = {exact_number(row.feed_mm_per_min).in(language),
                                      order_text(row, language), std::move(what)};
    for (std::size_t i = 0; i < group.axes.size(); ++i) {
      cells.push_back(micrometres(figures.axis_error[i]).in(language));
    }
    cells.push_back(micrometres(figures.deviation).in(language));
    rows.push_back(std::move(cells));
  };
  add(say(language, says::corner, {{"angle", exact_number(shown.angle_deg)}}), row.corner);
  add(say(language, says::circle, {{"radius", exact_number(shown.radius_mm)}}), row.circle);
  add(say(language, says::line), row.line);
  std::vector<std::string> cells = {exact_number(row.feed_mm_per_min).in(language), order_text(row, language),
                                    say(language, says::parallel)};
  cells.resize(3 + group.axes.size());
  cells.push_back(micrometres(row.parallel).in(language));
  rows.push_back(std::move(cells));
}

std::string limits_text(GroupContour const& group, Language language) {
  auto const& limits = *group.limits;
  auto const feed = [&](std::optional<double> const& value) -> Wording {
    return value ? format_fixed(*value, 1) : say(language, says::any_feed);
  };
  std::string text = say(language, says::allowed_feed,
                         {{"tolerance", exact_number(limits.tolerance_mm)},
                          {"feed", feed(limits.corner_feed)},
                          {"circle", feed(limits.circle_feed)}}) +
                     "\n";
  if (!limits.has_order) return text;
  Wording const at = exact_number(group.cases.front().feed_mm_per_min);
  text += limits.order
              ? say(language, says::allowed_order, {{"feed", at}, {"order", std::to_string(*limits.order)}})
              : say(language, says::no_order, {{"feed", at}});
  return text + "\n";
}

ordered_json errors_json(GroupContour const& group, ContourFigures const& figures) {
  ordered_json json = ordered_json::object();
  for (std::size_t i = 0; i < group.axes.size(); ++i) {
    json[group.axes[i]] = figures.axis_error[i] / units_per_um;
  }
  return json;
}

void put_figures(ordered_json& json, GroupContour const& group, ContourFigures const& figures) {
  json["axis_error_um"] = errors_json(group, figures);
  json["max_axis_error_um"] = figures.largest_axis_error() / units_per_um;
  json["contour_deviation_um"] = figures.deviation / units_per_um;
}

/// The corner's figures are direct members of the case, the others are objects by name.
void put_case(ordered_json& json, ShownContour const& shown, GroupContour const& group,
              ContourCase const& row) {
  json["feed_mm_per_min"] = row.feed_mm_per_min;
  json["order"] = row.order ? ordered_json(*row.order) : ordered_json(nullptr);
  json["angle_deg"] = shown.angle_deg;
  put_figures(json, group, row.corner);
  json["circle"]["radius_mm"] = shown.radius_mm;
  put_figures(json["circle"], group, row.circle);
  put_figures(json["line"], group, row.line);
  json["parallel"]["contour_deviation_um"] = row.parallel / units_per_um;
}

ordered_json limits_json(ContourLimits const& limits) {
  auto const optional = [](auto const& value) {
    return value ? ordered_json(*value) : ordered_json(nullptr);
  };
  ordered_json json{{"tolerance_mm", limits.tolerance_mm},
                    {"allowed_feed_mm_per_min", optional(limits.corner_feed)},
                    {"circle_allowed_feed_mm_per_min", optional(limits.circle_feed)}};
  if (limits.has_order) json["allowed_order"] = optional(limits.order);
  return json;
}

}  // namespace

std::string contour_text(ShownContour const& shown, Language language) {
  std::string text;
  for (auto const& group : shown.groups) {
    if (!text.empty()) text += "\n";
    std::string names;
    for (auto const& axis : group.axes) names += (names.empty() ? "" : ", ") + axis;
    text += say(language, says::group,
                {{"group", group.name.empty() ? say(language, says::path_group_unnamed) : group.name},
                 {"axes", names},
                 {"cycle_time", exact_number(shown.cycle_time_us)}}) +
            "\n";
    Rows rows = {{say(language, says::feed), say(language, says::order), say(language, says::what)}};
    for (auto const& axis : group.axes) {
      rows[0].push_back(say(language, says::axis, {{"axis", axis}}));
    }
    rows[0].push_back(say(language, says::deviation));
    for (auto const& row : group.cases) add_rows(rows, shown, group, row, language);
    text += text_table(rows, 2);
    if (!group.synchronous) text += say(language, says::bends) + "\n";
    if (group.limits) text += limits_text(group, language);
  }
  return text;
}

std::string contour_csv(ShownContour const& shown) {
  std::string text = "group,feed_mm_per_min,order,contour,axis,axis_error_um,contour_deviation_um\n";
  for (auto const& group : shown.groups) {
    for (auto const& row : group.cases) {
      auto const add = [&](std::string_view contour, ContourFigures const& figures) {
        for (std::size_t i = 0; i < group.axes.size(); ++i) {
          append_csv_name(text, group.name);
          text += fmt::format(",{},{},{},", row.feed_mm_per_min, row.order ? std::to_string(*row.order) : "",
                              contour);
          append_csv_name(text, group.axes[i]);
          text +=
              fmt::format(",{},{}\n", figures.axis_error[i] / units_per_um, figures.deviation / units_per_um);
        }
      };
      add("corner", row.corner);
      add("circle", row.circle);
      add("line", row.line);
      add("parallel", {.axis_error = {}, .deviation = row.parallel});
    }
  }
  return text;
}

std::string contour_json(ShownContour const& shown) {
  ordered_json json{
      {"version", 1}, {"cycle_time_us", shown.cycle_time_us}, {"groups", ordered_json::array()}};
  for (auto const& group : shown.groups) {
    ordered_json entry{{"group", group.name}, {"axes", group.axes}, {"synchronous", group.synchronous}};
    put_case(entry, shown, group, group.cases.front());
    if (group.limits) entry.update(limits_json(*group.limits));
    entry["table"] = ordered_json::array();
    for (auto const& row : group.cases) {
      ordered_json line = ordered_json::object();
      put_case(line, shown, group, row);
      entry["table"].push_back(std::move(line));
    }
    json["groups"].push_back(std::move(entry));
  }
  return json_document(json);
}

}  // namespace axisc
