#include "analysis/comparison/motion/move_candidates.hpp"

#include "analysis/comparison/motion/telling_moves.hpp"
#include "design/units.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace axisc::comparison {

namespace {

/// Of accelerations, in percent: a lower one is reached on a shorter way.
constexpr std::array accelerations{100.0, 50.0, 20.0, 10.0};
constexpr std::array feeds{3000.0, 6000.0, 12000.0};  // mm/min or °/min
constexpr std::array radii{2.0, 5.0, 10.0, 20.0};

struct Way {
  std::size_t axis = 0;
  double length = 0;  ///< mm or degrees
};
using Ways = std::vector<Way>;

std::string number(double value) {
  return format_exact(value);
}

struct Plane {
  std::string_view word;
  char first, second;
  std::string_view to_center;  ///< along the first axis
};
constexpr std::array planes{Plane{"G17", 'X', 'Y', "I"}, Plane{"G18", 'Z', 'X', "K"},
                            Plane{"G19", 'Y', 'Z', "J"}};

class Candidates {
 public:
  Candidates(motion::ProgramChannel const& channel, motion::PathDynamics const& dynamics)
      : channel_(channel), dynamics_(dynamics) {}

  std::vector<NcLines> of(MotionKey key) {
    switch (key) {
      case MotionKey::projection:
        for_each_pair([this](std::size_t first, std::size_t second) { oblique_lines(first, second); });
        break;
      case MotionKey::borders:
        chain("TRAPEZ", {2, 4, 8});
        chain("TRAPEZ", {5, 10, 20});
        break;
      case MotionKey::sine:
        for (double const acceleration : accelerations) single("SIN2", {5, 20}, acceleration);
        break;
      case MotionKey::circle: circles(); break;
      case MotionKey::corner:
        for_each_pair([this](std::size_t first, std::size_t second) { corners(first, second); });
        break;
      case MotionKey::weights:
        for_each_pair([this](std::size_t first, std::size_t second) { corners(first, second); });
        tangents();
        break;
      case MotionKey::cycles: single("TRAPEZ", {1, 2, 5}, accelerations.front()); break;
      case MotionKey::hsc: chain("HSC", std::vector<double>(10, 2)); break;
    }
    return std::move(found_);
  }

 private:
  /// "X10", or "X1=10" where the name is longer than a letter.
  [[nodiscard]] std::string word(Way const& way, double sign) const {
    auto const& name = channel_.axes[way.axis];
    return name + (name.size() > 1 ? "=" : "") + number(sign * way.length);
  }
  [[nodiscard]] std::string line(Ways const& ways, double sign = 1) const {
    std::string text = "G01";
    for (auto const& way : ways) text += " " + word(way, sign);
    return text;
  }
  static std::string feed_word(double feed) { return " F" + number(feed); }
  static std::string slope(std::string_view type) { return "#SLOPE [TYPE=" + std::string(type) + "]"; }

  /// mm/min, no faster than any of the axes.
  [[nodiscard]] std::vector<double> feeds_of(std::vector<std::size_t> const& axes) const {
    double fastest = feeds.back();
    for (auto const axis : axes) {
      fastest =
          std::min(fastest, std::floor(dynamics_.axes[axis].feed.velocity * design::mm_per_min_of_um_per_s));
    }
    std::vector<double> found;
    for (double const feed : feeds) {
      if (feed < fastest) found.push_back(feed);
    }
    found.push_back(std::max(fastest, 1.0));
    return found;
  }

  template <class Take>
  void for_each_pair(Take take) const {
    for (std::size_t first = 0; first < channel_.axes.size(); ++first) {
      for (std::size_t second = first + 1; second < channel_.axes.size(); ++second) {
        if (channel_.rotary[first] == channel_.rotary[second]) take(first, second);
      }
    }
  }

  /// There and back: the same blocks in the opposite order.
  void there_and_back(std::string_view type, std::vector<Ways> blocks, double feed) {
    NcLines lines{slope(type)};
    for (auto const& ways : blocks) lines.push_back(line(ways));
    lines[1] += feed_word(feed);
    lines.push_back(pause_line());
    std::reverse(blocks.begin(), blocks.end());
    for (auto const& ways : blocks) lines.push_back(line(ways, -1));
    lines.push_back(pause_line());
    found_.push_back(std::move(lines));
  }

  void single(std::string_view type, std::vector<double> const& lengths, double acceleration) {
    for (double const length : lengths) {
      for (std::size_t axis = 0; axis < channel_.axes.size(); ++axis) {
        for (double const feed : feeds_of({axis})) {
          there_and_back(type, {{{axis, length}}}, feed);
          weigh(acceleration);
        }
      }
    }
  }

  /// Along one axis.
  void chain(std::string_view type, std::vector<double> const& lengths) {
    for (std::size_t axis = 0; axis < channel_.axes.size(); ++axis) {
      std::vector<Ways> blocks;
      blocks.reserve(lengths.size());
      for (double const length : lengths) blocks.push_back({{axis, length}});
      for (double const feed : feeds_of({axis})) there_and_back(type, blocks, feed);
    }
  }

  void oblique_lines(std::size_t first, std::size_t second) {
    for (auto const& [a, b] : {std::pair{10.0, 10.0}, std::pair{10.0, 5.0}, std::pair{5.0, 10.0}}) {
      for (double const feed : feeds_of({first, second})) {
        there_and_back("TRAPEZ", {{{first, a}, {second, b}}}, feed);
      }
    }
  }

  /// Into 45°, where one axis loses less velocity than the other one gains; back it is the reverse. 90° tells
  /// where the axes allow unlike steps.
  void corners(std::size_t first, std::size_t second) {
    for (double const feed : feeds_of({first, second})) {
      there_and_back("TRAPEZ", {{{first, 10}}, {{first, 10}, {second, 10}}}, feed);
      there_and_back("TRAPEZ", {{{first, 10}}, {{second, 10}}}, feed);
    }
  }

  template <class Take>
  void for_each_plane(Take take) const {
    for (auto const& plane : planes) {
      auto const first = channel_.axis_beginning_with(plane.first);
      auto const second = channel_.axis_beginning_with(plane.second);
      if (first && second) take(plane, *first, *second);
    }
  }

  void circles() {
    for (double const acceleration : accelerations) {
      for (double const radius : radii) {
        for_each_plane([&](Plane const& plane, std::size_t first, std::size_t second) {
          for (double const feed : feeds_of({first, second})) {
            std::string const circle = " " + std::string(plane.to_center) + number(radius);
            found_.push_back(
                {slope("TRAPEZ"), std::string(plane.word) + " G02" + circle + feed_word(feed), pause_line()});
            weigh(acceleration);
          }
        });
      }
    }
  }

  /// From a line into a quarter of a circle without a corner, and straight back.
  void tangents() {
    for (double const radius : radii) {
      for_each_plane([&](Plane const& plane, std::size_t first, std::size_t second) {
        for (double const feed : feeds_of({first, second})) {
          Ways const arc{{first, radius}, {second, radius}};
          std::string const end = word(arc[0], 1) + " " + word(arc[1], 1);
          std::string_view const side = plane.to_center == "I" ? "J" : plane.to_center == "K" ? "I" : "K";
          found_.push_back({slope("TRAPEZ"),
                            std::string(plane.word) + " " + line({{first, 10}}) + feed_word(feed),
                            "G03 " + end + " " + std::string(side) + number(radius), pause_line(),
                            line({{first, 10 + radius}, {second, radius}}, -1), pause_line()});
        }
      });
    }
  }

  /// The last candidate, with less acceleration.
  void weigh(double percent) {
    if (percent == accelerations.front()) return;
    auto& lines = found_.back();
    lines.insert(lines.begin() + 1, "G131=" + number(percent));
    lines.push_back("G131=100");
  }

  motion::ProgramChannel const& channel_;
  motion::PathDynamics const& dynamics_;
  std::vector<NcLines> found_;
};

}  // namespace

std::vector<NcLines> move_candidates(MotionKey key, motion::ProgramChannel const& channel,
                                     motion::PathDynamics const& dynamics) {
  return Candidates(channel, dynamics).of(key);
}

std::string pause_line() {
  return "G04 F" + number(telling_pause_s);
}

}  // namespace axisc::comparison
