#include "axisc/answers/identify/model_refusal.hpp"

#include "analysis/tuning/rigid_model/thresholds.hpp"
#include "axisc/environment/codes.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/joined.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace axisc::says {

constexpr Sentence no_motion{"the axis does not move; record it while it moves to and fro",
                             "die Achse bewegt sich nicht; aufzeichnen, während sie hin und her fährt"};
constexpr Sentence too_short{
    "too short: the axis has to move for {least} s at least, better for 10 s, to and fro",
    "zu kurz: Die Achse muss sich mindestens {least} s bewegen, besser 10 s, hin und her"};
constexpr Sentence one_direction{
    "the axis moves in one direction only, so that friction and gravity cannot be told apart; record ways "
    "back and forth",
    "die Achse bewegt sich nur in einer Richtung, sodass Reibung und Gewicht nicht zu unterscheiden sind; "
    "Wege hin und zurück aufzeichnen"};
constexpr Sentence coarse{
    "the position is too coarse: its steps or its noise hide the acceleration; record the finer measuring "
    "system, or move with more acceleration",
    "die Position ist zu grob: Ihre Stufen oder ihr Rauschen verdecken die Beschleunigung; das feinere "
    "Messsystem aufzeichnen oder mit mehr Beschleunigung fahren"};
constexpr Sentence no_acceleration{
    "only {share} % of the varying force accelerates the axis, and {least} % are needed; record many starts "
    "and stops with full acceleration",
    "nur {share} % der veränderlichen Kraft beschleunigen die Achse, nötig sind {least} %; viele Anfahr- und "
    "Bremsvorgänge mit voller Beschleunigung aufzeichnen"};
constexpr Sentence unexplained{
    "mass, friction and gravity of every other window explain {share} % of the force between them, and "
    "{least} % are needed: something else pushes the axis, or force and position are not of one axis",
    "Masse, Reibung und Gewicht jedes zweiten Fensters erklären {share} % der Kraft dazwischen, nötig "
    "sind {least} %: Etwas anderes schiebt die Achse, oder Kraft und Position sind nicht von einer Achse"};
constexpr Sentence scattered{
    "the mass would be uncertain by {share} %, and {most} % are allowed; record longer, with more "
    "acceleration, at one load",
    "die Masse wäre um {share} % unsicher, erlaubt sind {most} %; länger, mit mehr Beschleunigung und mit "
    "einer Last aufzeichnen"};
constexpr Sentence elastic{
    "the mass would be uncertain by {share} %, and {most} % are allowed: the axis vibrates too much to count "
    "as one mass; record the position of the motor, or softer moves (longer ramp times)",
    "die Masse wäre um {share} % unsicher, erlaubt sind {most} %: Die Achse schwingt zu sehr, um als eine "
    "Masse zu gelten; die Position des Motors oder weichere Bewegungen (längere Rampenzeiten) aufzeichnen"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// By tuning::RigidDoubt.
constexpr std::array<SentenceRef, 8> doubts{says::no_motion, says::too_short,       says::one_direction,
                                            says::coarse,    says::no_acceleration, says::unexplained,
                                            says::scattered, says::elastic};

Wording percent(double share) {
  constexpr double hundred = 100;
  return format_rounded(hundred * share, 2);
}

}  // namespace

Failure model_refusal(std::vector<std::string> const& paths, tuning::RigidModel const& model) {
  using tuning::RigidDoubt;
  auto const doubt = *model.doubt;
  bool const is_uncertain = doubt == RigidDoubt::scattered || doubt == RigidDoubt::elastic;
  double const share = is_uncertain                           ? model.mass.uncertainty / model.mass.value
                       : doubt == RigidDoubt::no_acceleration ? model.accelerating
                                                              : std::max(model.explained, 0.0);
  double const least =
      doubt == RigidDoubt::no_acceleration ? tuning::least_accelerating : tuning::least_explained_force;
  return {joined(paths),
          {{doubts.at(static_cast<std::size_t>(doubt)),
            {{"share", percent(share)},
             {"least",
              doubt == RigidDoubt::too_short ? format_rounded(tuning::shortest_motion, 2) : percent(least)},
             {"most", percent(tuning::largest_mass_uncertainty)}}}},
          csv_malformed};
}

}  // namespace axisc
