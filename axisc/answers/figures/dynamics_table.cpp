#include "axisc/answers/figures/dynamics_table.hpp"

#include "axisc/answers/execution/path_dynamics.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/message.hpp"

#include <algorithm>
#include <array>

namespace axisc::says {

constexpr Sentence dynamics_quantity{"quantity", "Größe"};
constexpr Sentence dynamics_was{"{motion}, before", "{motion}, vorher"};
constexpr Sentence dynamics_at_feed{"F{feed}", "F{feed}"};
constexpr Sentence dynamics_slope{"slope", "Slope"};
constexpr Sentence dynamics_ramps{"{quantity}, {ramp}", "{quantity}, {ramp}"};
constexpr Sentence speeding_up{"accelerating", "Beschleunigen"};
constexpr Sentence slowing_down{"braking", "Bremsen"};
constexpr Sentence up_build_up{"building up acceleration", "Aufbau der Beschleunigung"};
constexpr Sentence up_take_back{"taking back acceleration", "Abbau der Beschleunigung"};
constexpr Sentence down_build_up{"building up deceleration", "Aufbau der Verzögerung"};
constexpr Sentence down_take_back{"taking back deceleration", "Abbau der Verzögerung"};
constexpr Sentence second_stage{"a above the changeover", "a über der Umschaltung"};
constexpr Sentence changeover{"changeover", "Umschaltung"};
constexpr Sentence velocity_allowed{"velocity limit", "Geschwindigkeitsgrenze"};
constexpr Sentence velocity_reached{"velocity reached", "erreichte Geschwindigkeit"};
constexpr Sentence through_corner{"through a corner of 90°", "durch eine Ecke von 90°"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// Of each column; none where the slope has no such quantity.
using Cells = std::vector<std::optional<double>>;

/// Rows of one axis.
class AxisTable {
 public:
  AxisTable(pictures::Table& table, DynamicsRows const& axis, DynamicsTerms const& terms)
      : table_(table), axis_(axis), terms_(terms) {
    for (bool const rapid : {false, true}) {
      if (terms.has_before) columns_.push_back({axis.before ? &*axis.before : nullptr, rapid});
      columns_.push_back({&axis.now, rapid});
    }
    for (auto& column : columns_) {
      if (column.state != nullptr) column.mode = column.state->driven.mode(column.rapid);
    }
  }

  void write() {
    write_slopes();
    write_of_both("a", unit("/s²"), [](Column const& column, motion::AxisRamp const& ramp) {
      return std::optional(
          column.state->driven.acceleration(column.is_step() ? ramp.first : ramp.acceleration));
    });
    write_of_both(
        say(says::second_stage), unit("/s²"), [](Column const& column, motion::AxisRamp const& ramp) {
          return column.has_stages(ramp) ? std::optional(column.state->driven.acceleration(ramp.second))
                                         : std::nullopt;
        });
    write_row(label(say(says::changeover), unit("/s")), cells([](Column const& column) {
                return column.has_stages(column.mode.up)
                           ? std::optional(column.state->driven.velocity(column.mode.up.changeover))
                           : std::nullopt;
              }));
    write_ramps("tr", "ms", [](Column const& column, motion::AxisRamp const&, double time) {
      constexpr double ms_per_s = 1000;
      return column.state->driven.seconds(time) * ms_per_s;
    });
    write_ramps("a/tr", axis_.unit == "mm" ? "m/s³" : "1000 " + unit("/s³"),
                [](Column const& column, motion::AxisRamp const& ramp, double time) {
                  return column.state->driven.jerk(ramp.acceleration / time);
                });
    write_row(label(say(says::velocity_allowed), unit("/s")), cells([](Column const& column) {
                return std::optional(column.state->driven.velocity(column.mode.velocity));
              }));
    write_row(label(say(says::velocity_reached), unit("/s")),
              cells([](Column const& column) { return std::optional(column.move().velocity); }));
    write_row(label(say(says::through_corner), unit("/s")), cells([](Column const& column) {
                return column.rapid ? std::nullopt : std::optional(column.state->driven.corner_velocity());
              }));
    write_row(label(say(labels::time), "s"),
              cells([](Column const& column) { return std::optional(column.move().seconds); }));
  }

 private:
  struct Column {
    DrivenState const* state = nullptr;  ///< null: the axis was not there before
    bool rapid = false;
    motion::AxisMode mode = {};

    [[nodiscard]] bool is_step() const { return state->driven.slope() == machine::Slope::step; }
    [[nodiscard]] bool has_stages(motion::AxisRamp const& ramp) const {
      return is_step() && ramp.first != ramp.second;
    }
    [[nodiscard]] PlannedMove const& move() const { return rapid ? state->in_rapid : state->at_feed; }
  };

  [[nodiscard]] std::string say(SentenceRef sentence, std::vector<Argument> arguments = {}) const {
    return render({sentence, std::move(arguments)}, terms_.language);
  }
  [[nodiscard]] std::string unit(std::string const& per) const { return axis_.unit + per; }
  [[nodiscard]] static std::string label(std::string const& quantity, std::string const& unit) {
    return quantity + " [" + unit + "]";
  }
  [[nodiscard]] std::string label_of(std::string const& quantity, SentenceRef part,
                                     std::string const& unit) const {
    return label(say(says::dynamics_ramps, {{"quantity", quantity}, {"ramp", say(part)}}), unit);
  }

  template <class ValueOf>
  [[nodiscard]] Cells cells(ValueOf value_of) const {
    Cells found;
    for (auto const& column : columns_) {
      found.push_back(column.state != nullptr ? value_of(column) : std::nullopt);
    }
    return found;
  }

  void write_slopes() {
    std::vector<std::string> row{axis_.axis, say(says::dynamics_slope)};
    for (auto const& column : columns_) {
      row.emplace_back(column.state != nullptr ? slope_name(column.state->driven.slope()) : "-");
    }
    table_.rows.push_back(std::move(row));
  }

  void write_row(std::string quantity, Cells const& values) {
    bool const has_any = std::any_of(values.begin(), values.end(),
                                     [](std::optional<double> const& value) { return value.has_value(); });
    if (!has_any) return;
    std::vector<std::string> row{axis_.axis, std::move(quantity)};
    for (auto const& value : values) {
      row.push_back(value ? format_rounded(*value, pictures::shown_digits).in(terms_.language) : "-");
    }
    table_.rows.push_back(std::move(row));
  }

  /// One row where accelerating and braking are alike, otherwise two.
  template <class ValueOf>
  void write_of_both(std::string const& quantity, std::string const& unit, ValueOf value_of) {
    auto const up = cells([&](Column const& column) { return value_of(column, column.mode.up); });
    auto const down = cells([&](Column const& column) { return value_of(column, column.mode.down); });
    if (up == down) return write_row(label(quantity, unit), up);
    write_row(label_of(quantity, says::speeding_up, unit), up);
    write_row(label_of(quantity, says::slowing_down, unit), down);
  }

  /// One row where the four ramps are alike; none with STEP.
  template <class ValueOf>
  void write_ramps(std::string const& quantity, std::string const& unit, ValueOf value_of) {
    struct Ramp {
      SentenceRef name;
      motion::AxisRamp motion::AxisMode::*ramp;
      double motion::AxisRamp::*time;
    };
    std::array const ramps = {
        Ramp{says::up_build_up, &motion::AxisMode::up, &motion::AxisRamp::build_up},
        Ramp{says::up_take_back, &motion::AxisMode::up, &motion::AxisRamp::take_back},
        Ramp{says::down_build_up, &motion::AxisMode::down, &motion::AxisRamp::build_up},
        Ramp{says::down_take_back, &motion::AxisMode::down, &motion::AxisRamp::take_back}};
    std::vector<Cells> found;
    found.reserve(ramps.size());
    for (auto const& each : ramps) {
      found.push_back(cells([&](Column const& column) {
        auto const& ramp = column.mode.*each.ramp;
        return column.is_step() ? std::nullopt : std::optional(value_of(column, ramp, ramp.*each.time));
      }));
    }
    bool const are_alike = std::all_of(found.begin(), found.end(),
                                       [&found](Cells const& each) { return each == found.front(); });
    if (are_alike) return write_row(label(quantity, unit), found.front());
    for (std::size_t i = 0; i < ramps.size(); ++i) {
      write_row(label_of(quantity, ramps.at(i).name, unit), found[i]);
    }
  }

  pictures::Table& table_;
  DynamicsRows const& axis_;
  DynamicsTerms const& terms_;
  std::vector<Column> columns_;
};

}  // namespace

pictures::Table dynamics_table(std::vector<DynamicsRows> const& axes, DynamicsTerms const& terms) {
  auto const say = [&terms](SentenceRef sentence, std::vector<Argument> arguments = {}) {
    return render({sentence, std::move(arguments)}, terms.language);
  };
  pictures::Table table{.header = {say(labels::axis), say(says::dynamics_quantity)}, .rows = {}};
  for (auto const& motion : {say(says::dynamics_at_feed, {{"feed", terms.feed}}), std::string("G00")}) {
    if (terms.has_before) table.header.push_back(say(says::dynamics_was, {{"motion", motion}}));
    table.header.push_back(motion);
  }
  for (auto const& axis : axes) AxisTable(table, axis, terms).write();
  return table;
}

}  // namespace axisc
