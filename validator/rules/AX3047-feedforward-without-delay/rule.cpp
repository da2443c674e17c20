#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/feedforward_view.hpp"

namespace axisc::validator::checks::ax3047::says {

constexpr Sentence headline{
    "without the five cycles of delay only velocity can be fed forward",
    "ohne die fünf Zyklen Verzögerung kann nur die Geschwindigkeit vorgesteuert werden"};
constexpr Sentence limit{"{p_axis} = 1 allows VEL and ADD_VEL in P-AXIS-00223; here it is {value}",
                         "{p_axis} = 1 lässt in P-AXIS-00223 VEL und ADD_VEL zu; hier steht {value}"};
constexpr Sentence reaction{"it takes acceleration and jerk out of P-AXIS-00223",
                            "sie nimmt Beschleunigung und Ruck aus P-AXIS-00223 heraus"};
constexpr Sentence help{"name only VEL or ADD_VEL in P-AXIS-00223, or remove `{parameter}`",
                        "in P-AXIS-00223 nur VEL oder ADD_VEL nennen, oder `{parameter}` entfernen"};

}  // namespace axisc::validator::checks::ax3047::says

namespace axisc::validator::checks::ax3047 {
namespace {

void feedforward_without_delay(AxisContext const& axis, Report& report) {
  EffectiveValue const& undelayed = axis.values.at("vorsteuer.feedforward_without_delay");
  if (!undelayed.is_on()) return;
  FeedforwardView const feedforward(axis.values);
  if (!feedforward.uses(Feedforward::acceleration) && !feedforward.uses(Feedforward::jerk)) return;
  Finding& finding = report.add(undelayed, {says::headline, {}});
  finding.notes.push_back(
      {says::limit,
       {{"p_axis", parameter_number(undelayed)}, {"value", symbol_word(feedforward.quantities)}}});
  finding.help.push_back({says::help, {{"parameter", parameter_name(undelayed)}}});
  react(finding, {says::reaction, {}});
}

}  // namespace

extern constinit Rule const rule{
    .control = "110624",
    .parameters = "vorsteuer.feedforward_without_delay vorsteuer.vorsteuerung",
    .check = feedforward_without_delay,
};

}  // namespace axisc::validator::checks::ax3047
