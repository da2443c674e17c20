#include "analysis/tuning/position_control/control_lines.hpp"

#include "diagnostics/format_number.hpp"

#include <array>
#include <string_view>

namespace axisc::tuning::says {

constexpr Sentence stage{"{mode} {frequency} Hz, order {order}, quality {quality}, weight {weight}",
                         "{mode} {frequency} Hz, Ordnung {order}, Güte {quality}, Gewicht {weight}"};
constexpr Sentence damped_stage{
    "{mode} {frequency} Hz, order {order}, quality {quality}, damping {damping}, weight {weight}",
    "{mode} {frequency} Hz, Ordnung {order}, Güte {quality}, Dämpfung {damping}, Gewicht {weight}"};

}  // namespace axisc::tuning::says

namespace axisc::tuning {
namespace {

constexpr std::string_view prefix = "lr_param.improved_position_control.";
/// By number of P-AXIS-00753.
constexpr std::array<std::string_view, 4> mode_words = {"NOT_ACTIVE", "DIRECT", "INDIRECT", "SET_POINT"};

std::string word_of(machine::StageMode mode) {
  return std::string(mode_words.at(static_cast<std::size_t>(mode)));
}

}  // namespace

std::vector<ListLine> control_lines(machine::PositionControl const& control) {
  std::vector<ListLine> lines;
  auto const add = [&](std::string const& name, std::string value) {
    lines.push_back({.name = std::string(prefix) + name, .value = std::move(value)});
  };
  add("enable", "1");
  add("v_add_max_fact", format_exact(control.limit_factor));
  for (auto const& stage : control.stages) {
    auto const name = "stage[" + std::to_string(stage.index) + "].";
    auto const& filter = stage.filters.front();
    add(name + "mode", word_of(stage.mode));
    add(name + "filter.order", std::to_string(filter.order));
    add(name + "filter.fg_f0", format_exact(filter.frequency.value));
    add(name + "filter.q_factor", format_exact(filter.quality));
    if (stage.oscillator) add(name + "filter.damping", format_exact(stage.oscillator->damping));
    add(name + "weight_fact_num", format_exact(stage.weight_numerator));
    add(name + "weight_fact_denom", format_exact(stage.weight_denominator));
  }
  return lines;
}

std::string short_name(machine::PositionControl const& control, Language language) {
  std::string text;
  for (auto const& stage : control.stages) {
    auto const& filter = stage.filters.front();
    std::vector<Argument> arguments{
        {"mode", word_of(stage.mode)},
        {"frequency", exact_number(filter.frequency.value)},
        {"order", std::to_string(filter.order)},
        {"quality", exact_number(filter.quality)},
        {"weight", exact_number(stage.weight_numerator / stage.weight_denominator)}};
    if (stage.oscillator) arguments.push_back({"damping", exact_number(stage.oscillator->damping)});
    text += (text.empty() ? "" : " + ") +
            render({stage.oscillator ? SentenceRef(says::damped_stage) : SentenceRef(says::stage),
                    std::move(arguments)},
                   language);
  }
  return text;
}

}  // namespace axisc::tuning
