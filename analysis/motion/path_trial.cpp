#include "analysis/motion/path_trial.hpp"

#include "analysis/motion/velocity_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace axisc::motion {
namespace {

/// The chains do the same within this, cycles.
constexpr double same_answer = 1e-9;
constexpr std::int64_t trial_cycles_per_call = 1024;
/// A share of a tolerance: between two points below it the error is not looked at.
constexpr double near_tolerance = 0.9;
constexpr int most_halvings = 6;

bool same(ChainAnswer const& a, ChainAnswer const& b) {
  return a.delay == b.delay && std::equal(a.ramp.begin(), a.ramp.end(), b.ramp.begin(), b.ramp.end(),
                                          [](double x, double y) { return std::abs(x - y) <= same_answer; });
}

/// Walks along a path and its corners.
struct Walk {
  std::span<TimedPiece const> path;
  std::span<TriedCorner const> corners;
  std::size_t piece = 0;
  std::size_t corner = 0;

  /// Begins at the last corner before this place.
  void begin_at(double place) {
    auto const next =
        std::lower_bound(corners.begin(), corners.end(), place,
                         [](TriedCorner const& each, double wanted) { return each.place < wanted; });
    corner = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, next - corners.begin())) - 1;
  }
  /// Nearest corner along the path.
  std::size_t nearest(double place) {
    while (corner + 1 < corners.size() && place - corners[corner].place > corners[corner + 1].place - place) {
      ++corner;
    }
    return corner;
  }
  [[nodiscard]] bool ended() const { return piece == path.size(); }
};

}  // namespace

PathTrial::PathTrial(GroupRuntime& runtime, std::span<ChainAnswer const> answers,
                     std::function<void()> working)
    : runtime_(&runtime),
      answers_(answers),
      meter_(runtime.axis_count(), *this),
      working_(std::move(working)) {
  double earliest = std::numeric_limits<double>::infinity();
  for (auto const& answer : answers) {
    reach_ = std::max(reach_, answer.reach);
    latest_ = std::max(latest_, std::ceil(answer.delay));
    earliest = std::min(earliest, std::floor(answer.delay));
    alike_ = alike_ && same(answer, answers.front());
  }
  spread_ = latest_ - earliest;
}

void PathTrial::run(std::span<TimedPiece const> path, std::span<TriedCorner> corners, TrialSpan const& span) {
  corners_ = corners;
  pending_.clear();
  proves_ = span.proves;
  before_.reset();
  double const oldest = std::max(path.front().start, span.from - cycles_before());
  double const first = std::ceil(oldest - span.phase - same_time) + span.phase;
  double const last = span.to + cycles_after() + 1;
  Walk walk{.path = path, .corners = corners, .piece = 0, .corner = 0};
  auto const later = std::upper_bound(path.begin(), path.end(), first + same_time,
                                      [](double t, TimedPiece const& piece) { return t < piece.start; });
  walk.piece = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, later - path.begin())) - 1;
  ContourPoint point;
  Looked looked;
  double place = 0;
  auto const go_to = [&](double time) {
    point = {};
    if (walk.ended()) {
      auto const& end = path.back();
      point.nominal = end.at(end.length);
      looked = {.piece = &end, .way = end.length};
      place = looked.place();
      return;
    }
    auto const& piece = path[walk.piece];
    double const within = std::max(0.0, time - piece.start);
    double const way = piece.phase.way_at(within);
    point.nominal = piece.at(way);
    point.velocity = piece.phase.velocity_at(within);
    looked = {.piece = &piece, .way = way};
    place = looked.place();
  };
  auto const look_at = [&] {
    point.block = walk.nearest(place);
    pending_.push_back(looked);
    meter_.corner(point);
  };
  auto const is_wanted = [&](double time) {
    return time >= span.from - same_time && time <= span.to + same_time;
  };
  // Between setpoints and corners the path may be a little further away than at them.
  double seen = first;
  auto const look_between = [&](double time) {
    double const middle = (seen + time) / 2;
    seen = time;
    if (!span.proves || !is_wanted(middle)) return;
    go_to(middle);
    look_at();
  };
  auto const pass_ends = [&](double time) {
    for (; !walk.ended() && path[walk.piece].end() <= time + same_time; ++walk.piece) {
      auto const& piece = path[walk.piece];
      if (!piece.ends_block || !is_wanted(piece.end())) continue;
      look_between(piece.end());
      ContourPoint corner;
      corner.nominal = piece.at(piece.length);
      corner.block = walk.nearest(piece.place + piece.length);
      pending_.push_back({.piece = &piece, .way = piece.length});
      meter_.corner(corner);
    }
  };
  go_to(first);
  walk.begin_at(place);
  static_cast<void>(runtime_->reset(point.nominal));
  meter_.begin(answers_, point.nominal);
  time_of_first_ = first - static_cast<double>(meter_.cycles() - 1);
  Point filtered{};
  auto const cycles = static_cast<std::int64_t>(std::floor(last - first));
  for (std::int64_t n = 1; n <= cycles; ++n) {
    double const cycle = first + static_cast<double>(n);
    double const half = cycle - 0.5;
    if (working_ && n % trial_cycles_per_call == 0) working_();
    pass_ends(half);
    look_between(half);
    if (span.proves && is_wanted(half)) {
      go_to(half);
      look_at();
    }
    pass_ends(cycle);
    look_between(cycle);
    go_to(cycle);
    static_cast<void>(runtime_->step(point.nominal, filtered));
    if (!is_wanted(cycle)) {
      meter_.pass(point.nominal, filtered);
      continue;
    }
    point.block = walk.nearest(place);
    auto& corner = corners[point.block];
    if (std::abs(cycle - corner.time) <= reach_) {
      corner.fastest = std::max(corner.fastest, point.velocity);
    } else if (corner.whole) {
      corner.far_fastest = std::max(corner.far_fastest, point.velocity);
    }
    pending_.push_back(looked);
    meter_.cycle(point, filtered);
  }
  meter_.finish();
}

bool PathTrial::is_near(TriedCorner const& corner, double time) const {
  return std::abs(time - corner.time) <= reach();
}

void PathTrial::measured(MeasuredPoint const& point) {
  Looked const now = pending_.front();
  pending_.pop_front();
  double const error = take(point);
  if (proves_ && before_) {
    // A corner before it is where its block begins.
    double const begin = now.piece->place - now.piece->from;
    Sample const a{.along = std::max(0.0, before_->place() - begin), .error = error_before_};
    Sample const b{.along = now.piece->from + now.way, .error = error};
    look_between(point, now.piece->path, a, b, most_halvings);
  }
  before_ = now;
  error_before_ = error;
}

/// Where the nearest point of the filtered path jumps from one side of a corner to the other, the error has
/// an edge.
void PathTrial::look_between(MeasuredPoint const& point, Segment const& block, Sample const& a,
                             Sample const& b, int halvings_left) {
  bool const is_far_below = std::max(a.error, b.error) < near_tolerance * *proves_;
  if (halvings_left == 0 || is_far_below || !(a.along < b.along)) return;
  Sample middle{.along = (a.along + b.along) / 2};
  ContourPoint between = point.point;
  between.nominal = block.at(middle.along);
  middle.error = take(meter_.look(between));
  if (std::abs(middle.error - (a.error + b.error) / 2) <= straight_within * *proves_) return;
  look_between(point, block, a, middle, halvings_left - 1);
  look_between(point, block, middle, b, halvings_left - 1);
}

/// Counts a point to its corner.
double PathTrial::take(MeasuredPoint const& point) {
  auto const at = point.point.block;
  double const error = *std::max_element(point.axis_error.begin(), point.axis_error.end());
  double const time = time_of_first_ + static_cast<double>(point.point.cycle);
  auto* corner = &corners_[at];
  // A neighbour whose kernels reach further bends the path beyond this corner's.
  if (corner->whole && !is_near(*corner, time)) {
    if (at > 0 && is_near(corners_[at - 1], time)) {
      corner = &corners_[at - 1];
    } else if (at + 1 < corners_.size() && is_near(corners_[at + 1], time)) {
      corner = &corners_[at + 1];
    } else {
      corner->far_error = std::max(corner->far_error, error);
      return error;
    }
  }
  corner->error = std::max(corner->error, error);
  return error;
}

}  // namespace axisc::motion
