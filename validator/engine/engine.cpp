#include "validator/engine/engine.hpp"

#include "grammar/axis_list.hpp"
#include "validator/engine/policy.hpp"
#include "validator/engine/precedence.hpp"
#include "validator/engine/suppression.hpp"
#include "validator/views/axis_views.hpp"
#include "validator/views/channel.hpp"

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

namespace axisc::validator::says {

constexpr Sentence assumed_cycle_time{"the NC cycle time is not known; 1 ms was assumed",
                                      "die NC-Zykluszeit ist nicht bekannt; angenommen wurde 1 ms"};
constexpr Sentence help{"`--cycle-time 2ms`, or \"cycle_time_us\" in a machine file, sets it",
                        "`--cycle-time 2ms` oder \"cycle_time_us\" in einer Maschinendatei gibt sie an"};

}  // namespace axisc::validator::says

namespace axisc::validator {
namespace {

/// Whether a rule that needs T has anything to check: an active standard filter, a configured FIR or HSC
/// filter, an enabled Improved Position Control.
bool uses_cycle_time(AxisContext const& axis) {
  for (FilterView const& filter : axis.filters) {
    if (filter.active() || (filter.port == FilterPort::setpoint && filter.is_hsc())) return true;
  }
  return axis.fir.type.value.number != 0 || axis.position_control.enable.value.flag();
}

AxisContext context_of(LoadedMachine const& machine, std::size_t index, AxisViews const& views,
                       design::CycleTime cycle_time, SourceSet const& sources) {
  LoadedAxis const& axis = machine.axes[index];
  return {.machine = machine,
          .index = index,
          .name = axis.name,
          .type = axis.type,
          .values = axis.merged.values,
          .cycle_time = cycle_time,
          .sources = sources,
          .default_list = machine.list_of_defaults(),
          .axis_list = machine.lists[axis.list].list,
          .reference_problems = axis.merged.reference_problems,
          .filters = views.filters,
          .designs = views.designs,
          .fir = views.fir,
          .guard = views.guard,
          .position_control = views.position_control};
}

constexpr Code cycle_time_assumed{9006};

class Engine {
 public:
  Engine(LoadedMachine const& machine, std::deque<AxisViews> const& views, CheckOptions const& options,
         SourceSet const& sources)
      : machine_(machine),
        views_(views),
        policy_(options, sources),
        sources_(sources),
        cycle_time_(machine.cycle_time.value_or(design::CycleTime{})) {
    list_contexts_.reserve(machine.lists.size() + machine.other_lists.size());
    // A bad list yields thousands of findings: reserve once instead of growing.
    std::size_t expected = machine.findings.size();
    for (NamedList const& named : machine.lists) {
      expected += named.list.tree.problems.size() + named.list.line_values.doubtful().size();
    }
    reported_.findings.reserve(expected);
  }

  EngineResult run(FindingSink const& sink) {
    for (Finding const& finding : machine_.findings) {
      Rule const& rule = *find_rule(finding.code);
      if (enabled(rule)) adopt(reported_, rule, finding);
    }
    run_list_checks();
    for (NamedList const& named : machine_.other_lists) run_checks_of_other_list(named.list);
    for (std::size_t axis = 0; axis < machine_.axes.size(); ++axis) run_axis(axis);
    run_machine_checks();
    run_programs();
    run_filter_sets();
    return tell_all(decide(), sink);
  }

 private:
  [[nodiscard]] bool enabled(Rule const& rule) const { return policy_.enabled(rule); }

  /// Calls a check and keeps what it reports.
  template <typename CheckFunction, typename Context>
  void call(Rule const& rule, CheckFunction check, Context const& context, std::string_view axis,
            Subject const* subject) {
    std::size_t const before = reported_.findings.size();
    Report report(reported_, rule, axis);
    check(context, report);
    for (std::size_t i = before; i < reported_.findings.size(); ++i) {
      Reported& finding = reported_.findings[i];
      finding.subject = subject;
      finding.cycle_time_assumed = rule.needs == Needs::cycle_time && !machine_.cycle_time;
      if (!finding.said) continue;
      // The check may have set these itself.
      Finding const& said = *reported_.said[*finding.said];
      finding.axis = said.axis;
      finding.severity = said.severity;
      finding.place = said.place.value_or(finding.place);
    }
  }

  /// By list, the one axis that uses it; empty where several do.
  [[nodiscard]] std::vector<std::string_view> owners() const {
    std::vector<std::string_view> owners(machine_.lists.size());
    std::vector<bool> used(machine_.lists.size());
    if (machine_.default_list) used[*machine_.default_list] = true;
    for (LoadedAxis const& axis : machine_.axes) {
      owners[axis.list] = used[axis.list] ? std::string_view() : axis.name;
      used[axis.list] = true;
    }
    return owners;
  }

  /// None for a list alone that does not say it: its default list may.
  [[nodiscard]] std::optional<machine::AxisType> stated_type(LoadedAxis const& axis) const {
    EffectiveValue const& written = axis.merged.values.at("kenngr.achs_typ");
    bool const is_alone = !machine_.machine_file && !machine_.start_up && !machine_.default_list;
    bool const is_known =
        axis.type != machine::AxisType::translatory || (written.set() ? !written.unusable : !is_alone);
    return is_known ? std::optional(axis.type) : std::nullopt;
  }

  /// By list; see ListContext.
  [[nodiscard]] std::vector<std::optional<machine::AxisType>> axis_types() const {
    std::vector<std::optional<machine::AxisType>> types(machine_.lists.size());
    std::vector<bool> used(machine_.lists.size());
    auto const note = [&](std::size_t list, std::optional<machine::AxisType> type) {
      auto const is_translatory = [](machine::AxisType each) {
        return each == machine::AxisType::translatory;
      };
      bool const agree = types[list] && type && is_translatory(*types[list]) == is_translatory(*type);
      types[list] = !used[list] || agree ? type : std::nullopt;
      used[list] = true;
    };
    for (LoadedAxis const& axis : machine_.axes) {
      auto const type = stated_type(axis);
      note(axis.list, type);
      bool const has_more = machine_.default_list && *machine_.default_list != axis.list;
      if (has_more) note(*machine_.default_list, type);
    }
    if (machine_.default_list && !machine_.knows_all_axes) types[*machine_.default_list].reset();
    return types;
  }

  void run_list_checks() {
    std::vector<std::string_view> const owner_of = owners();
    std::vector<std::optional<machine::AxisType>> const type_of = axis_types();
    for (std::size_t i = 0; i < machine_.lists.size(); ++i) {
      LoadedList const& list = machine_.lists[i].list;
      ListContext const& context = list_contexts_.emplace_back(
          ListContext{list, sources_[list.source], machine_.cycle_time, type_of[i]});
      for (Rule const& rule : rules()) {
        auto const* const check = std::get_if<ListCheck>(&rule.check);
        if (check == nullptr || !policy_.enabled(rule, list.source)) continue;
        call(rule, *check, context, owner_of[i], nullptr);
      }
    }
  }

  /// The catalogues of the other kinds are less complete than that of axis lists: values that contradict them
  /// are warnings.
  void run_checks_of_other_list(LoadedList const& list) {
    ListContext const& context =
        list_contexts_.emplace_back(ListContext{list, sources_[list.source], machine_.cycle_time});
    std::size_t const before = reported_.findings.size();
    for (Rule const& rule : rules()) {
      auto const* const only = std::get_if<ListCheck>(&rule.check);
      ListCheck const check = only != nullptr ? *only : rule.list_check;
      if (check == nullptr || !policy_.enabled(rule, list.source)) continue;
      call(rule, check, context, {}, nullptr);
    }
    for (std::size_t i = before; i < reported_.findings.size(); ++i) {
      Reported& finding = reported_.findings[i];
      bool const contradicts = is_about_values(finding.rule->code) && finding.severity == Severity::error &&
                               list.kind != configuration::ListKind::axis;
      if (contradicts) finding.severity = Severity::warning;
    }
  }

  /// AX2.
  [[nodiscard]] static bool is_about_values(Code code) { return static_cast<unsigned>(code) / 1000 == 2; }

  void run_axis(std::size_t index) {
    AxisContext const& context =
        axis_contexts_.emplace_back(context_of(machine_, index, views_[index], cycle_time_, sources_));
    cycle_time_needed_ = cycle_time_needed_ || uses_cycle_time(context);
    std::vector<Subject const*> subjects;
    subjects.reserve(context.filters.size());
    for (FilterView const& filter : context.filters) {
      subjects.push_back(&subjects_.emplace_back(
          Subject{.axis = index, .port = filter.port, .filter = filter.index, .program = {}}));
    }
    for (Rule const& rule : rules()) {
      if (!enabled(rule)) continue;
      if (auto const* const check = std::get_if<AxisCheck>(&rule.check)) {
        call(rule, *check, context, context.name, nullptr);
      } else if (auto const* const filter_check = std::get_if<FilterCheck>(&rule.check)) {
        for (std::size_t i = 0; i < context.filters.size(); ++i) {
          call(rule, *filter_check, FilterContext{.axis = context, .filter = context.filters[i]},
               context.name, subjects[i]);
        }
      }
    }
  }

  void run_machine_checks() {
    MachineContext const whole{.machine = machine_, .cycle_time = cycle_time_, .sources = sources_};
    for (Rule const& rule : rules()) {
      if (!enabled(rule)) continue;
      if (auto const* const check = std::get_if<MachineCheck>(&rule.check)) {
        call(rule, *check, whole, {}, nullptr);
      } else if (auto const* const group_check = std::get_if<GroupCheck>(&rule.check)) {
        for (LoadedGroup const& group : machine_.groups) {
          call(rule, *group_check, GroupContext{.whole = whole, .group = group}, {}, nullptr);
        }
      }
    }
  }

  /// The channels that run a program; null for a program that no channel runs.
  [[nodiscard]] std::vector<LoadedGroup const*> groups_of(std::size_t program) const {
    std::vector<LoadedGroup const*> groups;
    for (LoadedGroup const& group : machine_.groups) {
      bool const runs =
          std::find(group.programs.begin(), group.programs.end(), program) != group.programs.end();
      if (runs) groups.push_back(&group);
    }
    if (groups.empty()) groups.push_back(nullptr);
    return groups;
  }

  [[nodiscard]] CommandLimits limits_of(LoadedGroup const* group) const {
    CommandLimits limits{.cycle_time = cycle_time_, .readings = machine_.readings};
    if (group != nullptr) limits.time_delay = has_time_delay(machine_, *group);
    return limits;
  }

  void run_programs() {
    MachineContext const whole{.machine = machine_, .cycle_time = cycle_time_, .sources = sources_};
    for (std::size_t index = 0; index < machine_.programs.size(); ++index) {
      LoadedProgram const& program = machine_.programs[index];
      std::string_view const text = sources_[program.source].bytes();
      Subject const& subject = subjects_.emplace_back(
          Subject{.axis = 0, .port = FilterPort::setpoint, .filter = 0, .program = index});
      for (LoadedGroup const* const group : groups_of(index)) {
        for (grammar::NcCommand const& command : program.tree.commands) {
          if (command.kind == grammar::CommandKind::axis_exchange) continue;
          CheckedCommand const checked = check_command(command, text, limits_of(group), Variables::accepted);
          run_command(
              {.whole = whole, .checked = checked, .source = program.source, .offset = 0, .instead = {}});
          note_cycle_time(command, text);
        }
        ProgramContext const context{.whole = whole, .program = program, .text = text, .group = group};
        for (Rule const& rule : rules()) {
          auto const* const only = std::get_if<ProgramCheck>(&rule.check);
          ProgramCheck const check = only != nullptr ? *only : rule.program_check;
          if (check != nullptr && enabled(rule)) call(rule, check, context, {}, &subject);
        }
      }
    }
  }

  void run_filter_sets() {
    MachineContext const whole{.machine = machine_, .cycle_time = cycle_time_, .sources = sources_};
    std::vector<LoadedGroup const*> groups{nullptr};
    for (LoadedGroup const& group : machine_.groups) groups.push_back(&group);
    for (configuration::LocatedText const& set : machine_.filter_sets) {
      Span const quoted = set.place.span;
      bool const plain = quoted.size() == set.text.size() + 2;
      for (LoadedGroup const* const group : groups) {
        CheckedCommand const checked = parse_filter_command(set.text, limits_of(group));
        run_command({.whole = whole,
                     .checked = checked,
                     .source = set.place.source,
                     .offset = quoted.begin + 1,
                     .instead = plain ? std::nullopt : std::optional(quoted)});
        run_program_checks_of_set(set, group, plain ? quoted.begin + 1 : 0,
                                  plain ? std::nullopt : std::optional(quoted));
      }
      if (auto const command = grammar::parse_nc_command(set.text)) note_cycle_time(*command, set.text);
    }
  }

  /// Rules that check NC programs together with lists see a command of the machine file as a program of one
  /// line.
  void run_program_checks_of_set(configuration::LocatedText const& set, LoadedGroup const* group,
                                 std::uint32_t offset, std::optional<Span> instead) {
    auto const command = grammar::parse_nc_command(set.text);
    if (!command) return;
    LoadedProgram program;
    program.source = set.place.source;
    program.tree.commands.push_back(*command);
    MachineContext const whole{.machine = machine_, .cycle_time = cycle_time_, .sources = sources_};
    ProgramContext const context{.whole = whole, .program = program, .text = set.text, .group = group};
    std::size_t const before = reported_.findings.size();
    for (Rule const& rule : rules()) {
      if (rule.program_check != nullptr && enabled(rule)) {
        call(rule, rule.program_check, context, {}, nullptr);
      }
    }
    for (std::size_t i = before; i < reported_.findings.size(); ++i) {
      Span& span = reported_.findings[i].place.span;
      span = instead.value_or(Span{.begin = span.begin + offset, .end = span.end + offset});
    }
  }

  void run_command(CommandContext const& context) {
    if (context.checked.mistakes.empty()) return;
    for (Rule const& rule : rules()) {
      auto const* const only = std::get_if<CommandCheck>(&rule.check);
      CommandCheck const check = only != nullptr ? *only : rule.command_check;
      if (check != nullptr && enabled(rule)) call(rule, check, context, {}, nullptr);
    }
  }

  void note_cycle_time(grammar::NcCommand const& command, std::string_view text) {
    bool const uses = command.kind == grammar::CommandKind::filter &&
                      (find_keyword(command, text, "ORDER_TIME") != nullptr ||
                       find_keyword(command, text, "FCUT") != nullptr);
    cycle_time_needed_ = cycle_time_needed_ || uses;
  }

  /// The findings that are kept, in output order.
  [[nodiscard]] Standing decide() {
    Suppressions suppressions;
    for (NamedList const& list : machine_.lists) {
      suppressions.add(sources_, list.list.source, list.list.tree.directives);
    }
    for (LoadedProgram const& program : machine_.programs) {
      suppressions.add(sources_, program.source, program.tree.directives);
    }
    for (NamedList const& list : machine_.other_lists) {
      suppressions.add(sources_, list.list.source, list.list.tree.directives);
    }
    Standing standing;
    standing.reserve(reported_.findings.size());
    admit(0, standing, [&](Reported const& finding) {
      return !suppressions.silences(finding.rule->code, finding.place, sources_);
    });
    report_unused(suppressions, standing);
    drop_replaced(reported_, standing);
    put_in_order(reported_, standing);
    merge_shared(reported_, standing);
    keep_highest_per_token(reported_, standing);
    put_in_output_order(reported_, standing);
    return standing;
  }

  /// Keeps those findings from `first` on that the options and then `wanted` accept, and sets their severity.
  template <typename Wanted>
  void admit(std::size_t first, Standing& standing, Wanted wanted) {
    for (std::size_t number = first; number < reported_.findings.size(); ++number) {
      Reported& finding = reported_.findings[number];
      if (!policy_.enabled(*finding.rule, finding.place.source) || !wanted(finding)) continue;
      finding.severity = policy_.severity(finding.rule->code, finding.severity);
      if (!policy_.shows(*finding.rule, finding.severity)) continue;
      standing.push_back(static_cast<std::uint32_t>(number));
    }
  }

  void report_unused(Suppressions& suppressions, Standing& standing) {
    if (!enabled(*find_rule(Code{1013}))) return;
    std::size_t const before = reported_.findings.size();
    suppressions.report_unused(
        sources_, [this](Code code, SourceId source) { return policy_.enabled(*find_rule(code), source); },
        reported_);
    admit(before, standing, [](Reported const&) { return true; });
  }

  /// Reported even without `pedantic`: all other findings depend on it.
  [[nodiscard]] Finding assumed_cycle_time() const {
    Finding finding = new_finding(*find_rule(cycle_time_assumed));
    finding.severity = policy_.severity(finding.code, finding.severity);
    finding.file = machine_.path;
    finding.message = {says::assumed_cycle_time};
    finding.help.push_back({says::help});
    return finding;
  }

  EngineResult tell_all(Standing const& standing, FindingSink const& sink) {
    EngineResult result{.has_errors = false,
                        .cycle_time_assumed = cycle_time_needed_ && !machine_.cycle_time};
    if (result.cycle_time_assumed && !policy_.disables(cycle_time_assumed, machine_.path)) {
      Finding assumed = assumed_cycle_time();
      result.has_errors = assumed.severity == Severity::error;
      sink(assumed);
    }
    for (std::uint32_t const number : standing) {
      Reported const& finding = reported_.findings[number];
      result.has_errors = result.has_errors || finding.severity == Severity::error;
      Finding told = tell(reported_, finding);
      if (is_in_other_list(finding.place.source) && !mends_name(told.code)) told.fix.reset();
      if (told.fix && edits_translation(*told.fix)) told.fix.reset();
      sink(told);
    }
    return result;
  }

  [[nodiscard]] bool is_in_other_list(SourceId source) const {
    return std::any_of(machine_.other_lists.begin(), machine_.other_lists.end(),
                       [source](NamedList const& list) { return list.list.source == source; });
  }

  /// A list in XML is shown, not edited.
  [[nodiscard]] bool edits_translation(Fix const& fix) const {
    return std::any_of(fix.edits.begin(), fix.edits.end(),
                       [this](Edit const& edit) { return sources_[edit.place.source].is_translation(); });
  }

  /// In lists of other kinds only names are corrected: too little is known about the rest.
  [[nodiscard]] static bool mends_name(Code code) { return code == Code{2001}; }

  LoadedMachine const& machine_;
  std::deque<AxisViews> const& views_;
  Policy policy_;
  SourceSet const& sources_;
  design::CycleTime cycle_time_;
  bool cycle_time_needed_ = false;
  // Findings refer to these until they are output.
  std::vector<ListContext> list_contexts_;  ///< one per list
  std::deque<AxisContext> axis_contexts_;
  std::deque<Subject> subjects_;
  ReportedFindings reported_;
};

}  // namespace

EngineResult run_rules(LoadedMachine const& machine, std::deque<AxisViews> const& views,
                       CheckOptions const& options, SourceSet const& sources, FindingSink const& sink) {
  return Engine(machine, views, options, sources).run(sink);
}

}  // namespace axisc::validator
