#include "validator/rules/characteristic_frequency.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/fir_view.hpp"
#include "validator/views/hsc_view.hpp"
#include "validator/views/position_control_view.hpp"

#include <span>

namespace axisc::validator::checks {
namespace {

using Frequencies = std::vector<CharacteristicFrequency>;

bool uses_frequency(FilterView const& filter) {
  if (filter.active()) return design::uses_frequency(*filter.standard_type);
  return hsc_type(filter) == HscType::novib;
}

void add_standard_filters(std::span<FilterView const> filters, Frequencies& found) {
  for (FilterView const& filter : filters) {
    if (filter.frequency.unusable || !uses_frequency(filter)) continue;
    found.push_back(
        {filter.frequency, filter.anchor(filter.frequency), std::string(filter.type_word()),
         filter.port == FilterPort::setpoint ? Filtering::setpoint : Filtering::position_controller});
  }
}

void add_windowed_sinc(FirView const& fir, Frequencies& found) {
  if (fir.frequency.unusable || fir.configured_type() != FirType::windowed_sinc) return;
  found.push_back({fir.frequency, fir.anchor(fir.frequency), "filter_fir.type 3", Filtering::setpoint});
}

void add_vibration_guard(EffectiveValues const& values, Frequencies& found) {
  EffectiveValue const& frequency = values.at("vib_guard.freq");
  if (frequency.unusable || !frequency.set()) return;
  found.push_back({frequency, frequency, "vib_guard", Filtering::vibration_guard});
}

// The documented default, -1, means that no frequency is configured.
void add_stages(PositionControlView const& position_control, Frequencies& found) {
  for (StageView const& stage : position_control.active_stages()) {
    for (StageFilterView const& filter : stage.filters()) {
      if (!configured(filter.frequency)) continue;
      found.push_back(
          {filter.frequency, filter.frequency, symbol_word(stage.mode), Filtering::position_controller});
    }
  }
}

/// Of both spellings.
void add_distance_control(EffectiveValues const& values, Frequencies& found) {
  for (std::string const family : {"kenngr.distc.", "kenngr.dist_ctrl[]."}) {
    EffectiveValue const& frequency = values.at(family + "low_pass_filter_fg_f0");
    EffectiveValue const& type = values.at(family + "filter_type");
    bool const is_used = values.at(family + "low_pass_filter_enable").is_on() ||
                         (!type.unusable && type.value.text == "LOWPASS");
    if (frequency.unusable || !frequency.set() || !is_used) continue;
    found.push_back({frequency, frequency, family + "low_pass_filter", Filtering::distance_control});
  }
}

}  // namespace

std::vector<CharacteristicFrequency> characteristic_frequencies(AxisContext const& axis) {
  Frequencies found;
  add_standard_filters(axis.filters, found);
  add_windowed_sinc(axis.fir, found);
  add_vibration_guard(axis.values, found);
  add_stages(axis.position_control, found);
  add_distance_control(axis.values, found);
  return found;
}

}  // namespace axisc::validator::checks
