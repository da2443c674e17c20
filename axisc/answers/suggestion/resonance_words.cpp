#include "axisc/answers/suggestion/resonance_words.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/format_number.hpp"

#include <string_view>

namespace axisc::says {

constexpr Sentence bad_resonance{
    "--resonance needs one to three frequencies below {nyquist} Hz (0.5/T), each perhaps with a damping "
    "ratio below 1, such as `48Hz` or `48Hz:0.03,112Hz`, not \"{value}\"",
    "--resonance braucht eine bis drei Frequenzen unter {nyquist} Hz (0,5/T), jede vielleicht mit einem "
    "Dämpfungsgrad unter 1, etwa `48Hz` oder `48Hz:0.03,112Hz`, nicht \"{value}\""};

}  // namespace axisc::says

namespace axisc {

std::vector<tuning::Resonance> read_resonances(std::string const& words, design::CycleTime cycle_time) {
  auto const refuse = [&] {
    return Failure({says::bad_resonance,
                    {{"nyquist", format_rounded(cycle_time.nyquist().value, 6)}, {"value", words}}});
  };
  std::vector<tuning::Resonance> found;
  for (auto const& word : split_list(words)) {
    auto const colon = word.find(':');
    std::string_view frequency = std::string_view(word).substr(0, colon);
    if (frequency.ends_with("Hz")) frequency.remove_suffix(2);
    auto const hertz = parse_finite(frequency);
    if (!hertz || *hertz < 1 || !(*hertz < cycle_time.nyquist().value)) throw refuse();
    tuning::Resonance resonance{.frequency = *hertz};
    if (colon != std::string::npos) {
      resonance.damping = parse_finite(std::string_view(word).substr(colon + 1));
      if (!resonance.damping || !(*resonance.damping > 0) || !(*resonance.damping < 1)) throw refuse();
    }
    found.push_back(resonance);
  }
  if (found.empty() || found.size() > most_resonances) throw refuse();
  return found;
}

}  // namespace axisc
