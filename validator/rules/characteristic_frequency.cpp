#include "validator/rules/characteristic_frequency.hpp"

#include "validator/fir_view.hpp"
#include "validator/rules/filter_words.hpp"

#include <array>
#include <cstdint>

namespace axisc::validator::checks {
namespace {

using Frequencies = std::vector<CharacteristicFrequency>;

constexpr int hsc_novib = 12;
constexpr std::uint32_t stages = 3;
constexpr std::uint32_t filters_per_stage = 2;
constexpr std::string_view path_message = "50557";
constexpr std::string_view position_controller_message = "70420";

bool uses_frequency(FilterView const& filter) {
  if (filter.active()) return design::uses_frequency(*filter.standard_type());
  bool const is_novib = filter.is_hsc() && !filter.type_unusable() && filter.type_number() == hsc_novib;
  return is_novib && filter.port == FilterPort::setpoint;
}

void add_standard_filters(EffectiveValues const& values, Frequencies& found) {
  for (FilterView const& filter : touched_filters(values)) {
    if (filter.frequency.unusable || !uses_frequency(filter)) continue;
    found.push_back({filter.frequency, filter.anchor(filter.frequency), std::string(filter.type_word()),
                     filter.port == FilterPort::setpoint ? path_message : position_controller_message});
  }
}

void add_windowed_sinc(EffectiveValues const& values, Frequencies& found) {
  FirView const fir(values);
  if (fir.frequency.unusable || fir.configured_type() != FirType::windowed_sinc) return;
  found.push_back({fir.frequency, fir.anchor(fir.frequency), "filter_fir.type 3", path_message});
}

// The documented default, -1, means that no frequency is configured.
void add_stage_frequency(EffectiveValue const& frequency, EffectiveValue const& mode, Frequencies& found) {
  if (!configured(frequency)) return;
  found.push_back({frequency, frequency, symbol_word(mode), position_controller_message});
}

bool filters_something(EffectiveValues const& values, std::uint32_t stage, std::uint32_t filter) {
  EffectiveValue const& type =
      values.at("lr_param.improved_position_control.stage[].filter[].type", stage, filter);
  if (type.unusable) return false;
  // By default the first filter is a band-pass and the second is none.
  return type.set() ? type.value.text != "NO_FILTER" : filter == 0;
}

void add_stages(EffectiveValues const& values, Frequencies& found) {
  EffectiveValue const& enable = values.at("lr_param.improved_position_control.enable");
  if (enable.unusable || !enable.value.flag()) return;
  for (std::uint32_t stage = 0; stage < stages; ++stage) {
    EffectiveValue const& mode = values.at("lr_param.improved_position_control.stage[].mode", stage);
    if (mode.unusable || !mode.value.flag()) continue;
    add_stage_frequency(values.at("lr_param.improved_position_control.stage[].filter.fg_f0", stage), mode,
                        found);
    for (std::uint32_t filter = 0; filter < filters_per_stage; ++filter) {
      if (!filters_something(values, stage, filter)) continue;
      add_stage_frequency(
          values.at("lr_param.improved_position_control.stage[].filter[].fg_f0", stage, filter), mode, found);
    }
  }
}

}  // namespace

std::vector<CharacteristicFrequency> characteristic_frequencies(EffectiveValues const& values) {
  Frequencies found;
  add_standard_filters(values, found);
  add_windowed_sinc(values, found);
  add_stages(values, found);
  return found;
}

}  // namespace axisc::validator::checks
