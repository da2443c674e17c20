#include "analysis/motion/planning/hsc_stretches.hpp"

#include "analysis/motion/planning/phase_cutter.hpp"

#include <algorithm>
#include <iterator>
#include <list>
#include <memory>
#include <utility>

namespace axisc::motion {
namespace {

/// Rounding of velocities.
constexpr double same_velocity = 1e-11;

/// Ramps of several elements.
struct Weakest {
  Ramp up, down;
};

/// Elements from `first` up to `end`.
struct Stretch {
  std::size_t first = 0, end = 0;
  std::unique_ptr<Weakest> ramps;  ///< none: one element, with its own
  PathElement whole;
  double next_allowed = -1;  ///< with which whole.allowed was found
  double velocity_in = -1, wanted = -1;
  Exit exit;  ///< found with these
  /// Between these velocities nothing exceeds its limit.
  double kept_in = -1, kept_out = -1;
  double middle = 0;  ///< along its middle, of the motion that was looked at

  [[nodiscard]] bool is_single() const { return end - first == 1; }
};

/// The weakest acceleration and jerk of ramps.
Ramp weakest(std::span<PathElement const> elements, Ramp const* PathElement::*which) {
  RampTimes weak{.acceleration = unlimited};
  double slow_jerk = unlimited;
  double fast_jerk = unlimited;
  for (auto const& element : elements) {
    auto const& times = (element.*which)->times();
    weak.acceleration = std::min(weak.acceleration, times.acceleration);
    slow_jerk = std::min(slow_jerk, times.acceleration / times.at_slow_end);
    fast_jerk = std::min(fast_jerk, times.acceleration / times.at_fast_end);
  }
  weak.at_slow_end = weak.acceleration / slow_jerk;
  weak.at_fast_end = weak.acceleration / fast_jerk;
  return {weak, (elements.front().*which)->rules()};
}

Stretch stretch_of(std::span<PathElement const> elements, std::size_t first, std::size_t end) {
  Stretch stretch;
  stretch.first = first;
  stretch.end = end;
  stretch.whole = elements[first];
  if (stretch.is_single()) return stretch;
  auto const parts = elements.subspan(first, end - first);
  stretch.ramps = std::make_unique<Weakest>();
  *stretch.ramps = {.up = weakest(parts, &PathElement::up), .down = weakest(parts, &PathElement::down)};
  stretch.whole.up = &stretch.ramps->up;
  stretch.whole.down = &stretch.ramps->down;
  stretch.whole.length = 0;
  for (auto const& part : parts) {
    stretch.whole.length += part.length;
    stretch.whole.velocity = std::max(stretch.whole.velocity, part.velocity);
  }
  return stretch;
}

bool is_alike(PathElement const& before, PathElement const& after) {
  return before.across && after.across && before.up->is_step() == after.up->is_step() &&
         before.up->rules().sine == after.up->rules().sine;
}

class Plan {
 public:
  Plan(std::span<PathElement const> elements, double velocity, bool ends, std::size_t place)
      : elements_(elements), velocity_(velocity), ends_(ends), places_(elements.size() + 1, 0) {
    places_.front() = places_.back() = places_[place] = 1;
    for (std::size_t i = 1; i < elements.size(); ++i) {
      if (!is_alike(elements[i - 1], elements[i]) || !(elements[i].entry > 0)) places_[i] = 1;
    }
  }

  std::vector<StretchPart> run() {
    append_between_places(0, elements_.size(), stretches_.end());
    do {
      choose();
    } while (split());
    parts_.resize(elements_.size());
    for (auto at = stretches_.begin(); at != stretches_.end(); ++at) share_out(*at, passed_of(at));
    return std::move(parts_);
  }

 private:
  using Stretches = std::list<Stretch>;

  void append_between_places(std::size_t first, std::size_t end, Stretches::const_iterator before) {
    while (first < end) {
      std::size_t next = first + 1;
      while (places_[next] == 0) ++next;
      stretches_.insert(before, stretch_of(elements_, first, next));
      first = next;
    }
  }

  /// As velocity_window.hpp says, computed only where something changed.
  void choose() {
    double next = 0;
    for (auto at = stretches_.end(); at != stretches_.begin();) {
      auto& stretch = *--at;
      auto& whole = stretch.whole;
      if (std::exchange(stretch.next_allowed, next) != next) {
        double braking = whole.down->fastest(next, whole.length);
        if (velocity_ > 0) braking = std::max(braking, whole.down->fastest(0, whole.length));
        whole.allowed = std::min(whole.entry, braking);
      }
      next = whole.allowed;
    }
    double velocity = velocity_;
    for (auto at = stretches_.begin(); at != stretches_.end(); ++at) {
      auto& stretch = *at;
      auto const after = std::next(at);
      double const wanted = after != stretches_.end() ? after->whole.allowed : 0;
      if (stretch.velocity_in != velocity || stretch.wanted != wanted) {
        stretch.velocity_in = velocity;
        stretch.wanted = wanted;
        stretch.exit = exit_of(stretch.whole, velocity, wanted);
      }
      velocity = stretch.exit.velocity;
    }
  }

  /// False where nothing exceeds its limits. Stretches that did not change stay.
  bool split() {
    bool splits = false;
    for (auto at = stretches_.begin(); at != stretches_.end();) {
      auto& stretch = *at;
      bool const is_known =
          stretch.kept_in == stretch.velocity_in && stretch.kept_out == stretch.exit.velocity;
      if (stretch.is_single() || is_known || !finds_places(stretch)) {
        stretch.kept_in = stretch.velocity_in;
        stretch.kept_out = stretch.exit.velocity;
        ++at;
        continue;
      }
      splits = true;
      append_between_places(stretch.first, stretch.end, at);
      at = stretches_.erase(at);
    }
    return splits;
  }

  [[nodiscard]] PassedElement passed_of(Stretches::const_iterator at) const {
    auto const& stretch = *at;
    auto const after = std::next(at);
    auto const* const next = after != stretches_.end() ? &after->whole : nullptr;
    double const out = stretch.exit.velocity;
    return {.element = stretch.whole,
            .velocity_in = stretch.velocity_in,
            .velocity_middle = 0,
            .velocity_out = out,
            .limited_by = cause_of(out, next, false, ends_),
            .waits_for_blocks = false,
            .is_possible = stretch.exit.is_possible};
  }

  bool finds_places(Stretch& stretch) {
    if (!stretch.exit.is_possible) {
      std::fill(places_.begin() + static_cast<std::ptrdiff_t>(stretch.first),
                places_.begin() + static_cast<std::ptrdiff_t>(stretch.end), char{1});
      return true;
    }
    PassedElement passed;
    passed.element = stretch.whole;
    passed.velocity_in = stretch.velocity_in;
    passed.velocity_out = stretch.exit.velocity;
    complete(passed);
    stretch.middle = passed.velocity_middle;
    find_phases(passed);
    exceeded_.clear();
    lowest_exceeded_ = std::max(passed.velocity_in, passed.velocity_middle);
    PhaseCutter cutter(phases_);
    double skipped = 0;
    for (std::size_t i = stretch.first; i < stretch.end; ++i) {
      auto const& element = elements_[i];
      bool const counts_before = i > stretch.first && may_count(element.entry);
      bool const counts_within = may_count(element.velocity);
      if ((counts_before || counts_within) && skipped > 0) cutter.advance(std::exchange(skipped, 0));
      if (counts_before) exceed(cutter.velocity(), element.entry, i, i);
      if (counts_within) {
        cutter.advance(length_until_cut(stretch, i));
        exceed(cutter.highest(), element.velocity, i, i + 1);
      } else {
        skipped += element.length;
      }
    }
    return split_at_lowest();
  }

  void find_phases(PassedElement const& passed) {
    phases_.clear();
    append_profile(task_of(passed), passed.velocity_middle, phases_);
  }

  /// Only the lowest limits become places: a higher one than that of which it is known need not be looked at.
  [[nodiscard]] bool may_count(double limit) const { return limit <= lowest_exceeded_ * (1 + same_velocity); }

  void exceed(double velocity, double limit, std::size_t from, std::size_t to) {
    if (!(velocity > limit * (1 + same_velocity))) return;
    exceeded_.push_back({limit, from, to});
    lowest_exceeded_ = std::min(lowest_exceeded_, limit);
  }

  bool split_at_lowest() {
    bool splits = false;
    for (auto const& one : exceeded_) {
      if (!may_count(one.limit)) continue;
      splits = splits || places_[one.from] == 0 || places_[one.to] == 0;
      places_[one.from] = places_[one.to] = 1;
    }
    return splits;
  }

  /// The last element takes what rounding leaves.
  [[nodiscard]] double length_until_cut(Stretch const& stretch, std::size_t at) const {
    if (at + 1 == stretch.end) return unlimited;
    return elements_[at].length;
  }

  /// The motion of a stretch to its elements.
  void share_out(Stretch const& stretch, PassedElement passed) {
    complete(passed, stretch.is_single() ? middle_velocity(task_of(passed)) : stretch.middle);
    find_phases(passed);
    if (stretch.is_single()) {
      parts_[stretch.first] = {.passed = passed, .phases = phases_, .is_place = true};
      return;
    }
    PhaseCutter cutter(phases_);
    double velocity = passed.velocity_in;
    for (std::size_t i = stretch.first; i < stretch.end; ++i) {
      auto& part = parts_[i];
      bool const is_last = i + 1 == stretch.end;
      cutter.advance(length_until_cut(stretch, i), &part.phases);
      part.passed = passed;
      part.passed.element = elements_[i];
      part.passed.velocity_in = velocity;
      part.passed.velocity_middle = cutter.highest();
      velocity = is_last ? passed.velocity_out : cutter.velocity();
      part.passed.velocity_out = velocity;
      part.is_place = is_last || cutter.is_steady();
      part.passed.limited_by = cause_within(stretch, passed, i);
    }
  }

  [[nodiscard]] LimitedBy cause_within(Stretch const& stretch, PassedElement const& passed,
                                       std::size_t at) const {
    auto const& part = parts_[at].passed;
    auto const& element = part.element;
    if (part.velocity_middle >= element.velocity * (1 - same_velocity)) return element.velocity_cause;
    if (at + 1 == stretch.end) return passed.limited_by;
    if (part.velocity_out >= elements_[at + 1].entry * (1 - same_velocity)) {
      return elements_[at + 1].entry_cause;
    }
    return part.velocity_out < part.velocity_in ? LimitedBy::braking : LimitedBy::axis;
  }

  struct Exceeded {
    double limit = 0;
    std::size_t from = 0, to = 0;  ///< places
  };

  std::span<PathElement const> elements_;
  double velocity_;
  bool ends_;
  std::vector<char> places_;  ///< before each element, and at the end
  Stretches stretches_;
  std::vector<Exceeded> exceeded_;
  double lowest_exceeded_ = 0;  ///< at first the highest velocity of the motion
  std::vector<Phase> phases_;
  std::vector<StretchPart> parts_;
};

}  // namespace

std::vector<StretchPart> plan_stretches(std::span<PathElement const> elements, double velocity, bool ends,
                                        std::size_t place) {
  return Plan(elements, velocity, ends, place).run();
}

}  // namespace axisc::motion
