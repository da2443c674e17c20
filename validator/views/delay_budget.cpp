#include "validator/views/delay_budget.hpp"

#include "design/delay_effects.hpp"
#include "validator/views/axis_delay.hpp"
#include "validator/views/drive.hpp"
#include "validator/views/feedforward_view.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace axisc::validator {
namespace {

constexpr double interpolator_cycles = 5;
/// P-AXIS-00099 counts in hundredths of 1/s.
constexpr double kv_unit = 1e-2;
constexpr double micrometres_per_millimetre = 1000;

/// A gain that a list gives to a position controller in the NC; null where there is none.
EffectiveValue const* gain_in_nc(LoadedAxis const& axis) {
  EffectiveValue const& gain = axis.merged.values.at("getriebe[].kv");
  bool const is_in_nc = position_controller(axis) == machine::PositionController::cnc;
  bool const is_known = gain.set() && !gain.unusable && gain.value.number > 0;
  return is_in_nc && is_known ? &gain : nullptr;
}

struct QuantityTime {
  std::string_view parameter;
  Feedforward needs;
  double DelayItem::*path;
  bool with_lightbus = false;
};

constexpr std::array quantity_times{
    QuantityTime{"vorsteuer.velocity_delay_time", Feedforward::added_velocity, &DelayItem::velocity},
    QuantityTime{"vorsteuer.acceleration_delay_time", Feedforward::added_acceleration,
                 &DelayItem::acceleration, true},
    QuantityTime{"vorsteuer.jerk_delay_time", Feedforward::added_jerk, &DelayItem::jerk}};

class Budget {
 public:
  Budget(LoadedAxis const& axis, design::CycleTime cycle_time, DelayState state)
      : axis_(axis),
        values_(axis.merged.values),
        cycle_time_(cycle_time),
        state_(state),
        drive_(stated_drive(axis)) {
    bool const is_switched_on =
        state == DelayState::fed_forward || values_.at("vorsteuer.default_active").is_on();
    bool const is_possible =
        feedforward_.quantities.is_on() && !values_.at("vorsteuer.global_disable").is_on();
    result_.feeds_forward = is_possible && is_switched_on;
    result_.feeds_velocity = result_.feeds_forward && feedforward_.uses(Feedforward::velocity);
  }

  std::optional<DelayBudget> take() {
    auto const filters = axis_delay(values_, cycle_time_);
    if (!filters) return std::nullopt;
    add_filters(*filters);
    add_after_filters();
    add_lag();
    return std::move(result_);
  }

  double after_filters() {
    add_after_filters();
    return result_.position;
  }

  machine::DrivePath drive_path() {
    add_after_filters();
    add_lag();
    machine::DrivePath path{.feeds_velocity = result_.feeds_velocity,
                            .delays_position_alone = delays_position_alone()};
    for (DelayItem const& item : result_.items) {
      if (item.position == 0 && item.velocity == 0) continue;
      path.delays.push_back(
          {.kind = item.kind,
           .parameter = item.cause != nullptr ? std::string(parameter_number(*item.cause)) : std::string(),
           .position = item.position,
           .velocity = item.velocity});
    }
    return path;
  }

 private:
  [[nodiscard]] bool delays_position_alone() const {
    return values_.at("kenngr.delay_filter_only_position").is_on();
  }
  [[nodiscard]] bool is_profidrive() const {
    return drive_ != nullptr && drive_->number == machine::profidrive;
  }
  [[nodiscard]] double cycles_of(EffectiveValue const& time) const {
    return time.unusable ? 0 : cycle_time_.cycles({time.value.number});
  }

  void add(DelayItem item) {
    if (item.position == 0 && item.velocity == 0 && item.acceleration == 0 && item.jerk == 0) return;
    result_.position += item.position;
    result_.velocity += item.velocity;
    result_.acceleration += item.acceleration;
    result_.jerk += item.jerk;
    result_.items.push_back(std::move(item));
  }

  /// The same on all paths.
  static DelayItem everywhere(DelayItem item, double cycles) {
    item.position = item.velocity = item.acceleration = item.jerk = cycles;
    return item;
  }

  /// Feedforward is computed from the filtered setpoint; with P-AXIS-00513 the time delay at the end of the
  /// filters acts on the position alone. That FIR and HSC filters lie before the tap as well is a reading.
  void add_filters(AxisDelay const& filters) {
    bool const is_position_alone_at_end = delays_position_alone();
    bool const has_filter_off = filters.kernel && !filters.kernel->on_at_start;
    result_.has_filter_off = has_filter_off && state_ != DelayState::filters_on;
    for (std::size_t i = 0; i < filters.shares.size(); ++i) {
      auto const& share = filters.shares[i];
      bool const is_kernel = filters.kernel && i + 1 == filters.shares.size();
      if (is_kernel && result_.has_filter_off) continue;
      bool const is_standard = i < filters.filters.size();
      bool const is_last = i + 1 == filters.filters.size();
      DelayItem item{.kind = DelayKind::filter,
                     .filter = share.filter,
                     .cause = share.cause,
                     .is_reading = !is_standard};
      bool const is_position_alone =
          is_position_alone_at_end && is_last && filters.filters[i].type == design::FilterType::time_delay;
      if (is_position_alone) {
        item.position = share.cycles;
        item.is_reading = true;
      } else {
        item = everywhere(std::move(item), share.cycles);
      }
      add(std::move(item));
    }
  }

  void add_after_filters() {
    if (result_.feeds_forward) add_feedforward();
    // That it delays all that a drive gets is a reading.
    add(everywhere({.kind = DelayKind::drive, .is_reading = true},
                   cycle_time_.cycles({axis_.drive_delay_us})));
    if (!is_profidrive()) return;
    EffectiveValue const& balancing = values_.at("vorsteuer.timeconst_sym_filter");
    add({.kind = DelayKind::balancing,
         .cause = &balancing,
         .position = cycles_of(balancing),
         .is_reading = true});
  }

  void add_feedforward() {
    EffectiveValue const& undelayed = values_.at("vorsteuer.feedforward_without_delay");
    if (!undelayed.is_on()) {
      // That they count for each axis is a reading.
      add(everywhere({.kind = DelayKind::interpolator, .cause = &undelayed, .is_reading = true},
                     interpolator_cycles));
    }
    EffectiveValue const& shift = values_.at("vorsteuer.shift_time");
    if (is_profidrive() && !shift.unusable) {
      auto item = everywhere({.kind = DelayKind::shift, .cause = &shift}, -shift.value.number);
      item.position = 0;
      add(std::move(item));
    }
    for (auto const& time : quantity_times) {
      bool const is_lightbus = time.with_lightbus && drive_ != nullptr && drive_->number == machine::lightbus;
      bool const reaches_drive = drive_ != nullptr && (drive_->digital || is_lightbus);
      if (!reaches_drive || !feedforward_.uses(time.needs)) continue;
      DelayItem item{.kind = DelayKind::quantity, .cause = &values_.at(time.parameter)};
      double const cycles = cycles_of(*item.cause);
      if (cycles >= refused_delay_cycles) continue;
      item.*time.path = cycles;
      add(std::move(item));
    }
  }

  /// (1 - w)/Kv: what the position controller of the NC lags behind at constant velocity.
  void add_lag() {
    EffectiveValue const* const gain = gain_in_nc(axis_);
    EffectiveValue const& numerator = values_.at("vorsteuer.vs_v_faktor");
    EffectiveValue const& denominator = values_.at("vorsteuer.vs_v_nenner");
    bool const is_known = !numerator.unusable && !denominator.unusable && denominator.value.number > 0;
    if (gain == nullptr || !is_known) return;
    double const weight = result_.feeds_velocity ? numerator.value.number / denominator.value.number : 0;
    result_.lag = design::position_lag(weight, gain->value.number * kv_unit) / cycle_time_.seconds();
    add({.kind = DelayKind::lag, .cause = gain, .position = result_.lag, .is_reading = true});
  }

  LoadedAxis const& axis_;
  EffectiveValues const& values_;
  design::CycleTime cycle_time_;
  DelayState state_;
  machine::DriveType const* drive_;
  FeedforwardView feedforward_{axis_.merged.values};
  DelayBudget result_;
};

}  // namespace

std::optional<DelayBudget> delay_budget(LoadedAxis const& axis, design::CycleTime cycle_time,
                                        DelayState state) {
  return Budget(axis, cycle_time, state).take();
}

double delay_after_filters(LoadedAxis const& axis, design::CycleTime cycle_time) {
  return Budget(axis, cycle_time, DelayState::at_start).after_filters();
}

machine::DrivePath drive_path(LoadedAxis const& axis, design::CycleTime cycle_time, DelayState state) {
  return Budget(axis, cycle_time, state).drive_path();
}

double deviation_of_mismatch(double feed, double mismatch, design::CycleTime cycle_time) {
  return design::deviation_of_mismatch(feed, mismatch * cycle_time.seconds());
}

std::optional<double> deviation_of_lead(LoadedAxis const& axis, double lead, design::CycleTime cycle_time) {
  EffectiveValue const* const gain = gain_in_nc(axis);
  EffectiveValue const& acceleration = axis.merged.values.at("getriebe[].dynamik.a_max");
  if (gain == nullptr || acceleration.unusable) return std::nullopt;
  return design::deviation_of_lead(acceleration.value.number * micrometres_per_millimetre,
                                   lead * cycle_time.seconds(), gain->value.number * kv_unit);
}

std::optional<double> lowest_velocity_limit(LoadedMachine const& machine, LoadedGroup const& group) {
  std::optional<double> lowest;
  for (std::size_t const index : group.axes) {
    LoadedAxis const& axis = machine.axes[index];
    EffectiveValue const& limit = axis.merged.values.at("getriebe[].dynamik.vb_max");
    if (limit.unusable || axis.type != machine::AxisType::translatory) continue;
    lowest = std::min(lowest.value_or(limit.value.number), limit.value.number);
  }
  return lowest;
}

}  // namespace axisc::validator
