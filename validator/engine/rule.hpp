// The table of rules. A rule checks and reports; the engine decides what is shown.
//
// Each has a folder rules/AXNNNN-name with its row and its check, its pages in both languages and its
// samples; the build finds the folders and makes the table of their rows.
//
// Rules that are switched off do not run. From the findings of the others the engine removes, in this order:
// those that the options disable in the finding's file (see policy.hpp); those that `axisc: allow` comments
// silence; those that another finding on the same subject silences (`silenced_by`); and for each token all
// findings but one (`Precedence`), so that one mistake gives one message. Findings of a default list that
// several axes share are merged.
#pragma once

#include "configuration/machine/machine.hpp"
#include "design/units.hpp"
#include "diagnostics/finding.hpp"
#include "diagnostics/page.hpp"
#include "validator/commands/command_check.hpp"
#include "validator/engine/report.hpp"
#include "validator/loading/loading.hpp"
#include "validator/values/effective_values.hpp"
#include "validator/views/filter_designs.hpp"
#include "validator/views/filter_view.hpp"
#include "validator/views/fir_view.hpp"
#include "validator/views/guard_view.hpp"
#include "validator/views/position_control_view.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace axisc::validator {

/// The context of a rule about one list.
struct ListContext {
  LoadedList const& list;
  SourceText const& source;
  std::optional<design::CycleTime> cycle_time = {};  ///< none where nothing says it
  /// Of the axes that read it; none where nothing says it, or where some are translatory and others are not.
  std::optional<machine::AxisType> axis_type = {};
};

/// The context of a rule about the whole machine: axes, lists, gantries, the machine file's values. A list
/// alone is a machine of one axis.
struct MachineContext {
  LoadedMachine const& machine;
  design::CycleTime cycle_time;  ///< the assumed 1 ms where none is known
  SourceSet const& sources;
};

/// The context of a rule about one channel.
struct GroupContext {
  MachineContext const& whole;
  LoadedGroup const& group;
};

/// The context of a rule about one NC program in one channel.
struct ProgramContext {
  MachineContext const& whole;
  LoadedProgram const& program;
  std::string_view text;     ///< the program's bytes, from which its spans count
  LoadedGroup const* group;  ///< null for a program that no channel runs: a program that is checked alone
};

/// The context of a rule about one command: #FILTER or #VIB GUARD of an NC program, or one of the machine
/// file's filter_sets.
struct CommandContext {
  MachineContext const& whole;
  CheckedCommand const& checked;
  SourceId source;
  std::uint32_t offset;         ///< of the command's text in its source
  std::optional<Span> instead;  ///< used for every span if the source writes the text with escapes

  [[nodiscard]] Place place(Span span) const {
    Span const shifted{.begin = span.begin + offset, .end = span.end + offset};
    return {.source = source, .span = instead.value_or(shifted)};
  }
};

/// The context of a rule about one axis.
struct AxisContext {
  LoadedMachine const& machine;
  std::size_t index;  ///< into LoadedMachine::axes
  std::string const& name;
  machine::AxisType type;
  EffectiveValues const& values;
  design::CycleTime cycle_time;  ///< the assumed 1 ms where none is known
  SourceSet const& sources;
  LoadedList const* default_list;  ///< may be null
  LoadedList const& axis_list;
  std::vector<ReferenceProblem> const& reference_problems;
  std::span<FilterView const> filters;  ///< those that a list touches: see touched_filters()
  FilterDesigns const& designs;         ///< of `filters`
  FirView const& fir;
  GuardView const& guard;
  PositionControlView const& position_control;
};

/// The context of a rule about one standard filter; every filter that a list touches is checked once.
struct FilterContext {
  AxisContext const& axis;
  FilterView const& filter;  ///< one of axis.filters
};

/// Data that a filter rule may need in addition to the values.
enum class Needs : std::uint8_t { nothing = 0, cycle_time = 1 };

using ListCheck = void (*)(ListContext const&, Report&);
using AxisCheck = void (*)(AxisContext const&, Report&);
using FilterCheck = void (*)(FilterContext const&, Report&);
using GroupCheck = void (*)(GroupContext const&, Report&);
using MachineCheck = void (*)(MachineContext const&, Report&);
using ProgramCheck = void (*)(ProgramContext const&, Report&);
using CommandCheck = void (*)(CommandContext const&, Report&);
/// monostate: reported when machine files are read or by the program itself, not by a check.
using Check = std::variant<std::monostate, ListCheck, AxisCheck, FilterCheck, GroupCheck, MachineCheck,
                           ProgramCheck, CommandCheck>;

/// Which of several findings on one token is kept: an error before a warning before a note; then AX1, AX4,
/// AX3, AX2, any other; then the lower code. A row may move its rule within this order.
enum class Precedence : std::uint8_t {
  of_family,      ///< with the other rules of its family
  before_family,  ///< before its family: it names the mistake more precisely
  after_family,   ///< after its family: kept only if nothing else is wrong
  after_text,     ///< directly after AX1
};

/// A rule's row. Its folder's rule.cpp defines it as `axNNNN` in the namespace checks and writes only what
/// differs from the usual.
struct Rule {
  Code code{};                 ///< the table takes it from the folder's name,
  std::string_view name = {};  ///< and this as well
  Severity severity = Severity::error;
  bool always = false;  ///< a note that is reported without `pedantic` as well
  std::string_view control =
      {};  ///< the control's message numbers, "50663/60311/70451"; empty where it has none
  /// Parameters whose values the check looks at, separated by blanks, as the catalogue writes them.
  /// `filters[].order` means the filters of both ports, `ipc.` the family of Improved Position Control, `*`
  /// at the end every ending.
  std::string_view parameters = {};
  /// For a rule that checks every parameter of a kind.
  bool (*about)(schema::Parameter const&) = nullptr;
  Needs needs = Needs::nothing;
  Precedence precedence = Precedence::of_family;
  /// Findings of these rules about one filter or program silence this rule there.
  std::span<Code const> silenced_by = {};
  Check check = {};
  ProgramCheck program_check = nullptr;  ///< for a rule that also checks NC programs
  CommandCheck command_check = nullptr;  ///< for a rule about axes that also checks commands
  ListCheck list_check = nullptr;        ///< for a rule about axes that also checks the lists of other kinds
};

/// codes<3001, 3040>: for the column `silenced_by`.
template <std::uint16_t... numbers>
inline constexpr std::array<Code, sizeof...(numbers)> codes{static_cast<Code>(numbers)...};

/// All rules, in ascending order of codes.
[[nodiscard]] std::span<Rule const> rules();
/// The row of a code; null if there is none. Cost: one table access.
[[nodiscard]] Rule const* find_rule(Code code);
/// The index of a rule in the table.
[[nodiscard]] std::size_t number_of(Rule const& rule);
/// True if the rule looks at the value of the parameter, by `parameters` or by `about`.
[[nodiscard]] bool looks_at(Rule const& rule, schema::Parameter const& parameter);
/// The page that `axisc explain` prints about a rule. Cost: one table access.
[[nodiscard]] Page const& page(Rule const& rule);

}  // namespace axisc::validator
