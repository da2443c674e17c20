#include "analysis/motion/point.hpp"
#include "analysis/tuning/position_control/control_lines.hpp"
#include "axisc/answers/suggestion/damping_formats.hpp"
#include "axisc/answers/suggestion/suggest_formats.hpp"

#include <string_view>

#include <nlohmann/json.hpp>

namespace axisc {

namespace {

using nlohmann::ordered_json;

std::string_view reason_word(tuning::NoDamping reason) {
  switch (reason) {
    case tuning::NoDamping::no_resonance:
      return "no_resonance";
    case tuning::NoDamping::still:
      return "still";
    case tuning::NoDamping::diverges:
      return "diverges";
    case tuning::NoDamping::not_enough:
      break;
  }
  return "not_enough";
}

ordered_json refusal(DampingAnswer const& answer) {
  auto const* const none = std::get_if<tuning::NoDampingFound>(&answer.found);
  return {{"plant", answer.plant_path},
          {"refusal", none != nullptr ? reason_word(none->reason) : "gantry"},
          {"settings_compared", none != nullptr ? none->looked_at : 0}};
}

}  // namespace

ordered_json damping_json(DampingAnswer const& answer, tuning::Task const& task) {
  auto const* const damping = answer.damping();
  if (damping == nullptr) return refusal(answer);
  auto const um = [](double units) { return units / motion::units_per_um; };
  ordered_json json{{"plant", answer.plant_path},
                    {"settings_compared", damping->looked_at},
                    {"number", damping_number},
                    {"stages", tuning::short_name(damping->control, Language::english)},
                    {"resonances", ordered_json::array()}};
  for (std::size_t i = 0; i < damping->resonances.size(); ++i) {
    auto const& resonance = damping->resonances[i];
    json["resonances"].push_back(
        {{"frequency_hz", task.resonances[i].frequency},
         {"is_in_plant", resonance.is_in_plant},
         {"is_noticeable", resonance.is_noticeable},
         {"stage", resonance.stage ? ordered_json(*resonance.stage) : ordered_json(nullptr)},
         {"amplitude_without_m_per_s2", resonance.without},
         {"amplitude_with_m_per_s2", resonance.with},
         {"worst_amplitude_without_m_per_s2", resonance.worst_without},
         {"worst_amplitude_with_m_per_s2", resonance.worst}});
  }
  json["shift_on_circle_um"] = um(damping->circle);
  json["largest_shift_um"] = um(damping->shift);
  json["distance_from_setpoint_um"] = {{"without", um(damping->error_without)},
                                       {"with", um(damping->error_with)}};
  json["max_additive_velocity_um_per_s"] = damping->additive_velocity;
  json["findings"] = answer.findings;
  json["axes"] = axes_json(answer.axes);
  return json;
}

}  // namespace axisc
