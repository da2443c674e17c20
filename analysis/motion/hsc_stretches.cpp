#include "analysis/motion/hsc_stretches.hpp"

#include "analysis/motion/phase_cutter.hpp"

#include <algorithm>
#include <limits>

namespace axisc::motion {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
/// Rounding of velocities.
constexpr double same_velocity = 1e-11;

/// Elements from `first` up to `end`, their motion, and which limits it exceeds.
struct Stretch {
  std::size_t first = 0, end = 0;
  Ramp up, down;
  PathElement whole;
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
  Stretch stretch{.first = first, .end = end, .up = {}, .down = {}, .whole = elements[first]};
  if (end - first == 1) {
    stretch.up = *elements[first].up;
    stretch.down = *elements[first].down;
    return stretch;
  }
  auto const parts = elements.subspan(first, end - first);
  stretch.up = weakest(parts, &PathElement::up);
  stretch.down = weakest(parts, &PathElement::down);
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
  Plan(std::span<PathElement const> elements, double velocity, bool ends)
      : elements_(elements), velocity_(velocity), ends_(ends), places_(elements.size() + 1, 0) {
    places_.front() = places_.back() = 1;
    for (std::size_t i = 1; i < elements.size(); ++i) {
      if (!is_alike(elements[i - 1], elements[i]) || !(elements[i].entry > 0)) places_[i] = 1;
    }
  }

  std::vector<StretchPart> run() {
    do {
      collect();
      choose();
    } while (split());
    return std::move(parts_);
  }

 private:
  /// Stretches that did not change keep their ramps.
  void collect() {
    std::vector<Stretch> found;
    std::size_t known = 0;
    for (std::size_t first = 0; first < elements_.size();) {
      std::size_t end = first + 1;
      while (places_[end] == 0) ++end;
      while (known < stretches_.size() && stretches_[known].first < first) ++known;
      bool const is_known =
          known < stretches_.size() && stretches_[known].first == first && stretches_[known].end == end;
      found.push_back(is_known ? stretches_[known] : stretch_of(elements_, first, end));
      first = end;
    }
    stretches_ = std::move(found);
  }

  void choose() {
    window_.begin(velocity_, velocity_ > 0);
    for (auto& stretch : stretches_) {
      stretch.whole.up = &stretch.up;
      stretch.whole.down = &stretch.down;
      window_.push(stretch.whole);
    }
    passed_.clear();
    while (window_.size() > 0) passed_.push_back(window_.pass(ends_));
  }

  /// False where nothing exceeds its limits.
  bool split() {
    bool splits = false;
    parts_.resize(elements_.size());
    for (std::size_t i = 0; i < stretches_.size(); ++i) splits = split(stretches_[i], passed_[i]) || splits;
    return splits;
  }

  bool split(Stretch const& stretch, PassedElement const& passed) {
    phases_.clear();
    append_profile(task_of(passed.element, passed.velocity_in, passed.velocity_out), passed.velocity_middle,
                   phases_);
    if (stretch.end - stretch.first == 1) {
      auto& part = parts_[stretch.first];
      part.passed = passed;
      part.phases = phases_;
      part.is_place = true;
      return false;
    }
    if (!passed.is_possible) {
      std::fill(places_.begin() + static_cast<std::ptrdiff_t>(stretch.first),
                places_.begin() + static_cast<std::ptrdiff_t>(stretch.end), char{1});
      return true;
    }
    cut(stretch, passed);
    return split_at_lowest(stretch);
  }

  void cut(Stretch const& stretch, PassedElement const& passed) {
    PhaseCutter cutter(phases_);
    double velocity = passed.velocity_in;
    for (std::size_t i = stretch.first; i < stretch.end; ++i) {
      auto& part = parts_[i];
      part.phases.clear();
      bool const is_last = i + 1 == stretch.end;
      cutter.cut(is_last ? unlimited : elements_[i].length, part.phases);
      part.passed = passed;
      part.passed.element = elements_[i];
      part.passed.velocity_in = velocity;
      part.passed.velocity_middle = velocity;
      for (auto const& phase : part.phases) {
        part.passed.velocity_middle = std::max({part.passed.velocity_middle, phase.velocity});
      }
      velocity = is_last ? passed.velocity_out : cutter.velocity();
      part.passed.velocity_middle = std::max(part.passed.velocity_middle, velocity);
      part.passed.velocity_out = velocity;
      part.is_place = is_last || cutter.is_steady();
      part.passed.limited_by = cause_of(stretch, passed, i);
    }
  }

  [[nodiscard]] LimitedBy cause_of(Stretch const& stretch, PassedElement const& passed,
                                   std::size_t at) const {
    auto const& part = parts_[at].passed;
    auto const& element = part.element;
    if (part.velocity_middle >= element.velocity * (1 - same_velocity)) return element.velocity_cause;
    if (at + 1 == stretch.end) return passed.limited_by;
    if (part.velocity_out >= elements_[at + 1].entry * (1 - same_velocity))
      return elements_[at + 1].entry_cause;
    return part.velocity_out < part.velocity_in ? LimitedBy::braking : LimitedBy::axis;
  }

  bool split_at_lowest(Stretch const& stretch) {
    double lowest = unlimited;
    for_each_exceeded(stretch,
                      [&](double limit, std::size_t, std::size_t) { lowest = std::min(lowest, limit); });
    if (lowest == unlimited) return false;
    bool splits = false;
    for_each_exceeded(stretch, [&](double limit, std::size_t from, std::size_t to) {
      if (limit > lowest * (1 + same_velocity)) return;
      splits = splits || places_[from] == 0 || places_[to] == 0;
      places_[from] = places_[to] = 1;
    });
    return splits;
  }

  /// Calls take(limit, first place, second place).
  template <class Take>
  void for_each_exceeded(Stretch const& stretch, Take take) const {
    for (std::size_t i = stretch.first; i < stretch.end; ++i) {
      auto const& passed = parts_[i].passed;
      auto const& element = elements_[i];
      if (passed.velocity_middle > element.velocity * (1 + same_velocity)) take(element.velocity, i, i + 1);
      if (i > stretch.first && passed.velocity_in > element.entry * (1 + same_velocity))
        take(element.entry, i, i);
    }
  }

  std::span<PathElement const> elements_;
  double velocity_;
  bool ends_;
  std::vector<char> places_;  ///< before each element, and at the end
  std::vector<Stretch> stretches_;
  VelocityWindow window_;
  std::vector<PassedElement> passed_;
  std::vector<Phase> phases_;
  std::vector<StretchPart> parts_;
};

}  // namespace

std::vector<StretchPart> plan_stretches(std::span<PathElement const> elements, double velocity, bool ends) {
  return Plan(elements, velocity, ends).run();
}

}  // namespace axisc::motion
