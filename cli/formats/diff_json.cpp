#include "cli/formats/diff_formats.hpp"
#include "cli/report/json_text.hpp"

#include <nlohmann/json.hpp>

namespace axisc::cli {

namespace {

using nlohmann::ordered_json;

template <class Value>
ordered_json optional_json(std::optional<Value> const& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json figures_json(image::ChainFigures const& figures, double feed, design::CycleTime cycle_time) {
  double const ms = cycle_time.seconds() * 1e3;
  ordered_json json{{"delay_ms", figures.delay_cycles * ms}, {"overshoot_percent", figures.overshoot * 100}};
  json["settling_ms"] = figures.settling_cycles
                            ? ordered_json(static_cast<double>(*figures.settling_cycles) * ms)
                            : ordered_json(nullptr);
  json["corner_deviation_um"] = optional_json(corner_deviation_um(figures, feed, cycle_time));
  return json;
}

ordered_json axis_json(image::AxisChange const& axis, ShownDifference const& shown) {
  ordered_json json{{"name", axis.name}, {"parameters", ordered_json::array()}};
  for (auto const& change : axis.parameters) {
    json["parameters"].push_back({{"name", change.name},
                                  {"before", optional_json(change.before)},
                                  {"after", optional_json(change.after)},
                                  {"default", optional_json(default_of(change))},
                                  {"place_before", change.place_before},
                                  {"place_after", change.place_after}});
  }
  if (!axis.filtering_changed) return json;
  auto const& difference = shown.difference;
  json["before"] = figures_json(axis.before, shown.feed_mm_per_min, difference.cycle_time_before);
  json["after"] = figures_json(axis.after, shown.feed_mm_per_min, difference.cycle_time_after);
  json["gains"] = ordered_json::array();
  for (auto const& gain : axis.gains) {
    json["gains"].push_back(
        {{"frequency_hz", gain.frequency.value}, {"before", gain.before}, {"after", gain.after}});
  }
  return json;
}

}  // namespace

std::string diff_json(ShownDifference const& shown) {
  auto const& difference = shown.difference;
  ordered_json json{{"version", 1},
                    {"before", shown.before},
                    {"after", shown.after},
                    {"equal", difference.empty()},
                    {"feed_mm_per_min", shown.feed_mm_per_min},
                    {"cycle_time_us",
                     {{"before", difference.cycle_time_before.microseconds()},
                      {"after", difference.cycle_time_after.microseconds()}}},
                    {"axes_removed", difference.axes_removed},
                    {"axes_added", difference.axes_added},
                    {"axes", ordered_json::array()}};
  for (auto const& axis : difference.axes) json["axes"].push_back(axis_json(axis, shown));
  return json_document(json);
}

}  // namespace axisc::cli
