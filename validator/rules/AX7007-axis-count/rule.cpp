#include "validator/engine/rule.hpp"

#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::says {

constexpr Sentence headline{"`{parameter}` is {number}, but the list configures {configured}",
                            "`{parameter}` ist {number}, die Liste konfiguriert aber {configured}"};
constexpr Sentence outside{"`{parameter}` is {number}; allowed are 0 to {limit}",
                           "`{parameter}` ist {number}; zulässig sind 0 bis {limit}"};
constexpr Sentence reaction{"it reports that the number of axes is wrong",
                            "sie meldet, dass die Anzahl der Achsen falsch ist"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

// Message numbers of the control.
constexpr std::string_view out_of_range = "20427";
constexpr std::string_view not_as_configured = "20428";

constexpr std::uint32_t most_axes = 32;
constexpr std::uint32_t most_spindles = 6;

void check_count(std::string_view parameter, std::optional<configuration::ListCount> const& count,
                 std::size_t configured, std::uint32_t limit, Report& report) {
  if (!count || (count->number == configured && count->number <= limit)) return;
  std::vector<Argument> arguments{{"parameter", std::string(parameter)},
                                  {"number", std::to_string(count->number)}};
  bool const outside = count->number > limit;
  arguments.push_back(outside ? Argument{"limit", std::to_string(limit)}
                              : Argument{"configured", std::to_string(configured)});
  Finding& finding =
      report.add(count->place, {outside ? says::outside : says::headline, std::move(arguments)});
  react(finding, outside ? out_of_range : not_as_configured, {says::reaction, {}});
}

void axis_count(MachineContext const& context, Report& report) {
  if (!context.machine.start_up) return;
  for (StartUpChannel const& channel : context.machine.start_up->channels) {
    configuration::ChannelList const& list = channel.list;
    check_count("gruppe[0].achs_anzahl", list.axis_count, list.axes.size(), most_axes, report);
    check_count("spdl_anzahl", list.spindle_count, list.spindles.size(), most_spindles, report);
  }
}

}  // namespace

extern constinit Rule const ax7007{
    .code = Code{7007},
    .name = "axis-count",
    .control = control_numbers<out_of_range, not_as_configured>,
    .check = axis_count,
};

}  // namespace axisc::validator::checks
