#include "analysis/motion/point.hpp"
#include "axisc/answers/json_text.hpp"
#include "axisc/answers/suggestion/damping_formats.hpp"
#include "axisc/answers/suggestion/suggest_formats.hpp"

#include <array>
#include <string_view>

#include <nlohmann/json.hpp>

namespace axisc {

namespace {

using nlohmann::ordered_json;

constexpr std::array<std::string_view, tuning::senses> sense_words = {"least_deviation", "balanced",
                                                                      "least_vibration"};

ordered_json optional(std::optional<double> const& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json setting_json(Suggestion const& suggestion, Setting const& setting) {
  auto const& figures = setting.figures;
  ordered_json json{{"chain", tuning::short_name(setting.chain, Language::english)},
                    {"remaining_vibration", figures.vibration},
                    {"resonances", ordered_json::array()}};
  for (std::size_t i = 0; i < figures.resonances.size(); ++i) {
    auto const& vibration = figures.resonances[i];
    json["resonances"].push_back({{"frequency_hz", suggestion.task.resonances[i].frequency},
                                  {"remaining_vibration", vibration.worst},
                                  {"amplitude_um", vibration.amplitude / motion::units_per_um},
                                  {"unfiltered_um", vibration.unfiltered / motion::units_per_um}});
  }
  json["delay_cycles"] = figures.delay;
  json["delay_ms"] = figures.delay * suggestion.cycle_time.seconds() * 1e3;
  json["overshoot"] = figures.overshoot;
  json["corner"] = {{"max_axis_error_um", setting.corner.largest_axis_error() / motion::units_per_um},
                    {"contour_deviation_um", setting.corner.deviation / motion::units_per_um},
                    {"allowed_feed_mm_per_min", optional(setting.corner_feed)}};
  json["circle"] = {{"max_axis_error_um", setting.circle.largest_axis_error() / motion::units_per_um},
                    {"contour_deviation_um", setting.circle.deviation / motion::units_per_um},
                    {"allowed_feed_mm_per_min", optional(setting.circle_feed)}};
  return json;
}

ordered_json alternative_json(Suggestion const& suggestion, std::size_t index) {
  auto const& alternative = suggestion.alternatives[index];
  ordered_json json{{"number", index + 1}, {"sense", sense_words[index]}, {"senses", ordered_json::array()}};
  for (auto const sense : suggestion.senses_of(index)) {
    json["senses"].push_back(sense_words.at(static_cast<std::size_t>(sense)));
  }
  json.update(setting_json(suggestion, alternative.setting));
  json["command"] = alternative.command ? ordered_json(*alternative.command) : ordered_json(nullptr);
  json["findings"] = alternative.findings;
  json["axes"] = axes_json(alternative.axes);
  return json;
}

}  // namespace

ordered_json axes_json(std::vector<AxisLines> const& axes) {
  ordered_json json = ordered_json::array();
  for (auto const& axis : axes) {
    ordered_json lines = ordered_json::array();
    for (auto const& [name, value] : axis.lines) lines.push_back({{"name", name}, {"value", value}});
    json.push_back({{"axis", axis.axis}, {"list", axis.list}, {"lines", std::move(lines)}});
  }
  return json;
}

std::string suggest_json(SuggestionSubject const& subject, NoSuggestion const& none,
                         DampingAnswer const& damping, tuning::Task const& task) {
  auto const& machine = subject.machine;
  return json_document({{"version", 1},
                        {"axis", machine.axes[subject.axis].name},
                        {"group", machine.groups[subject.group].name},
                        {"settings_compared", none.looked_at},
                        {"alternatives", ordered_json::array()},
                        {"position_control", damping_json(damping, task)}});
}

std::string suggest_json(Suggestion const& suggestion, DampingAnswer const* damping) {
  ordered_json json{{"version", 1},
                    {"axis", suggestion.axis},
                    {"group", suggestion.group},
                    {"axes", suggestion.axes},
                    {"cycle_time_us", suggestion.cycle_time.microseconds()},
                    {"feed_mm_per_min", suggestion.feed},
                    {"tolerance_mm", suggestion.tolerance_mm},
                    {"radius_mm", suggestion.radius_mm},
                    {"resonances", ordered_json::array()},
                    {"settings_compared", suggestion.looked_at}};
  for (auto const& resonance : suggestion.task.resonances) {
    json["resonances"].push_back({{"frequency_hz", resonance.frequency},
                                  {"uncertainty_hz", resonance.uncertainty},
                                  {"damping", optional(resonance.damping)}});
  }
  if (suggestion.measured) {
    json["measured"] = ordered_json::array();
    for (auto const& peak : suggestion.measured->peaks) {
      json["measured"].push_back({{"frequency_hz", peak.frequency},
                                  {"frequency_uncertainty_hz", peak.frequency_uncertainty},
                                  {"damping", peak.damping},
                                  {"damping_uncertainty", peak.damping_uncertainty},
                                  {"coherence", optional(peak.coherence)}});
    }
  }
  json["present"] =
      suggestion.present ? setting_json(suggestion, *suggestion.present) : ordered_json(nullptr);
  json["recommended"] = suggestion.proposed.at(static_cast<std::size_t>(suggestion.recommended)) + 1;
  json["alternatives"] = ordered_json::array();
  for (std::size_t i = 0; i < tuning::senses; ++i) {
    if (suggestion.proposed.at(i) == i) json["alternatives"].push_back(alternative_json(suggestion, i));
  }
  if (damping != nullptr) json["position_control"] = damping_json(*damping, suggestion.task);
  return json_document(json);
}

}  // namespace axisc
