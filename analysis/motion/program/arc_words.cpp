#include "analysis/motion/program/arc_words.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc::motion::says {

constexpr Sentence arc_no_center{"a circle needs its centre (I, J, K) or its radius (R)",
                                 "ein Kreis braucht seinen Mittelpunkt (I, J, K) oder seinen Radius (R)"};
constexpr Sentence arc_both{"a circle has either a centre (I, J, K) or a radius (R)",
                            "ein Kreis hat entweder einen Mittelpunkt (I, J, K) oder einen Radius (R)"};
constexpr Sentence arc_no_radius{"the centre of this circle is where it begins",
                                 "der Mittelpunkt dieses Kreises ist sein Anfang"};
constexpr Sentence arc_too_small{"the radius is too small: the circle does not reach its end",
                                 "der Radius ist zu klein: der Kreis erreicht sein Ende nicht"};
constexpr Sentence arc_full_by_radius{
    "a full circle needs its centre (I, J, K): R does not say where it lies",
    "ein Vollkreis braucht seinen Mittelpunkt (I, J, K): R sagt nicht, wo er liegt"};
constexpr Sentence arc_misses_end{
    "the end of this circle is more than 5 µm off: beginning and end have different radii",
    "das Ende dieses Kreises liegt mehr als 5 µm daneben: Anfang und Ende haben verschiedene Radien"};

}  // namespace axisc::motion::says

namespace axisc::motion {
namespace {

/// Position units: nearer ends are the same.
constexpr double same_place = 1e-6;
constexpr double full_turn = 2 * std::numbers::pi;

/// A position in the plane.
struct Place {
  double x = 0, y = 0;
};

double distance(Place a, Place b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// The centre at a distance from both ends, to the left or right of the way from one to the other.
Place center_beside(Place begin, Place end, double radius, bool left) {
  double const chord = distance(begin, end);
  double const height = std::sqrt(std::max(0.0, radius * radius - chord * chord / 4));
  double const aside = (left ? height : -height) / chord;
  return {.x = (begin.x + end.x) / 2 - aside * (end.y - begin.y),
          .y = (begin.y + end.y) / 2 + aside * (end.x - begin.x)};
}

std::variant<Place, ArcMistake> center_of(ArcWords const& words, Place begin, Place end) {
  bool const is_full = distance(begin, end) <= same_place;
  if (words.radius) {
    if (words.to_center_first || words.to_center_second) return ArcMistake::both;
    if (is_full) return ArcMistake::full_by_radius;
    double const radius = std::abs(*words.radius);
    if (2 * radius < distance(begin, end) - 2 * radius_tolerance || !(radius > 0)) {
      return ArcMistake::too_small;
    }
    return center_beside(begin, end, radius, words.clockwise == (*words.radius < 0));
  }
  if (!words.to_center_first && !words.to_center_second) return ArcMistake::no_center;
  Place const center{.x = begin.x + words.to_center_first.value_or(0),
                     .y = begin.y + words.to_center_second.value_or(0)};
  double const radius = distance(center, begin);
  if (!(radius > same_place)) return ArcMistake::no_radius;
  if (is_full) return center;
  double const apart = distance(center, end) - radius;
  if (std::abs(apart) > radius_tolerance) return ArcMistake::misses_end;
  // On the bisector of both ends, as close as can be to the programmed centre.
  double const chord = distance(begin, end);
  Place const along{.x = (end.x - begin.x) / chord, .y = (end.y - begin.y) / chord};
  double const off =
      (center.x - (begin.x + end.x) / 2) * along.x + (center.y - (begin.y + end.y) / 2) * along.y;
  return Place{.x = center.x - off * along.x, .y = center.y - off * along.y};
}

}  // namespace

SentenceRef sentence_of(ArcMistake mistake) {
  switch (mistake) {
    case ArcMistake::no_center: return says::arc_no_center;
    case ArcMistake::both: return says::arc_both;
    case ArcMistake::no_radius: return says::arc_no_radius;
    case ArcMistake::too_small: return says::arc_too_small;
    case ArcMistake::full_by_radius: return says::arc_full_by_radius;
    case ArcMistake::misses_end: return says::arc_misses_end;
  }
  return says::arc_no_center;
}

std::variant<Arc, ArcMistake> arc_of(ArcWords const& words, Point const& begin, Point const& end) {
  Place const from{.x = begin[words.first], .y = begin[words.second]};
  Place const to{.x = end[words.first], .y = end[words.second]};
  auto const found = center_of(words, from, to);
  if (auto const* const mistake = std::get_if<ArcMistake>(&found)) return *mistake;
  auto const center = std::get<Place>(found);
  Arc arc;
  arc.first = words.first;
  arc.second = words.second;
  arc.center_first = center.x;
  arc.center_second = center.y;
  arc.radius = distance(center, from);
  arc.phase = std::atan2(from.y - center.y, from.x - center.x);
  double sweep = std::atan2(to.y - center.y, to.x - center.x) - arc.phase;
  bool const is_full = distance(from, to) <= same_place;
  if (is_full) sweep = 0;
  if (words.clockwise && sweep >= 0) sweep -= full_turn;
  if (!words.clockwise && sweep <= 0) sweep += full_turn;
  arc.sweep = sweep;
  double const in_plane = arc.radius * std::abs(sweep);
  Point rise = minus(end, begin);
  rise[words.first] = rise[words.second] = 0;
  arc.length = std::hypot(in_plane, length(rise));
  arc.share = in_plane / arc.length;
  return arc;
}

}  // namespace axisc::motion
