#include "analysis/motion/program/unused_words.hpp"

#include <string>

namespace axisc::motion::says {

constexpr Sentence not_simulated_axis{"the simulation ignores `{word}`: the channel has no axis {axis}",
                                      "die Simulation übergeht `{word}`: der Kanal hat keine Achse {axis}"};
constexpr Sentence not_simulated_technology{
    "the simulation ignores spindle, tool and M words, such as `{word}`",
    "die Simulation übergeht Spindel-, Werkzeug- und M-Wörter wie `{word}`"};

}  // namespace axisc::motion::says

namespace axisc::motion {
namespace {

/// They share one warning.
constexpr char const* technology_words = "technology";

}  // namespace

void ignore_technology(NcBlock const& block, Token const& token, ProgramProblems& problems) {
  problems.ignore(block, token, technology_words, says::not_simulated_technology);
}

void note_speed(NcBlock const& block, Token const& token, ProgramProblems& problems) {
  problems.ignore_unless_used(block, token, technology_words, says::not_simulated_technology);
}

void take_unused_value(NcBlock const& block, Token const& token, std::string_view name,
                       ProgramProblems& problems) {
  constexpr std::string_view axes = "ABCUVWXYZ";
  constexpr std::string_view technology = "DHT";
  char const letter = name.front();
  if (axes.find(letter) != std::string_view::npos) {
    std::string const axis(1, letter);
    problems.ignore(block, token, axis, says::not_simulated_axis, {{"axis", axis}});
  } else if (technology.find(letter) != std::string_view::npos) {
    ignore_technology(block, token, problems);
  } else {
    problems.refuse(block, token);
  }
}

}  // namespace axisc::motion
