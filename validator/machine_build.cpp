#include "validator/machine_build.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace axisc::validator {
namespace {

class AxisBuilder {
 public:
  AxisBuilder(LoadedMachine const& machine, LoadedAxis const& axis, SourceSet const& sources,
              std::vector<NotCompiled>& not_compiled)
      : machine_(machine),
        axis_(axis),
        values_(axis.merged.values),
        sources_(sources),
        not_compiled_(not_compiled),
        cycle_time_(machine.cycle_time.value_or(design::CycleTime{})) {}

  AxisConfiguration build() {
    AxisConfiguration result;
    result.name = axis_.name;
    result.number = static_cast<std::uint32_t>(number("kopf.achs_nr"));
    result.type = axis_.type;
    result.position_window = number("kenngr.filter_position_window");
    result.velocity_limit = number("getriebe[].dynamik.vb_max");
    result.acceleration_limit = number("getriebe[].dynamik.a_max");
    add_filters(result);
    find_other_filters();
    add_values(result);
    return result;
  }

 private:
  [[nodiscard]] double number(std::string_view pattern) const { return values_.at(pattern).value.number; }

  void leave_out(EffectiveValue const& value, Text text, std::vector<Argument> arguments) {
    Place const fallback{.source = machine_.lists[axis_.list].list.source, .span = {}};
    Place const place = value.value_place ? *value.value_place : value.name_place.value_or(fallback);
    arguments.push_back({.name = "axis", .value = axis_.name});
    not_compiled_.push_back({.place = place, .feature = {.text = text, .arguments = std::move(arguments)}});
  }

  void add_filters(AxisConfiguration& result) {
    bool const interface_on = values_.at("lr_param.add_interface.enable").value.flag();
    for (FilterView const& filter : touched_filters(values_)) {
      bool const setpoint = filter.port == FilterPort::setpoint;
      if (!setpoint && !interface_on) continue;
      if (setpoint && filter.is_hsc()) {
        leave_out(filter.anchor(filter.prototype), Text::not_compiled_hsc,
                  {{.name = "index", .value = std::to_string(filter.index)}});
        continue;
      }
      std::optional<design::FilterSpecification> const specification = filter.specification(cycle_time_);
      if (specification) {
        auto& filters = setpoint ? result.filters : result.interface_filters;
        filters.push_back({.index = filter.index, .specification = *specification});
      } else if (filter.unusable() || (filter.enable.value.flag() && filter.order.value.number > 0)) {
        // Its error was silenced; it must not be left out without a word.
        std::string name = setpoint ? "filter[" : "lr_param.add_interface.filter[";
        name.append(std::to_string(filter.index)).append("]");
        leave_out(filter.anchor(filter.enable), Text::not_compiled_filter,
                  {{.name = "filter", .value = std::move(name)}});
      }
    }
  }

  void find_other_filters() {
    EffectiveValue const& fir = values_.at("filter_fir.enable");
    double const type = number("filter_fir.type");
    bool const has_order = number("filter_fir.order") > 0 || number("filter_fir.order_time") > 0;
    if (fir.value.flag() && type >= 1 && type <= 4 && has_order) leave_out(fir, Text::not_compiled_fir, {});

    EffectiveValue const& position_control = values_.at("lr_param.improved_position_control.enable");
    bool active = false;
    for (std::uint32_t stage = 0; stage < 3; ++stage) {
      std::string const& mode =
          values_.at("lr_param.improved_position_control.stage[].mode", stage).value.text;
      active = active || mode != "NOT_ACTIVE";
    }
    if (position_control.value.flag() && active) leave_out(position_control, Text::not_compiled_ipc, {});
  }

  void add_values(AxisConfiguration& result) const {
    for (schema::Slot const slot : values_.set_slots()) {
      EffectiveValue const& value = values_[slot];
      if (!value.value_place) continue;
      std::size_t const list = value.origin == Origin::default_list ? *machine_.default_list : axis_.list;
      result.values.push_back({.name = schema::slot_name(slot),
                               .text = sources_[value.value_place->source].utf8(value.value_place->span),
                               .list = static_cast<std::uint32_t>(list),
                               .line = value.line});
    }
  }

  LoadedMachine const& machine_;
  LoadedAxis const& axis_;
  EffectiveValues const& values_;
  SourceSet const& sources_;
  std::vector<NotCompiled>& not_compiled_;
  design::CycleTime cycle_time_;
};

}  // namespace

BuiltMachine build_machine(LoadedMachine const& loaded, SourceSet const& sources) {
  BuiltMachine built;
  built.machine.name = loaded.name;
  built.machine.cycle_time = loaded.cycle_time.value_or(design::CycleTime{});
  for (NamedList const& named : loaded.lists) {
    built.machine.lists.push_back({.name = named.name,
                                   .content = std::string(sources[named.list.source].bytes()),
                                   .is_default_list = named.list.is_default_list});
  }
  for (LoadedAxis const& axis : loaded.axes) {
    built.machine.axes.push_back(AxisBuilder(loaded, axis, sources, built.not_compiled).build());
  }
  return built;
}

}  // namespace axisc::validator
