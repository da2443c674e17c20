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
#include "validator/views/position_control_view.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace axisc::validator {

/// The context of a rule about one list.
struct ListContext {
  LoadedList const& list;
  SourceText const& source;
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
  Code code{};
  std::string_view name = {};  ///< as in the folder's name
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
  ListCheck list_check = nullptr;        ///< for a rule about axes that also checks the lists of other kinds
};

/// codes<3001, 3040>: for the column `silenced_by`.
template <std::uint16_t... numbers>
inline constexpr std::array<Code, sizeof...(numbers)> codes{static_cast<Code>(numbers)...};

/// Rules in ascending order of codes: all, or those with a check of certain kinds.
class RuleRange {
 public:
  /// One bit for each alternative of Check.
  using Kinds = std::uint32_t;
  static constexpr Kinds all_kinds = ~Kinds{0};
  template <typename SomeCheck>
  static constexpr Kinds kind = Kinds{1} << Check(SomeCheck{}).index();

  class Iterator {
   public:
    Iterator(Rule const* const* at, Rule const* const* last, Kinds kinds)
        : at_(at), last_(last), kinds_(kinds) {
      skip();
    }
    Rule const& operator*() const { return **at_; }
    Iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    friend bool operator==(Iterator const& left, Iterator const& right) { return left.at_ == right.at_; }

   private:
    void skip() {
      while (at_ != last_ && (kinds_ >> (*at_)->check.index() & 1U) == 0) ++at_;
    }

    Rule const* const* at_;
    Rule const* const* last_;
    Kinds kinds_;
  };

  RuleRange(std::span<Rule const* const> table, Kinds kinds) : table_(table), kinds_(kinds) {}
  [[nodiscard]] Iterator begin() const { return {table_.data(), last(), kinds_}; }
  [[nodiscard]] Iterator end() const { return {last(), last(), kinds_}; }
  [[nodiscard]] RuleRange with(Kinds kinds) const { return {table_, kinds_ & kinds}; }
  /// The rules of the whole table.
  [[nodiscard]] std::size_t table_size() const { return table_.size(); }

 private:
  [[nodiscard]] Rule const* const* last() const { return table_.data() + table_.size(); }

  std::span<Rule const* const> table_;
  Kinds kinds_;
};

/// All rules.
[[nodiscard]] RuleRange rules();
/// The rules with a check of one of the given kinds. Cost: linear in the table.
template <typename... Checks>
[[nodiscard]] RuleRange rules_with() {
  return rules().with((RuleRange::kind<Checks> | ...));
}
/// The row of a code; null if there is none. Cost: one table access.
[[nodiscard]] Rule const* find_rule(Code code);
/// The index of a rule in the table.
[[nodiscard]] std::size_t number_of(Rule const& rule);
/// True if the rule looks at the value of the parameter, by `parameters` or by `about`.
[[nodiscard]] bool looks_at(Rule const& rule, schema::Parameter const& parameter);
/// The page that `axisc explain` prints about a rule. Cost: one table access.
[[nodiscard]] Page const& page(Rule const& rule);

}  // namespace axisc::validator
