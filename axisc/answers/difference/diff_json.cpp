#include "axisc/answers/difference/diff_formats.hpp"
#include "diagnostics/writers/json_text.hpp"
#include "image/image_readings.hpp"
#include "schema/data_type.hpp"
#include "schema/descriptions/description.hpp"
#include "validator/views/units_text.hpp"

#include <nlohmann/json.hpp>

namespace axisc {

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

char const* state_word(ValueState state) {
  switch (state) {
    case ValueState::set:
      return "set";
    case ValueState::standard:
      return "default";
    case ValueState::missing:
      return "missing";
  }
  return "";
}

ordered_json value_json(ComparedValue const& value) {
  return value.state == ValueState::set ? ordered_json(value.text) : ordered_json(nullptr);
}

ordered_json parameter_json(ParameterChange const& change, Language language) {
  auto const& row = *change.row;
  auto const default_json =
      row.has_default ? ordered_json(validator::default_text(row)) : ordered_json(nullptr);
  return {{"name", change.name},
          {"before", value_json(change.before)},
          {"after", value_json(change.after)},
          {"default", default_json},
          {"place_before", change.before.place},
          {"place_after", change.after.place},
          {"state_before", state_word(change.before.state)},
          {"state_after", state_word(change.after.state)},
          {"equal", change.equal},
          {"p_axis", schema::p_axis_text(row.p_axis)},
          {"meaning", schema::description_of(row).what.in(language)},
          {"unit", change.unit},
          {"restart", change.restart}};
}

ordered_json number_json(ComparedAxis const& axis) {
  return optional_json(axis.number);
}

ordered_json axis_json(AxisDifference const& axis, ShownDifference const& shown, Language language) {
  ordered_json json{{"name", axis.after->name},
                    {"name_before", axis.before->name},
                    {"number_before", number_json(*axis.before)},
                    {"number_after", number_json(*axis.after)},
                    {"list_before", axis.before->list},
                    {"list_after", axis.after->list},
                    {"parameters", ordered_json::array()}};
  for (auto const& change : axis.parameters) json["parameters"].push_back(parameter_json(change, language));
  if (!axis.chain) return json;
  auto const& difference = shown.difference;
  json["before"] = figures_json(axis.chain->before, shown.feed_mm_per_min, difference.before.cycle_time);
  json["after"] = figures_json(axis.chain->after, shown.feed_mm_per_min, difference.after.cycle_time);
  if (axis.chain->reading_before != axis.chain->reading_after) {
    json["before"]["design"] = image::readings_text(axis.chain->reading_before);
    json["after"]["design"] = image::readings_text(axis.chain->reading_after);
  }
  json["gains"] = ordered_json::array();
  for (auto const& gain : axis.chain->gains) {
    json["gains"].push_back(
        {{"frequency_hz", gain.frequency.value}, {"before", gain.before}, {"after", gain.after}});
  }
  return json;
}

ordered_json channel_json(ComparedChannel const* channel) {
  if (channel == nullptr) return nullptr;
  ordered_json json{{"name", channel->name},
                    {"axes", channel->axes},
                    {"spindles", channel->spindles},
                    {"couplings", channel->couplings},
                    {"programs", ordered_json::array()}};
  for (auto const& program : channel->programs) json["programs"].push_back(program.name);
  return json;
}

ordered_json gantries_json(std::vector<ComparedGantry> const& gantries) {
  ordered_json json = ordered_json::array();
  for (auto const& gantry : gantries) json.push_back({{"master", gantry.master}, {"slaves", gantry.slaves}});
  return json;
}

ordered_json names_json(std::vector<ComparedAxis const*> const& axes) {
  ordered_json json = ordered_json::array();
  for (auto const* const axis : axes) json.push_back(axis->name);
  return json;
}

}  // namespace

std::string diff_json(ShownDifference const& shown, Language language) {
  auto const& difference = shown.difference;
  ordered_json json{{"version", 1},
                    {"before", shown.before},
                    {"after", shown.after},
                    {"equal", difference.empty()},
                    {"restart", difference.needs_restart()},
                    {"feed_mm_per_min", shown.feed_mm_per_min},
                    {"cycle_time_us",
                     {{"before", difference.before.cycle_time.microseconds()},
                      {"after", difference.after.cycle_time.microseconds()}}},
                    {"axes_removed", names_json(difference.axes_removed)},
                    {"axes_added", names_json(difference.axes_added)},
                    {"channels", ordered_json::array()},
                    {"gantries",
                     {{"before", gantries_json(difference.gantries_before)},
                      {"after", gantries_json(difference.gantries_after)}}},
                    {"set_to_default", difference.set_to_default},
                    {"left_out", difference.left_out},
                    {"axes", ordered_json::array()}};
  for (auto const& channel : difference.channels) {
    json["channels"].push_back({{"before", channel_json(channel.before)},
                                {"after", channel_json(channel.after)},
                                {"programs_with_other_content", programs_with_other_content(channel)}});
  }
  for (auto const& axis : difference.axes) json["axes"].push_back(axis_json(axis, shown, language));
  return json_document(json);
}

}  // namespace axisc
