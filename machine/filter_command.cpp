#include "machine/filter_command.hpp"

#include <fmt/format.h>

namespace axisc::machine {

std::string to_text(FilterParameters const& parameters) {
  std::string text;
  auto const add = [&text](std::string_view keyword, auto const& value) {
    if (value) text += fmt::format("{}{}={}", text.empty() ? "" : " ", keyword, *value);
  };
  add("ORDER", parameters.order);
  add("SHARE", parameters.share_percent);
  add("FCUT", parameters.frequency ? std::optional(parameters.frequency->value) : std::nullopt);
  add("QUALITY", parameters.quality);
  return text;
}

}  // namespace axisc::machine
