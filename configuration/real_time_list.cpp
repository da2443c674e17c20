#include "configuration/real_time_list.hpp"

#include "configuration/listed_values.hpp"
#include "configuration/machine_file.hpp"
#include "configuration/sentences.hpp"
#include "diagnostics/ascii.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace axisc::configuration {
namespace {

constexpr std::string_view interpolation_function = "task_int";
constexpr std::uint64_t nanoseconds_per_us = 1000;

}  // namespace

RealTimeList read_real_time_list(SourceText const& text, SourceId source, std::deque<Finding>& findings) {
  std::map<std::uint32_t, ListedValue const*> cycles;
  ListedValue const* chosen = nullptr;
  std::optional<std::uint32_t> thread;
  std::vector<ListedValue> const values = listed_values(text, source);
  for (ListedValue const& listed : values) {
    if (match_name(listed.name, "cycle_time")) chosen = &listed;
    if (auto const cycle = match_name(listed.name, "thread[].cycle")) cycles[(*cycle)[0]] = &listed;
    auto const function = match_name(listed.name, "thread[].function[].name");
    if (function && ascii::equal_ignoring_case(listed.value.text, interpolation_function)) {
      thread = (*function)[0];
    }
  }
  if (thread && cycles.contains(*thread)) chosen = cycles[*thread];
  if (chosen == nullptr) return {};
  auto const number = as_number(chosen->value);
  if (!number) return {};
  auto const cycle_time = possible_cycle_time(*number * nanoseconds_per_us);
  if (!cycle_time) {
    Finding& finding = findings.emplace_back();
    finding.code = machine_file_code;
    finding.place = chosen->value.place;
    finding.message = {says::json_cycle_time, {{"value", std::to_string(*number)}}};
    return {};
  }
  return {.cycle_time = *cycle_time, .place = chosen->value.place};
}

}  // namespace axisc::configuration
