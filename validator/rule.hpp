// One table of rules. A rule looks and reports; the engine decides what is shown.
//
// Rules that are switched off are not asked. The engine takes out of what the others report, in this order: what
// the options disable in the finding's file (see policy.hpp); what `axisc: allow` comments silence; what another finding on the same subject silences (`silenced_by`); and for each token
// all but the finding of the highest rank, so that one mistake gives one message (a warning never hides an error; within one severity AX1, AX4, AX3,
// AX2002/2003/2004/2007/2015, AX2005; inside AX3 range errors before unused or rounded; else the lower code).
// Findings of a default list that several axes share are merged.
#pragma once

#include "design/units.hpp"
#include "diagnostics/finding.hpp"
#include "validator/command_check.hpp"
#include "validator/effective_values.hpp"
#include "validator/filter_designs.hpp"
#include "validator/filter_view.hpp"
#include "validator/fir_view.hpp"
#include "validator/loading.hpp"
#include "validator/machine.hpp"
#include "validator/position_control_view.hpp"
#include "validator/report.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace axisc::validator {

/// What a rule about one list sees.
struct ListContext {
  LoadedList const& list;
  SourceText const& source;
};

/// What a rule about the whole machine sees: axes, lists, gantries, the machine file's values. A list alone is a
/// machine of one axis.
struct MachineContext {
  LoadedMachine const& machine;
  design::CycleTime cycle_time;  ///< the assumed 1 ms where none is known
  SourceSet const& sources;
};

/// What a rule about one channel sees.
struct GroupContext {
  MachineContext const& whole;
  LoadedGroup const& group;
};

/// What a rule about one NC program in one channel sees.
struct ProgramContext {
  MachineContext const& whole;
  LoadedProgram const& program;
  std::string_view text;     ///< the program's bytes, from which its spans count
  LoadedGroup const* group;  ///< null for a program that no channel runs: one that is checked alone
};

/// What a rule about one command sees: #FILTER or #VIB GUARD of an NC program, or one of the machine file's filter_sets.
struct CommandContext {
  MachineContext const& whole;
  CheckedCommand const& checked;
  SourceId source;
  std::uint32_t offset;         ///< of the command's text in its source
  std::optional<Span> instead;  ///< stands for every span, where the source spells the text with escapes

  [[nodiscard]] Place place(Span span) const {
    Span const shifted{.begin = span.begin + offset, .end = span.end + offset};
    return {.source = source, .span = instead.value_or(shifted)};
  }
};

/// What a rule about one axis sees.
struct AxisContext {
  LoadedMachine const& machine;
  std::size_t index;  ///< into LoadedMachine::axes
  std::string const& name;
  AxisType type;
  EffectiveValues const& values;
  design::CycleTime cycle_time;  ///< the assumed 1 ms where none is known
  SourceSet const& sources;
  LoadedList const* default_list;  ///< may be null
  LoadedList const& axis_list;
  std::vector<ReferenceProblem> const& reference_problems;
  std::span<FilterView const> filters;  ///< those that a list touches: see touched_filters()
  FilterDesigns const& designs;         ///< of these
  FirView const& fir;
  PositionControlView const& position_control;
};

/// What a rule about one standard filter sees; every filter that a list touches is shown once.
struct FilterContext {
  AxisContext const& axis;
  FilterView const& filter;  ///< one of axis.filters
};

/// What a filter rule may need beside the values.
enum class Needs : std::uint8_t { nothing = 0, cycle_time = 1 };

using ListCheck = void (*)(ListContext const&, Report&);
using AxisCheck = void (*)(AxisContext const&, Report&);
using FilterCheck = void (*)(FilterContext const&, Report&);
using GroupCheck = void (*)(GroupContext const&, Report&);
using MachineCheck = void (*)(MachineContext const&, Report&);
using ProgramCheck = void (*)(ProgramContext const&, Report&);
using CommandCheck = void (*)(CommandContext const&, Report&);
/// monostate: reported by the reading of machine files or by the program itself, not by a check.
using Check = std::variant<std::monostate, ListCheck, AxisCheck, FilterCheck, GroupCheck, MachineCheck,
                           ProgramCheck, CommandCheck>;

struct Rule {
  Code code{};
  std::string_view name;
  Severity severity = Severity::error;
  std::string_view control;  ///< the control's message numbers, "50663/60311/70451"; empty where it has none
  Needs needs = Needs::nothing;
  std::span<Code const>
      silenced_by;  ///< for the same filter or program: when one of these was reported, this rule says nothing
  Check check;
  ProgramCheck program_check = nullptr;  ///< for a rule that looks at NC programs as well
};

/// codes<3001, 3040>: for the column `silenced_by`.
template <std::uint16_t... numbers>
inline constexpr std::array<Code, sizeof...(numbers)> codes{static_cast<Code>(numbers)...};

/// All rules, by rising code.
[[nodiscard]] std::span<Rule const> rules();
/// Those with a check of one of the given kinds.
template <typename... Checks>
[[nodiscard]] std::span<Rule const* const> rules_with();
template <>
std::span<Rule const* const> rules_with<ListCheck>();
template <>
std::span<Rule const* const> rules_with<AxisCheck, FilterCheck>();
template <>
std::span<Rule const* const> rules_with<MachineCheck, GroupCheck>();
/// The row of a code; null when there is none.
[[nodiscard]] Rule const* find_rule(Code code);

}  // namespace axisc::validator
