#include "validator/building/machine_build.hpp"

#include "configuration/machine/guards.hpp"
#include "configuration/machine/interface_filter.hpp"
#include "validator/views/axis_dynamics.hpp"
#include "validator/views/channel.hpp"
#include "validator/views/delay_budget.hpp"
#include "validator/views/drive.hpp"
#include "validator/views/fir_view.hpp"
#include "validator/views/hsc_view.hpp"
#include "validator/views/interface_filter_time.hpp"
#include "validator/views/position_control_view.hpp"
#include "validator/views/uncomputed.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace axisc::validator::says {

constexpr Sentence not_compiled_filter{
    "the filter `{filter}` of axis \"{axis}\", whose values cannot be used",
    "der Filter `{filter}` der Achse „{axis}“, dessen Werte nicht verwendbar sind"};

constexpr Sentence not_compiled_guard{
    "the Vibration Guard that the commands of its channel ask of axis \"{axis}\"",
    "der Vibration Guard, den die Befehle ihres Kanals von der Achse „{axis}“ verlangen"};

}  // namespace axisc::validator::says

namespace axisc::validator {
namespace {

class AxisBuilder {
 public:
  AxisBuilder(LoadedMachine const& machine, LoadedAxis const& axis, AxisViews const& views,
              SourceSet const& sources, std::vector<NotCompiled>& not_compiled)
      : machine_(machine),
        axis_(axis),
        views_(views),
        values_(axis.merged.values),
        sources_(sources),
        not_compiled_(not_compiled),
        cycle_time_(machine.cycle_time.value_or(design::CycleTime{})) {}

  machine::AxisConfiguration build() {
    machine::AxisConfiguration result;
    result.name = axis_.name;
    result.number = static_cast<std::uint32_t>(number("kopf.achs_nr"));
    result.type = axis_.type;
    result.drive_path = drive_path(axis_, cycle_time_, DelayState::at_start);
    result.fed_forward_path = drive_path(axis_, cycle_time_, DelayState::fed_forward);
    result.position_window = number("kenngr.filter_position_window");
    result.velocity_limit = number("getriebe[].dynamik.vb_max");
    result.acceleration_limit = number("getriebe[].dynamik.a_max");
    result.transition_weight = number("getriebe[].dynamik.a_trans_weight");
    result.dynamics = axis_dynamics(values_);
    result.uncomputed = uncomputed_parameters(values_, sources_);
    add_filters(result);
    add_kernel(result);
    add_position_control(result);
    result.drive_scaling = drive_scaling();
    add_values(result);
    return result;
  }

 private:
  [[nodiscard]] double number(std::string_view pattern) const { return values_.at(pattern).value.number; }

  void leave_out(EffectiveValue const& value, SentenceRef text, std::vector<Argument> arguments) {
    Place const fallback{.source = machine_.lists[axis_.list].list.source, .span = {}};
    Place const place = value.value_place() ? *value.value_place() : value.name_place().value_or(fallback);
    arguments.push_back({.name = "axis", .value = axis_.name});
    not_compiled_.push_back({.place = place, .feature = {text, std::move(arguments)}});
  }

  /// An error about it was suppressed, but the filter must not be left out silently.
  void leave_out_filter(EffectiveValue const& value, std::string name) {
    leave_out(value, says::not_compiled_filter, {{.name = "filter", .value = std::move(name)}});
  }

  void add_filters(machine::AxisConfiguration& result) {
    EffectiveValue const& interface = values_.at("lr_param.add_interface.enable");
    for (FilterView const& filter : views_.filters) {
      bool const setpoint = filter.port == FilterPort::setpoint;
      if (!setpoint && interface.unusable) leave_out_filter(interface, "lr_param.add_interface");
      if ((!setpoint && !interface.value.flag()) || is_configured_hsc(filter)) continue;
      auto const& specification = views_.designs.specification(filter);
      if (specification) {
        auto& filters = setpoint ? result.filters : result.interface_filters;
        filters.push_back({.index = filter.index, .specification = *specification});
      } else if (filter.unusable() || (filter.enable.value.flag() && filter.order.value.number > 0)) {
        std::string name = setpoint ? "filter[" : "lr_param.add_interface.filter[";
        name.append(std::to_string(filter.index)).append("]");
        leave_out_filter(filter.anchor(filter.enable), std::move(name));
      }
    }
    add_interface_filter_time(result, interface);
  }

  void add_interface_filter_time(machine::AxisConfiguration& result, EffectiveValue const& interface) {
    EffectiveValue const& time = values_.at(interface_filter_time_name);
    bool const is_off = !time.unusable && !(time.value.number > 0);
    if (is_off) return;
    if (interface.unusable) return leave_out_filter(interface, "lr_param.add_interface");
    if (!interface.value.flag()) return;
    auto const specification = interface_filter_time(values_, cycle_time_);
    if (specification && result.interface_filters.empty()) {
      result.interface_filters.push_back(
          {.index = machine::interface_filter_time, .specification = *specification});
    } else {
      leave_out_filter(time, std::string(interface_filter_time_name));
    }
  }

  void add_kernel(machine::AxisConfiguration& result) {
    for (FilterView const& filter : configured_hsc(views_.filters)) add_hsc(filter, result);
    FirView const& fir = views_.fir;
    if (!fir.configured() && !fir.type.unusable && !fir.has_unknown_type()) return add_guard(result);
    auto const specification = fir.specification(cycle_time_);
    if (specification && !result.kernel) {
      result.kernel = machine::ConfiguredKernel{.family = machine::KernelFamily::fir,
                                                .index = 0,
                                                .specification = *specification,
                                                .on_at_start = fir.enable.value.flag()};
    } else {
      leave_out_filter(fir.anchor(fir.enable), "filter_fir");
    }
  }

  void add_guard(machine::AxisConfiguration& result) {
    GuardView const& guard = views_.guard;
    result.listed_guard = guard.specification(cycle_time_);
    if (!guard.is_active() && !guard.active.unusable) return;
    auto const& specification = result.listed_guard;
    bool const fits = specification && can_be_compiled(*specification, cycle_time_);
    if (fits && !result.kernel && !guard.active.unusable) {
      result.kernel = machine::ConfiguredKernel{.family = machine::KernelFamily::guard,
                                                .index = 0,
                                                .specification = *specification,
                                                .on_at_start = true};
    } else {
      leave_out_filter(guard.anchor(guard.frequency), "vib_guard");
    }
  }

  void add_hsc(FilterView const& filter, machine::AxisConfiguration& result) {
    // NoVib without an order is never active, and has been reported.
    if (hsc_type(filter) == HscType::novib && resulting_hsc_order(filter, cycle_time_) == 0) return;
    auto const specification = hsc_kernel(filter, cycle_time_);
    if (specification && filter.index == 0) {
      result.kernel = machine::ConfiguredKernel{.family = machine::KernelFamily::hsc,
                                                .index = filter.index,
                                                .specification = *specification,
                                                .on_at_start = false};
    } else {
      leave_out_filter(filter.anchor(filter.prototype), "filter[" + std::to_string(filter.index) + "]");
    }
  }

  void add_position_control(machine::AxisConfiguration& result) {
    PositionControlView const& view = views_.position_control;
    machine::PositionControl control;
    control.limit_factor = view.limit.value.number;
    if (view.enable.unusable && !view.stages.empty()) {
      leave_out_filter(view.enable, "lr_param.improved_position_control");
      return;
    }
    if (!view.enabled()) return;
    for (StageView const& stage : view.stages) {
      if (!stage.mode.unusable && stage.mode.value.number == 0) continue;
      auto built = build_stage(stage);
      if (!built) {
        leave_out_filter(stage.mode,
                         "lr_param.improved_position_control.stage[" + std::to_string(stage.index) + "]");
        return;
      }
      control.stages.push_back(*std::move(built));
    }
    if (!control.stages.empty()) result.position_control = std::move(control);
  }

  /// None if a value is out of its range.
  [[nodiscard]] std::optional<machine::PositionControlStage> build_stage(StageView const& stage) const {
    if (!stage.active_mode()) return std::nullopt;
    machine::PositionControlStage built;
    built.index = stage.index;
    built.mode = *stage.active_mode();
    built.weight_numerator = stage.weight_numerator.value.number;
    built.weight_denominator = stage.weight_denominator.value.number;
    auto const bandpass = stage.bandpass();
    if (!bandpass || !(built.weight_numerator > 0) || !(built.weight_denominator > 0)) return std::nullopt;
    for (StageFilterView const& filter : stage.filters()) {
      auto const specification = stage_filter(filter);
      if (!specification) return std::nullopt;
      built.filters.push_back(*specification);
    }
    if (!stage.simulates()) return built;
    double const damping = stage.damping().value.number;
    if (stage.damping().unusable || !(damping > 0 && damping < 1)) return std::nullopt;
    built.oscillator = design::OscillatorSpecification{
        .frequency = {bandpass->frequency.value.number},
        .damping = damping,
    };
    return built;
  }

  /// P-AXIS-00848. Decisions of the filter mathematics where it does not exist: the band-pass of the older
  /// spelling has the Butterworth prototype, the all-pass Bessel's.
  [[nodiscard]] static design::Prototype prototype_of(StageFilterView const& filter) {
    if (filter.kind == StageFilterType::allpass) return design::Prototype::bessel;
    if (filter.prototype == nullptr || filter.prototype->value.text == "BUTTERWORTH") {
      return design::Prototype::butterworth;
    }
    return filter.prototype->value.text == "BESSEL" ? design::Prototype::bessel
                                                    : design::Prototype::critical_damping;
  }

  [[nodiscard]] std::optional<design::FilterSpecification> stage_filter(StageFilterView const& filter) const {
    constexpr double highest_order = 3;
    bool const bandpass = filter.kind == StageFilterType::bandpass;
    double const order = filter.order.value.number;
    bool const usable = !filter.order.unusable && !filter.frequency.unusable &&
                        !(bandpass && (filter.quality.unusable ||
                                       (filter.prototype != nullptr && filter.prototype->unusable)));
    if (!usable || !(order >= 1 && order <= highest_order)) return std::nullopt;
    design::FilterSpecification specification;
    specification.type = bandpass ? design::FilterType::bandpass : design::FilterType::allpass;
    specification.prototype = prototype_of(filter);
    specification.order = static_cast<std::uint32_t>(order);
    specification.frequency = {filter.frequency.value.number};
    if (bandpass) specification.quality = filter.quality.value.number;
    return design::is_in_range(specification, cycle_time_) ? std::optional(specification) : std::nullopt;
  }

  [[nodiscard]] machine::DriveScaling drive_scaling() const {
    return {.controller = position_controller(axis_),
            .v_reso_num = number("antr.v_reso_num"),
            .v_reso_denom = number("antr.v_reso_denom"),
            .time_base = static_cast<std::uint32_t>(number("antr.v_time_base")),
            .multi_gain_z = number("getriebe[].multi_gain_z"),
            .multi_gain_n = number("getriebe[].multi_gain_n")};
  }

  void add_values(machine::AxisConfiguration& result) const {
    auto const set_values = values_.set_values();
    result.values.reserve(set_values.size());
    for (EffectiveValue const* const set : set_values) {
      EffectiveValue const& value = *set;
      if (!value.value_place()) continue;
      std::size_t const list = value.origin == Origin::default_list ? *machine_.default_list : axis_.list;
      SourceText const& source = sources_[value.value_place()->source];
      result.values.push_back({.name = parameter_name(value),
                               .text = source.utf8(value.value_place()->span),
                               .list = static_cast<std::uint32_t>(list),
                               .line = value.line - source.lines_before()});
    }
  }

  LoadedMachine const& machine_;
  LoadedAxis const& axis_;
  AxisViews const& views_;
  EffectiveValues const& values_;
  SourceSet const& sources_;
  std::vector<NotCompiled>& not_compiled_;
  design::CycleTime cycle_time_;
};

machine::StoredContent stored_content(LoadedProgram const& program, configuration::Files& files) {
  return {
      .size = program.mark.bytes,
      .read = [&files, path = program.path, mark = program.mark](machine::ContentReceiver const& receive) {
        read_program_again(files, path, mark, [&receive](std::string_view piece) {
          receive(piece);
          return true;
        });
      }};
}

/// The guards of commands; one that no runtime takes was reported, or is left out with a word.
void add_guards(std::size_t group_index, LoadedMachine const& loaded, BuiltMachine& built) {
  machine::MachineGroup const& group = built.machine.groups[group_index];
  auto const is_guard = [](machine::FilterParameters const& set) { return set.guard; };
  if (std::none_of(group.filter_sets.begin(), group.filter_sets.end(), is_guard)) return;
  machine::add_guards(built.machine, group_index);
  for (std::size_t const index : group.axes) {
    machine::AxisConfiguration const& axis = built.machine.axes[index];
    if (axis.type == machine::AxisType::spindle) continue;
    bool fits = axis.kernel && axis.kernel->family == machine::KernelFamily::guard;
    for (machine::FilterParameters const& set : group.filter_sets) {
      if (!fits || !set.guard) continue;
      auto const guard = guard_after(axis.kernel->specification, set);
      fits = guard && can_be_compiled(*guard, built.machine.cycle_time);
    }
    if (fits) continue;
    Place const place{.source = loaded.lists[loaded.axes[index].list].list.source, .span = {}};
    built.not_compiled.push_back(
        {.place = place, .feature = {says::not_compiled_guard, {{"axis", axis.name}}}});
  }
}

}  // namespace

BuiltMachine build_machine(LoadedMachine const& loaded, std::deque<AxisViews> const& views,
                           SourceSet const& sources, configuration::Files& files) {
  BuiltMachine built;
  built.machine.name = loaded.name;
  built.machine.inch = loaded.inch;
  built.machine.motion = loaded.motion;
  built.machine.cycle_time = loaded.cycle_time.value_or(design::CycleTime{});
  for (NamedList const& named : loaded.lists) {
    built.machine.lists.push_back({.name = named.name,
                                   .content = std::string(sources[named.list.source].list_bytes()),
                                   .is_default_list = named.list.is_default_list});
  }
  for (LoadedProgram const& program : loaded.programs) {
    built.machine.lists.push_back(
        {.name = program.name, .content = {}, .is_program = true, .stored = stored_content(program, files)});
  }
  for (std::size_t axis = 0; axis < loaded.axes.size(); ++axis) {
    built.machine.axes.push_back(
        AxisBuilder(loaded, loaded.axes[axis], views[axis], sources, built.not_compiled).build());
  }
  for (LoadedGantry const& gantry : loaded.gantries) {
    for (std::size_t const slave : gantry.slaves) built.machine.axes[slave].gantry_master = gantry.master;
  }
  for (LoadedGroup const& group : loaded.groups) {
    auto& channel = built.machine.groups.emplace_back();
    channel.name = group.name;
    channel.axes = group.axes;
    channel.dynamics = group.dynamics;
    channel.uncomputed = uncomputed_parameters(group, sources);
    channel.filter_sets = filter_sets_of(loaded, group, sources, built.not_compiled);
    for (auto const program : group.programs) channel.programs.push_back(loaded.programs[program].path);
    add_guards(built.machine.groups.size() - 1, loaded, built);
  }
  return built;
}

}  // namespace axisc::validator
