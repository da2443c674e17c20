#include "axisc/answers/figures/contour_cases.hpp"

#include "axisc/answers/labels.hpp"
#include "diagnostics/format_number.hpp"

namespace axisc::says {

constexpr Sentence case_order{"{feed} mm/min, order {order}", "{feed} mm/min, Ordnung {order}"};
constexpr Sentence case_feed{"{feed} mm/min", "{feed} mm/min"};
constexpr Sentence case_before{"{case}, before", "{case}, vorher"};
constexpr Sentence case_was{"{quantity}, before", "{quantity}, vorher"};
constexpr Sentence case_is{"{quantity}, now", "{quantity}, jetzt"};
constexpr Sentence case_header{"case", "Fall"};
constexpr Sentence case_plane{"plane", "Ebene"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// The first axis with the one that deviates most; a single axis as if a second one were like it.
std::pair<std::size_t, std::size_t> worst_plane(
    std::vector<motion::ChainAnswer> const& answers, double velocity,
    std::function<double(std::vector<motion::ChainAnswer> const&, double)> const& deviation) {
  if (answers.size() == 1) return {0, 0};
  std::size_t worst = 1;
  double largest = -1;
  for (std::size_t axis = 1; axis < answers.size(); ++axis) {
    double const here = deviation({answers[0], answers[axis]}, velocity);
    if (!(here > largest)) continue;
    largest = here;
    worst = axis;
  }
  return {0, worst};
}

}  // namespace

std::vector<ContourCurve> contour_curves(
    ContourSubject const& subject, ContourRequest const& wanted,
    std::function<double(std::vector<motion::ChainAnswer> const& plane, double velocity)> const& deviation) {
  std::vector<ContourCurve> curves;
  std::size_t colour = 0;
  for (double const feed : wanted.feeds) {
    double const velocity = path_velocity(feed, subject.cycle_time);
    for (auto const& order : wanted.orders) {
      std::string const name =
          order ? subject.say(says::case_order, {{"feed", format_rounded(feed, pictures::shown_digits)},
                                                 {"order", std::to_string(*order)}})
                : subject.say(says::case_feed, {{"feed", format_rounded(feed, pictures::shown_digits)}});
      auto const add = [&](GroupChains& chains, pictures::Role role, std::string shown) {
        auto const answers = chains.answers(order);
        auto const plane = worst_plane(answers, velocity, deviation);
        curves.push_back({.name = std::move(shown),
                          .role = role,
                          .colour = colour,
                          .velocity = velocity,
                          .answers = {answers[plane.first], answers[plane.second]},
                          .plane = plane});
      };
      if (subject.before != nullptr) {
        add(*subject.before, pictures::Role::before, subject.say(says::case_before, {{"case", name}}));
      }
      add(subject.now, pictures::Role::whole, name);
      ++colour;
    }
  }
  return curves;
}

std::string plane_name(ContourSubject const& subject, ContourCurve const& curve) {
  auto const& [first, second] = curve.plane;
  return first == second ? subject.axes[first] : subject.axes[first] + "/" + subject.axes[second];
}

Wording micrometres(double units) {
  return format_rounded(units / motion::units_per_um, pictures::shown_digits);
}

pictures::Table deviation_table(ContourSubject const& subject, std::vector<ContourCurve> const& curves,
                                std::vector<double> const& deviations) {
  pictures::Table table;
  table.header = {subject.say(says::case_header), subject.say(says::case_plane),
                  subject.say(labels::contour_deviation)};
  if (subject.before != nullptr) {
    std::string const quantity = table.header.back();
    table.header.back() = subject.say(says::case_was, {{"quantity", quantity}});
    table.header.push_back(subject.say(says::case_is, {{"quantity", quantity}}));
    table.header.push_back(subject.say(labels::difference));
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].role == pictures::Role::before) continue;
    std::vector<std::string> row{curves[i].name, plane_name(subject, curves[i])};
    if (subject.before != nullptr) row.push_back(micrometres(deviations[i - 1]).in(subject.language));
    row.push_back(micrometres(deviations[i]).in(subject.language));
    if (subject.before != nullptr) {
      row.push_back(micrometres(deviations[i] - deviations[i - 1]).in(subject.language));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace axisc
