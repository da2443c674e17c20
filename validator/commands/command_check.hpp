// From a parsed command of an NC program to its meaning, or to its mistakes.
#pragma once

#include "configuration/machine/filter_command.hpp"
#include "design/kernels/kernel_design.hpp"
#include "design/units.hpp"
#include "diagnostics/finding.hpp"
#include "grammar/nc_command.hpp"
#include "validator/sentences.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::validator {

/// Limits for the keywords of a channel's commands.
struct CommandLimits {
  design::CycleTime cycle_time;
  bool time_delay = false;  ///< an axis of the channel has the FIR time delay, which ends at order 100

  design::Readings readings{};  ///< how the control computes its filters

  [[nodiscard]] std::uint32_t longest_order() const {
    return time_delay ? design::longest_kernel_delay
                      : design::longest_order(design::KernelType::moving_average, readings.kernels);
  }
  [[nodiscard]] design::Hertz nyquist() const {
    return design::as_read(cycle_time, readings.cycle_time).nyquist();
  }
};

/// Whether a value may be a variable of the running program. The value of a variable is unknown before the
/// program runs.
enum class Variables : std::uint8_t { accepted, refused };

/// Something wrong with a command: AX5001, AX5002 for its keywords, or AX3026 for a guard without
/// oscillation. Spans count like those of the command.
struct CommandMistake {
  Code code{};
  Span span;
  Message message;
  std::optional<Message> label;
  std::vector<Message> notes;
  std::vector<Message> help;
  std::optional<Span> first;          ///< first occurrence of a repeated keyword
  std::optional<std::string> better;  ///< the replacement of `span`
  std::string control;                ///< the control's message numbers; empty where none is known
  std::optional<SentenceRef> reaction = says::program_reaction_aborted;  ///< none where it is not documented
  std::string value;  ///< what the control uses instead; empty if unknown
  bool depends_on_cycle_time = false;
};

struct CheckedCommand {
  /// The command with its parameters in canonical form. None for others than these two, and if a value cannot
  /// be used: unreadable, out of range, or a variable. #VIB GUARD without AX_DEV has a tolerance of 0, but
  /// OFF. An ORDER_TIME below one cycle is a mistake and gives order 0.
  std::optional<machine::FilterCommand> command;
  machine::FilterSwitch filter_switch = machine::FilterSwitch::unchanged;  ///< also where there is no command
  bool hsc = false;
  std::vector<CommandMistake> mistakes;
};

/// Checks #FILTER or #VIB GUARD, whose spans count from the start of `text`.
[[nodiscard]] CheckedCommand check_command(grammar::NcCommand const& command, std::string_view text,
                                           CommandLimits const& limits, Variables variables);

/// The text of one command: "#FILTER ON [ORDER=20 SHARE=80]", "#VIB GUARD ON [MODE=2]". Without mistakes
/// there is a command.
[[nodiscard]] CheckedCommand parse_filter_command(std::string_view text, CommandLimits const& limits);

/// True if the command switches FIR filters on, or leaves them on, with an order of its own: ORDER above 0,
/// or ORDER_TIME. This includes values that are reported as mistakes.
[[nodiscard]] bool gives_order(grammar::NcCommand const& command, std::string_view text);

/// True if the command has the keyword HSC: it applies to the HSC filters, not to the FIR filters.
[[nodiscard]] bool means_hsc(grammar::NcCommand const& command, std::string_view text);

/// The keyword of that name; null if the command does not have it.
[[nodiscard]] grammar::Keyword const* find_keyword(grammar::NcCommand const& command, std::string_view text,
                                                   std::string_view name);

}  // namespace axisc::validator
