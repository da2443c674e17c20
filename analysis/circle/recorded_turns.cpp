#include "analysis/circle/recorded_turns.hpp"

#include "analysis/circle/circle_fit.hpp"
#include "analysis/motion/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

namespace axisc::circle {

namespace {

constexpr double speed_window = 0.02;  // s
constexpr double speed_tolerance = 0.01;
/// The speed of actual positions is less even than that of setpoints.
constexpr double actual_speed_tolerance = 0.05;
/// Of the largest speed, which may be that of a rapid move: slower is standing still.
constexpr double least_speed = 0.001;
/// Of R: farther from the circle is another path.
constexpr double on_circle = 0.002;
/// A path that leaves the circle at an angle of 0 is on_circle R away after √(2 on_circle) rad if it is
/// straight; an arc may take twice as long.
double const leaving = 2 * std::sqrt(2 * on_circle);
/// A circle is found from no more positions than this.
constexpr std::size_t most_fitted = 20'000;
constexpr double whole = 2 * std::numbers::pi;

/// Samples first to last, both included, that may be a turn.
struct Run {
  std::size_t first = 0, last = 0;
  Sense sense = Sense::counterclockwise;
};

class TurnSearch {
 public:
  explicit TurnSearch(RecordedPath const& path)
      : path_(path),
        has_setpoint_(!path.setpoint_u.empty()),
        u_(has_setpoint_ ? path.setpoint_u : path.actual_u),
        v_(has_setpoint_ ? path.setpoint_v : path.actual_v) {}

  std::variant<std::vector<Turn>, BadTurn> search() {
    if (!find_steady()) return BadTurn{.problem = TurnProblem::no_motion};
    if (!find_circle()) return BadTurn{.problem = TurnProblem::no_circle};
    std::vector<Turn> turns;
    auto const all = runs();
    for (auto run = all.end(); run != all.begin();) {
      --run;
      bool const is_known =
          std::any_of(turns.begin(), turns.end(), [&](Turn const& turn) { return turn.sense == run->sense; });
      if (is_known) continue;
      if (auto turn = turn_of(*run)) turns.push_back(*std::move(turn));
    }
    if (turns.empty()) return bad_;
    std::reverse(turns.begin(), turns.end());
    return turns;
  }

 private:
  /// Where the speed is that of the circle.
  bool find_steady() {
    std::size_t const count = u_.size();
    window_ =
        std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(speed_window / path_.sample_time)));
    if (count <= window_ + 1) return false;
    std::vector<double> speed(count);
    double fastest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      auto const from = window_begin(i);
      speed[i] = std::hypot(u_[from + window_] - u_[from], v_[from + window_] - v_[from]);
      fastest = std::max(fastest, speed[i]);
    }
    if (!(fastest > 2 * path_.resolution)) return false;
    auto moving = speed;
    std::erase_if(moving, [&](double each) { return each <= least_speed * fastest + 2 * path_.resolution; });
    step_ = motion::median(std::move(moving));
    double const tolerance = has_setpoint_ ? speed_tolerance : actual_speed_tolerance;
    steady_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      steady_[i] = std::abs(speed[i] - step_) <= tolerance * step_ + 2 * path_.resolution;
    }
    is_gap_.assign(count, false);
    for (auto const gap : path_.gaps) is_gap_[gap] = true;
    return true;
  }

  [[nodiscard]] std::size_t window_begin(std::size_t i) const {
    std::size_t const half = window_ / 2;
    return std::min(i < half ? 0 : i - half, u_.size() - 1 - window_);
  }

  /// The circle on which most steady positions lie.
  bool find_circle() {
    std::vector<Sample> steady;
    for (std::size_t i = 0; i < u_.size(); ++i) {
      if (steady_[i]) steady.push_back({.u = u_[i], .v = v_[i], .weight = 1});
    }
    std::size_t const every = steady.size() / most_fitted + 1;
    for (std::size_t i = 0; i * every < steady.size(); ++i) steady[i] = steady[i * every];
    steady.resize((steady.size() + every - 1) / every);
    std::vector<Sample> kept = steady;
    constexpr int most_rounds = 40;
    for (int round = 0; round < most_rounds && kept.size() >= 3; ++round) {
      circle_ = fit_circle(kept);
      if (!std::isfinite(circle_.radius)) return false;
      std::vector<double> away;
      away.reserve(steady.size());
      for (auto const& each : steady) away.push_back(away_from_circle(each.u, each.v));
      double const allowed = std::max(on_circle * circle_.radius, 2 * motion::median(away));
      std::vector<Sample> closer;
      for (std::size_t i = 0; i < steady.size(); ++i) {
        if (away[i] <= allowed) closer.push_back(steady[i]);
      }
      bool const is_done = closer.size() == kept.size();
      kept = std::move(closer);
      if (is_done) return allowed <= on_circle * circle_.radius;
    }
    return false;
  }

  [[nodiscard]] double away_from_circle(double u, double v) const {
    return std::abs(std::hypot(u - circle_.u, v - circle_.v) - circle_.radius);
  }
  [[nodiscard]] bool is_on_circle(std::size_t i) const {
    return away_from_circle(u_[i], v_[i]) <= on_circle * circle_.radius;
  }
  [[nodiscard]] Sense sense_at(std::size_t i) const {
    auto const from = window_begin(i);
    auto const to = from + window_;
    double const turning =
        (u_[from] - circle_.u) * (v_[to] - circle_.v) - (v_[from] - circle_.v) * (u_[to] - circle_.u);
    return turning < 0 ? Sense::clockwise : Sense::counterclockwise;
  }

  /// Steady, on the circle, in one direction; without what may be arcs that touch it.
  [[nodiscard]] std::vector<Run> runs() const {
    std::vector<Run> found;
    std::size_t const count = u_.size();
    double const step = step_ / static_cast<double>(window_) / circle_.radius;
    auto const cut = static_cast<std::size_t>(leaving / step);
    auto const settling = static_cast<std::size_t>(std::ceil(path_.settling / path_.sample_time));
    auto const counts = [&](std::size_t i) { return steady_[i] && is_on_circle(i); };
    for (std::size_t i = 0; i < count;) {
      if (!counts(i)) {
        ++i;
        continue;
      }
      Run run{.first = i, .last = i, .sense = sense_at(i)};
      while (run.last + 1 < count && counts(run.last + 1) && sense_at(run.last + 1) == run.sense) ++run.last;
      i = run.last + 1;
      bool const is_left = i < count && steady_[i];
      bool const is_entered = run.first > 0 && steady_[run.first - 1];
      run.first += settling + (is_entered ? cut : 0);
      std::size_t const end = is_left ? cut : 0;
      if (run.first + end >= run.last) continue;
      run.last -= end;
      found.push_back(run);
    }
    return found;
  }

  void note(BadTurn const& bad) {
    if (bad_.problem != TurnProblem::few_points && bad.degrees >= bad_.degrees) bad_ = bad;
  }

  /// Its last 360° of actual positions.
  std::optional<Turn> turn_of(Run const& run) {
    std::vector<std::size_t> places;
    std::vector<double> angles;
    for (std::size_t i = run.last + 1; i-- > run.first;) {
      if (is_gap_[i]) continue;
      double angle = std::atan2(path_.actual_v[i] - circle_.v, path_.actual_u[i] - circle_.u);
      if (!angles.empty()) angle = angles.back() + std::remainder(angle - angles.back(), whole);
      places.push_back(i);
      angles.push_back(angle);
      if (std::abs(angle - angles.front()) >= whole) break;
    }
    double const covered = angles.empty() ? 0 : std::abs(angles.back() - angles.front());
    if (covered < whole) {
      note({.problem = TurnProblem::less_than_turn, .degrees = covered / whole * whole_turn});
      return std::nullopt;
    }
    if (places.size() < fewest_points) {
      note({.problem = TurnProblem::few_points, .degrees = whole_turn, .points = places.size()});
      return std::nullopt;
    }
    std::reverse(places.begin(), places.end());
    std::reverse(angles.begin(), angles.end());
    Turn turn{.sense = run.sense, .samples = {}};
    turn.samples.resize(places.size());
    weigh(turn.samples, angles);
    auto const fill = [&](std::vector<double> const& u, std::vector<double> const& v, double u0, double v0) {
      for (std::size_t i = 0; i < places.size(); ++i) {
        turn.samples[i].u = u[places[i]] - u0;
        turn.samples[i].v = v[places[i]] - v0;
      }
    };
    double const seconds = static_cast<double>(places.back() - places.front()) * path_.sample_time;
    turn.angular_speed = covered / seconds;
    if (!has_setpoint_) {
      fill(path_.actual_u, path_.actual_v, 0, 0);
      return turn;
    }
    fill(u_, v_, 0, 0);
    auto const setpoint = fit_circle(turn.samples);
    turn.radius = setpoint.radius;
    fill(path_.actual_u, path_.actual_v, setpoint.u, setpoint.v);
    return turn;
  }

  RecordedPath const& path_;
  bool has_setpoint_;
  std::vector<double> const& u_;  ///< what tells the turn: setpoints, or actual positions without them
  std::vector<double> const& v_;
  std::size_t window_ = 1;  ///< steps
  double step_ = 0;         ///< µm, the median way in a window
  std::vector<bool> steady_, is_gap_;
  FittedCircle circle_;
  BadTurn bad_{.problem = TurnProblem::less_than_turn};
};

}  // namespace

std::variant<std::vector<Turn>, BadTurn> recorded_turns(RecordedPath const& path) {
  return TurnSearch(path).search();
}

}  // namespace axisc::circle
