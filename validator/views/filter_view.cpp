#include "validator/views/filter_view.hpp"

#include "schema/catalogue.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <tuple>

namespace axisc::validator {
namespace {

constexpr std::uint32_t setpoint_filters = 3;
constexpr std::uint32_t interface_filters = 1;

enum class Member : std::uint8_t { enable, order, prototype, type, frequency, quality, share, time_constant };

constexpr std::array<std::string_view, 8> member_names = {
    "enable", "order", "prototype", "type", "fg_f0", "guete", "share_percent", "time_constant"};

using FilterSlots =
    std::array<std::array<schema::Slot, member_names.size()>, setpoint_filters + interface_filters>;

FilterSlots look_up_slots() {
  FilterSlots slots{};
  for (std::size_t member = 0; member < member_names.size(); ++member) {
    std::string const name(member_names[member]);
    schema::Parameter const& of_setpoint = row_at("filter[]." + name);
    for (std::uint32_t i = 0; i < setpoint_filters; ++i) slots[i][member] = schema::slot_of(of_setpoint, i);
    schema::Parameter const& of_interface = row_at("lr_param.add_interface.filter[]." + name);
    for (std::uint32_t i = 0; i < interface_filters; ++i) {
      slots[setpoint_filters + i][member] = schema::slot_of(of_interface, i);
    }
  }
  return slots;
}

/// Views are made by the thousand; the names are looked up once.
std::array<schema::Slot, member_names.size()> const& slots_of(FilterPort port, std::uint32_t index) {
  static FilterSlots const slots = look_up_slots();
  return slots[port == FilterPort::setpoint ? index : setpoint_filters + index];
}

EffectiveValue const& value_of(EffectiveValues const& values, FilterPort port, std::uint32_t index,
                               Member member) {
  return values[slots_of(port, index)[static_cast<std::size_t>(member)]];
}

bool is_touched(EffectiveValues const& values, FilterPort port, std::uint32_t index) {
  auto const& slots = slots_of(port, index);
  return std::any_of(slots.begin(), slots.end(),
                     [&values](schema::Slot slot) { return values.is_set(slot); });
}

}  // namespace

FilterView::FilterView(EffectiveValues const& values, FilterPort port_, std::uint32_t index_)
    : port(port_),
      index(index_),
      enable(value_of(values, port_, index_, Member::enable)),
      order(value_of(values, port_, index_, Member::order)),
      prototype(value_of(values, port_, index_, Member::prototype)),
      type(value_of(values, port_, index_, Member::type)),
      frequency(value_of(values, port_, index_, Member::frequency)),
      quality(value_of(values, port_, index_, Member::quality)),
      share(value_of(values, port_, index_, Member::share)),
      time_constant(value_of(values, port_, index_, Member::time_constant)),
      readings(values.readings()) {
  if (is_hsc()) return;
  if (auto const* const kind = design::find_filter_kind(type_number())) standard_type = kind->type;
}

bool FilterView::is_hsc() const {
  return !prototype.unusable && static_cast<int>(prototype.value.number) == design::hsc_prototype;
}

int FilterView::type_number() const {
  if (port == FilterPort::setpoint && !type.set() && is_hsc()) return static_cast<int>(design::HscType::mean);
  return static_cast<int>(type.value.number);
}

std::string_view FilterView::type_word() const {
  auto const symbols = type.row->symbols;
  int const number = type_number();
  auto const symbol = std::find_if(symbols.begin(), symbols.end(),
                                   [number](schema::Symbol const& known) { return known.number == number; });
  return symbol == symbols.end() ? type.value.text : symbol->word;
}

bool FilterView::active() const {
  return !unusable() && enable.value.flag() && order.value.number > 0 && standard_type.has_value();
}

bool FilterView::type_unusable() const {
  return type.unusable || (port == FilterPort::setpoint && !type.set() && prototype.unusable);
}

bool FilterView::unusable() const {
  return enable.unusable || order.unusable || type_unusable();
}

EffectiveValue const& FilterView::anchor(EffectiveValue const& wanted) const {
  if (wanted.set()) return wanted;
  if (enable.set()) return enable;
  auto const values = all();
  auto const* const first = std::min_element(values.begin(), values.end(),
                                             [](EffectiveValue const* left, EffectiveValue const* right) {
                                               return std::tuple(!left->set(), left->origin, left->line) <
                                                      std::tuple(!right->set(), right->origin, right->line);
                                             });
  return **first;
}

std::optional<design::FilterSpecification> FilterView::specification(design::CycleTime cycle_time) const {
  if (!active() || share.unusable) return std::nullopt;
  design::FilterKind const& kind = design::kind_of(*standard_type);
  if (!kind.order.fits(order.value.number)) return std::nullopt;
  design::FilterSpecification specification;
  specification.type = kind.type;
  specification.order = static_cast<std::uint32_t>(order.value.number);
  specification.share_percent = share.value.number;
  specification.reading = readings.filters;
  specification.cycle_time = readings.cycle_time;
  if (kind.uses_prototype) {
    if (prototype.unusable) return std::nullopt;
    specification.prototype = static_cast<design::Prototype>(static_cast<int>(prototype.value.number));
  }
  if (kind.uses_frequency) {
    if (frequency.unusable) return std::nullopt;
    specification.frequency = {frequency.value.number};
  }
  if (kind.quality) {
    if (quality.unusable) return std::nullopt;
    specification.quality = quality.value.number;
  }
  if (kind.time_constant) {
    if (time_constant.unusable) return std::nullopt;
    specification.time_constant = {time_constant.value.number};
  }
  specification.reading = design::applied_reading(specification);
  return design::is_in_range(specification, cycle_time) ? std::optional(specification) : std::nullopt;
}

std::vector<FilterView> touched_filters(EffectiveValues const& values) {
  std::vector<FilterView> filters;
  filters.reserve(setpoint_filters + interface_filters);
  auto const add = [&](FilterPort port, std::uint32_t count) {
    for (std::uint32_t index = 0; index < count; ++index) {
      if (is_touched(values, port, index)) filters.emplace_back(values, port, index);
    }
  };
  add(FilterPort::setpoint, setpoint_filters);
  add(FilterPort::additional_interface, interface_filters);
  return filters;
}

}  // namespace axisc::validator
