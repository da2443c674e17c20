#include "configuration/machine/filter_command.hpp"

#include <fmt/format.h>

namespace axisc::machine {

std::string to_text(FilterParameters const& parameters) {
  std::string text;
  auto const add = [&text](std::string_view keyword, auto const& value) {
    if (value) text += fmt::format("{}{}={}", text.empty() ? "" : " ", keyword, *value);
  };
  add(parameters.guard ? "MODE" : "ORDER", parameters.order);
  add("SHARE", parameters.share_percent);
  add(parameters.guard ? "FREQ" : "FCUT",
      parameters.frequency ? std::optional(parameters.frequency->value) : std::nullopt);
  add(parameters.guard ? "DAMPING" : "QUALITY", parameters.quality);
  return text;
}

std::string to_text(FilterCommand const& command) {
  std::string text = command.parameters.guard ? "#VIB GUARD" : "#FILTER";
  if (command.filter_switch == FilterSwitch::off) return text + " OFF";
  if (command.filter_switch == FilterSwitch::on) text += " ON";
  std::string const keywords = command.hsc ? "HSC" : to_text(command.parameters);
  return keywords.empty() ? text : text + " [" + keywords + "]";
}

design::KernelSpecification with_parameters(design::KernelSpecification listed,
                                            FilterParameters const& parameters) {
  if (parameters.order) listed.order = *parameters.order;
  if (parameters.share_percent) listed.share_percent = *parameters.share_percent;
  if (parameters.frequency) listed.frequency = *parameters.frequency;
  if (parameters.quality) listed.quality = *parameters.quality;
  return listed;
}

FilterParameters parameters_after(FilterParameters const& before, FilterCommand const& command) {
  if (command.filter_switch == FilterSwitch::off || command.hsc) return before;
  FilterParameters after = command.parameters;
  if (command.filter_switch == FilterSwitch::on || before.guard != after.guard) return after;
  auto const keep = [](auto& value, auto const& earlier) {
    if (!value) value = earlier;
  };
  keep(after.order, before.order);
  keep(after.share_percent, before.share_percent);
  keep(after.frequency, before.frequency);
  keep(after.quality, before.quality);
  return after;
}

}  // namespace axisc::machine
