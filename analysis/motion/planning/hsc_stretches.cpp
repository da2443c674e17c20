#include "analysis/motion/planning/hsc_stretches.hpp"

#include "analysis/motion/planning/phase_cutter.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace axisc::motion {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
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
    do {
      collect();
      choose();
    } while (split());
    parts_.resize(elements_.size());
    for (std::size_t i = 0; i < stretches_.size(); ++i) share_out(stretches_[i], passed_of(i));
    return std::move(parts_);
  }

 private:
  /// Stretches that did not change stay.
  void collect() {
    std::vector<Stretch> found;
    found.reserve(stretches_.size() + 1);
    std::size_t known = 0;
    for (std::size_t first = 0; first < elements_.size();) {
      std::size_t end = first + 1;
      while (places_[end] == 0) ++end;
      while (known < stretches_.size() && stretches_[known].first < first) ++known;
      bool const is_known =
          known < stretches_.size() && stretches_[known].first == first && stretches_[known].end == end;
      found.push_back(is_known ? std::move(stretches_[known++]) : stretch_of(elements_, first, end));
      first = end;
    }
    stretches_ = std::move(found);
  }

  /// As velocity_window.hpp says, computed only where something changed.
  void choose() {
    double next = 0;
    for (std::size_t i = stretches_.size(); i-- > 0;) {
      auto& stretch = stretches_[i];
      auto& whole = stretch.whole;
      if (std::exchange(stretch.next_allowed, next) != next) {
        double braking = whole.down->fastest(next, whole.length);
        if (velocity_ > 0) braking = std::max(braking, whole.down->fastest(0, whole.length));
        whole.allowed = std::min(whole.entry, braking);
      }
      next = whole.allowed;
    }
    double velocity = velocity_;
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
      auto& stretch = stretches_[i];
      double const wanted = i + 1 < stretches_.size() ? stretches_[i + 1].whole.allowed : 0;
      if (stretch.velocity_in != velocity || stretch.wanted != wanted) {
        stretch.velocity_in = velocity;
        stretch.wanted = wanted;
        stretch.exit = exit_of(stretch.whole, velocity, wanted);
      }
      velocity = stretch.exit.velocity;
    }
  }

  /// False where nothing exceeds its limits.
  bool split() {
    bool splits = false;
    for (auto& stretch : stretches_) {
      bool const is_known =
          stretch.kept_in == stretch.velocity_in && stretch.kept_out == stretch.exit.velocity;
      if (stretch.is_single() || is_known) continue;
      if (split(stretch)) {
        splits = true;
      } else {
        stretch.kept_in = stretch.velocity_in;
        stretch.kept_out = stretch.exit.velocity;
      }
    }
    return splits;
  }

  [[nodiscard]] PassedElement passed_of(std::size_t at) const {
    auto const& stretch = stretches_[at];
    auto const* const next = at + 1 < stretches_.size() ? &stretches_[at + 1].whole : nullptr;
    double const out = stretch.exit.velocity;
    return {.element = stretch.whole,
            .velocity_in = stretch.velocity_in,
            .velocity_middle = 0,
            .velocity_out = out,
            .limited_by = cause_of(out, next, false, ends_),
            .waits_for_blocks = false,
            .is_possible = stretch.exit.is_possible};
  }

  bool split(Stretch const& stretch) {
    if (!stretch.exit.is_possible) {
      std::fill(places_.begin() + static_cast<std::ptrdiff_t>(stretch.first),
                places_.begin() + static_cast<std::ptrdiff_t>(stretch.end), char{1});
      return true;
    }
    PassedElement passed;
    passed.element = stretch.whole;
    passed.velocity_in = stretch.velocity_in;
    passed.velocity_out = stretch.exit.velocity;
    find_profile(passed);
    exceeded_.clear();
    PhaseCutter cutter(phases_);
    double velocity = passed.velocity_in;
    for (std::size_t i = stretch.first; i < stretch.end; ++i) {
      auto const& element = elements_[i];
      if (i > stretch.first) exceed(velocity, element.entry, i, i);
      cutter.advance(length_until_cut(stretch, i));
      exceed(cutter.highest(), element.velocity, i, i + 1);
      velocity = cutter.velocity();
    }
    return split_at_lowest();
  }

  void find_profile(PassedElement& passed) {
    complete(passed);
    phases_.clear();
    append_profile(task_of(passed), passed.velocity_middle, phases_);
  }

  void exceed(double velocity, double limit, std::size_t from, std::size_t to) {
    if (velocity > limit * (1 + same_velocity)) exceeded_.push_back({limit, from, to});
  }

  bool split_at_lowest() {
    double lowest = unlimited;
    for (auto const& one : exceeded_) lowest = std::min(lowest, one.limit);
    bool splits = false;
    for (auto const& one : exceeded_) {
      if (one.limit > lowest * (1 + same_velocity)) continue;
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
    find_profile(passed);
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
  std::vector<Stretch> stretches_;
  std::vector<Exceeded> exceeded_;
  std::vector<Phase> phases_;
  std::vector<StretchPart> parts_;
};

}  // namespace

std::vector<StretchPart> plan_stretches(std::span<PathElement const> elements, double velocity, bool ends,
                                        std::size_t place) {
  return Plan(elements, velocity, ends, place).run();
}

}  // namespace axisc::motion
