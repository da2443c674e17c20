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
