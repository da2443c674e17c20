#include "axisc/answers/figures/dynamics_table.hpp"

#include "axisc/answers/execution/path_dynamics.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/message.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence motion{"motion", "Bewegung"};
constexpr Sentence at_feed{"F{feed}", "F{feed}"};
constexpr Sentence in_rapid{"G00", "G00"};
constexpr Sentence slope{"slope", "Slope"};
constexpr Sentence through_corner{"corner", "Ecke"};
constexpr Sentence reached_of_allowed{"{reached} of {allowed}", "{reached} von {allowed}"};
constexpr Sentence stages{"{first}, above {changeover} {unit} {second}",
                          "{first}, über {changeover} {unit} {second}"};
constexpr Sentence up_and_down{"{up} / {down}", "{up} / {down}"};
constexpr Sentence both_ramps{"{build_up}, {take_back}", "{build_up}, {take_back}"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr int shown_digits = 4;

class DynamicsTable {
 public:
  /// `unit` outlives the table.
  DynamicsTable(std::string const& unit, bool shows_slopes, Language language)
      : unit_(unit), shows_slopes_(shows_slopes), language_(language) {}

  [[nodiscard]] std::vector<std::string> header() const {
    std::string const jerk_unit = unit_ == "mm" ? "m/s³" : "1000 " + unit_ + "/s³";
    std::vector<std::string> cells{say(labels::axis), say(says::motion)};
    if (shows_slopes_) cells.push_back(say(says::slope));
    cells.insert(cells.end(),
                 {"a [" + unit_ + "/s²]", "tr [ms]", "a/tr [" + jerk_unit + "]", "v [" + unit_ + "/s]",
                  say(says::through_corner) + " [" + unit_ + "/s]", "t [s]"});
    return cells;
  }

  [[nodiscard]] std::vector<std::string> row(DynamicsRow const& row, bool rapid) const {
    auto const& driven = row.driven;
    auto const mode = driven.mode(rapid);
    auto const& move = rapid ? row.in_rapid : row.at_feed;
    bool const is_step = driven.slope() == machine::Slope::step;
    std::vector<std::string> cells{row.axis,
                                   rapid ? say(says::in_rapid) : say(says::at_feed, {{"feed", row.feed}})};
    if (shows_slopes_) cells.emplace_back(slope_name(driven.slope()));
    cells.push_back(of_both(mode, [&](motion::AxisRamp const& ramp) {
      return is_step ? staged(driven, ramp) : text(driven.acceleration(ramp.acceleration));
    }));
    cells.push_back(
        is_step ? "-" : of_both(mode, [&](motion::AxisRamp const& ramp) { return times(driven, ramp); }));
    cells.push_back(
        is_step ? "∞" : of_both(mode, [&](motion::AxisRamp const& ramp) { return jerks(driven, ramp); }));
    cells.push_back(say(says::reached_of_allowed, {{"reached", text(move.velocity)},
                                                   {"allowed", text(driven.velocity(mode.velocity))}}));
    cells.push_back(rapid ? "-" : text(driven.corner_velocity()));
    cells.push_back(text(move.seconds));
    return cells;
  }

 private:
  [[nodiscard]] std::string say(SentenceRef sentence, std::vector<Argument> arguments = {}) const {
    return render({sentence, std::move(arguments)}, language_);
  }
  [[nodiscard]] std::string text(double value) const {
    return format_rounded(value, shown_digits).in(language_);
  }

  template <class TextOf>
  [[nodiscard]] std::string of_both(motion::AxisMode const& mode, TextOf text_of) const {
    std::string const up = text_of(mode.up);
    std::string const down = text_of(mode.down);
    return up == down ? up : say(says::up_and_down, {{"up", up}, {"down", down}});
  }

  [[nodiscard]] std::string staged(DrivenAxis const& driven, motion::AxisRamp const& ramp) const {
    std::string const first = text(driven.acceleration(ramp.first));
    if (ramp.first == ramp.second) return first;
    return say(says::stages, {{"first", first},
                              {"changeover", text(driven.velocity(ramp.changeover))},
                              {"unit", unit_ + "/s"},
                              {"second", text(driven.acceleration(ramp.second))}});
  }

  [[nodiscard]] std::string pair(double build_up, double take_back) const {
    if (build_up == take_back) return text(build_up);
    return say(says::both_ramps, {{"build_up", text(build_up)}, {"take_back", text(take_back)}});
  }
  [[nodiscard]] std::string times(DrivenAxis const& driven, motion::AxisRamp const& ramp) const {
    constexpr double ms_per_s = 1000;
    return pair(driven.seconds(ramp.build_up) * ms_per_s, driven.seconds(ramp.take_back) * ms_per_s);
  }
  [[nodiscard]] std::string jerks(DrivenAxis const& driven, motion::AxisRamp const& ramp) const {
    return pair(driven.jerk(ramp.acceleration / ramp.build_up),
                driven.jerk(ramp.acceleration / ramp.take_back));
  }

  std::string const& unit_;
  bool shows_slopes_;
  Language language_;
};

}  // namespace

pictures::Table dynamics_table(std::vector<DynamicsRow> const& rows, std::string const& unit,
                               Language language) {
  bool const has_slopes = std::any_of(rows.begin(), rows.end(), [&rows](DynamicsRow const& row) {
    return row.driven.slope() != rows.front().driven.slope();
  });
  DynamicsTable const writer(unit, has_slopes, language);
  pictures::Table table{.header = writer.header(), .rows = {}};
  for (auto const& row : rows) {
    table.rows.push_back(writer.row(row, false));
    table.rows.push_back(writer.row(row, true));
  }
  return table;
}

}  // namespace axisc
