#include "axisc/answers/suggestion/measured_refusal.hpp"

#include "analysis/tuning/identification/thresholds.hpp"
#include "axisc/environment/codes.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/joined.hpp"
#include "presentation/value.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace axisc::says {

constexpr Sentence too_short{
    "too short for a response: record at least {samples} samples, better 30 s, while noise or many starts "
    "and stops move the axis",
    "zu kurz für einen Frequenzgang: mindestens {samples} Abtastwerte aufzeichnen, besser 30 s, während "
    "Rauschen oder viele Anfahr- und Bremsvorgänge die Achse bewegen"};
constexpr Sentence no_peak{
    "the response shows no resonance from {lowest} Hz on: nothing rises by 6 dB; if the machine vibrates, "
    "record for longer, or another signal (torque and velocity, or setpoint and measured position)",
    "der Frequenzgang zeigt ab {lowest} Hz keine Resonanz: Nichts ragt um 6 dB heraus; schwingt die "
    "Maschine, länger oder ein anderes Signal aufzeichnen (Drehmoment und Geschwindigkeit, oder Sollwert und "
    "gemessene Position)"};
constexpr Sentence no_excitation{
    "the response does not show the resonances: the input has no energy there{place}; record noise or a sine "
    "sweep on the torque, or short moves with full acceleration",
    "der Frequenzgang zeigt die Resonanzen nicht: Der Eingang hat dort keine Energie{place}; Rauschen oder "
    "Gleitsinus auf dem Drehmoment oder kurze Wege mit voller Beschleunigung aufzeichnen"};
constexpr Sentence incoherent{
    "the response does not show the resonances: the output follows something else than the input{place} "
    "(coherence below 0.8); record longer, with a stronger excitation, and with no other axis or spindle "
    "running",
    "der Frequenzgang zeigt die Resonanzen nicht: Der Ausgang folgt etwas anderem als dem Eingang{place} "
    "(Kohärenz unter 0,8); länger aufzeichnen, stärker anregen, ohne dass eine andere Achse oder Spindel "
    "läuft"};
constexpr Sentence uncertain{
    "the response{place} is {ratio} times its standard deviation, and 5 times is needed; record a "
    "minute or more, with a stronger excitation, and with no other axis or spindle running",
    "der Frequenzgang{place} ist das {ratio}-Fache seiner Standardabweichung, nötig ist das Fünffache; "
    "eine Minute oder länger aufzeichnen und stärker anregen, ohne dass eine andere Achse oder Spindel "
    "läuft"};
constexpr Sentence noisy{
    "the response{place} does not rise for certain by 6 dB from the noise around it; record longer, with a "
    "stronger excitation, and with no other axis or spindle running",
    "der Frequenzgang{place} ragt nicht sicher um 6 dB aus dem Rauschen um ihn heraus; länger aufzeichnen, "
    "stärker anregen, ohne dass eine andere Achse oder Spindel läuft"};
constexpr Sentence moving{
    "the response does not show one resonance: the peak{place} is elsewhere in each quarter of the "
    "recording; record at one position of the axes, with one load",
    "der Frequenzgang zeigt nicht eine Resonanz: Die Spitze{place} liegt in jedem Viertel der Aufzeichnung "
    "woanders; in einer Stellung der Achsen und mit einer Last aufzeichnen"};

constexpr Sentence shaken{
    "a line{place} keeps its frequency at every speed, but comes from the mains or goes on while the axis "
    "rests: something else shakes the axis",
    "eine Linie{place} behält ihre Frequenz bei jeder Geschwindigkeit, kommt aber vom Netz oder bleibt, "
    "während die Achse ruht: Etwas anderes schüttelt die Achse"};

constexpr Sentence few_rests{
    "ring-down takes {fewest} rests of 80 ms after a motion, and there are {rests}; record more stops",
    "Ausschwingen braucht {fewest} Stillstände von 80 ms nach einer Bewegung, vorhanden sind {rests}; mehr "
    "Halte aufzeichnen"};
constexpr Sentence no_oscillation{"no oscillation rings down while the setpoint rests",
                                  "keine Schwingung klingt aus, während der Sollwert ruht"};
constexpr Sentence few_periods{
    "an oscillation{place} has too few periods in a rest (2.4); let the axis rest longer after each motion",
    "eine Schwingung{place} hat zu wenige Perioden in einem Stillstand (2,4); die Achse nach jeder Bewegung "
    "länger ruhen lassen"};
constexpr Sentence keeps_on{
    "an oscillation{place} does not die away while the setpoint rests: something else shakes the axis; "
    "switch it off and record again",
    "eine Schwingung{place} klingt nicht aus, während der Sollwert ruht: Etwas anderes rüttelt die Achse; es "
    "ausschalten und noch einmal aufzeichnen"};
constexpr Sentence halves_disagree{
    "an oscillation{place} has another frequency in each half of the rests; record at one position of the "
    "axes, with one load",
    "eine Schwingung{place} hat in jeder Hälfte der Stillstände eine andere Frequenz; in einer Stellung der "
    "Achsen und mit einer Last aufzeichnen"};

constexpr Sentence few_pieces{
    "lines take {fewest} pieces of 0.2 s at constant speed, and there are {pieces}; record longer ways",
    "Linien brauchen {fewest} Stücke von 0,2 s mit gleichbleibender Geschwindigkeit, vorhanden sind "
    "{pieces}; längere Wege aufzeichnen"};
constexpr Sentence one_speed{
    "lines take two speeds, to tell what keeps its frequency from what comes once a turn; repeat at 60 % "
    "override, and give both recordings",
    "Linien brauchen zwei Geschwindigkeiten, um zu unterscheiden, was seine Frequenz behält und was einmal "
    "je Umdrehung kommt; mit 60 % Override wiederholen und beide Aufzeichnungen angeben"};
constexpr Sentence no_lines{"no line in the spectrum keeps its frequency at every speed",
                            "keine Linie im Spektrum behält ihre Frequenz bei jeder Geschwindigkeit"};
constexpr Sentence ambiguous_line{
    "the line{place} is a multiple of what comes once a turn at each of these speeds; repeat at another "
    "override",
    "die Linie{place} ist bei jeder dieser Geschwindigkeiten ein Vielfaches dessen, was einmal je Umdrehung "
    "kommt; mit anderem Override wiederholen"};

constexpr Sentence kinds_disagree{
    "{one} {first} Hz, {other} {second} Hz: not one resonance; record all at one position of the axes, with "
    "one load, or give the recordings that show one of them",
    "{one} {first} Hz, {other} {second} Hz: nicht eine Resonanz; alles in einer Stellung der Achsen und mit "
    "einer Last aufzeichnen oder die Aufzeichnungen angeben, die eine davon zeigen"};
constexpr Sentence files_disagree{
    "{one} shows {first} Hz, {other} {second} Hz: not one resonance; record all at one position of the axes, "
    "with one load",
    "{one} zeigt {first} Hz, {other} {second} Hz: nicht eine Resonanz; alles in einer Stellung der Achsen "
    "und mit einer Last aufzeichnen"};
constexpr Sentence only_one{
    "only {one} shows {first} Hz, and others would show it; record all at one position of the axes, with one "
    "load",
    "nur {one} zeigt {first} Hz, andere würden es auch zeigen; alles in einer Stellung der Achsen und mit "
    "einer Last aufzeichnen"};
constexpr Sentence response_says{"the response shows", "der Frequenzgang zeigt"};
constexpr Sentence ring_down_says{"ring-down", "das Ausschwingen"};
constexpr Sentence lines_say{"lines", "die Linien"};
constexpr Sentence spectrum_says{"the spectrum shows", "das Spektrum zeigt"};

}  // namespace axisc::says

namespace axisc {

namespace {

using namespace tuning;

/// By Doubt, RingDownDoubt, LinesDoubt, Evidence.
constexpr std::array<SentenceRef, 7> response_doubts{says::too_short,  says::no_peak,   says::no_excitation,
                                                     says::incoherent, says::uncertain, says::noisy,
                                                     says::moving};
constexpr std::array<SentenceRef, 5> ring_down_doubts{
    says::few_rests, says::no_oscillation, says::few_periods, says::keeps_on, says::halves_disagree};
constexpr std::array<SentenceRef, 3> line_doubts{says::few_pieces, says::one_speed, says::no_lines};
constexpr std::array<SentenceRef, 4> evidence_says{says::response_says, says::ring_down_says, says::lines_say,
                                                   says::spectrum_says};

template <class Doubt, std::size_t size>
SentenceRef sentence_of(std::array<SentenceRef, size> const& sentences, Doubt doubt) {
  return sentences.at(static_cast<std::size_t>(doubt));
}

Wording place_of(double frequency) {
  return frequency > 0 ? " (" + format_rounded(frequency, 3) + " Hz)" : Wording();
}

Message disagreement_of(std::vector<std::string> const& paths, Disagreement const& found) {
  auto const hertz = [&](std::size_t i) { return format_rounded(found.frequencies.at(i), 3); };
  bool const is_of_files = found.evidence[0] == found.evidence[1];
  if (is_of_files) {
    bool const is_one = found.frequencies[1] == 0 || found.recordings[0] == found.recordings[1];
    return {is_one ? SentenceRef(says::only_one) : says::files_disagree,
            {{"one", paths[found.recordings[0]]},
             {"other", paths[found.recordings[1]]},
             {"first", hertz(0)},
             {"second", hertz(1)}}};
  }
  auto const words = [&](std::size_t i) {
    return presentation::wording_of(sentence_of(evidence_says, found.evidence.at(i)));
  };
  return {says::kinds_disagree,
          {{"one", words(0)}, {"other", words(1)}, {"first", hertz(0)}, {"second", hertz(1)}}};
}

Message response_doubt(Identification const& response) {
  double const ratio = std::max(response.doubtful_ratio, 0.1);
  return {sentence_of(response_doubts, *response.doubt),
          {{"samples", std::to_string(fewest_samples)},
           {"place", place_of(response.doubtful_frequency)},
           {"ratio", format_rounded(ratio, 2)},
           {"lowest", format_rounded(response.lowest, 3)}}};
}

std::string names_of(std::vector<std::string> const& paths) {
  constexpr std::size_t most = 3;
  auto const names = joined(std::span(paths).first(std::min(most, paths.size())));
  return paths.size() > most ? names + ", …" : names;
}

}  // namespace

Failure measured_refusal(std::vector<std::string> const& paths, ModeSearch const& search) {
  if (search.disagreement) {
    return {names_of(paths), {disagreement_of(paths, *search.disagreement)}, csv_malformed};
  }
  std::vector<Message> why;
  if (search.response.doubt) why.push_back(response_doubt(search.response));
  if (search.ring_down && search.rests > 0) {
    why.push_back({sentence_of(ring_down_doubts, search.ring_down->doubt),
                   {{"place", place_of(search.ring_down->frequency)},
                    {"fewest", std::to_string(fewest_rests)},
                    {"rests", std::to_string(search.rests)}}});
  }
  bool const shakes =
      std::any_of(search.others.begin(), search.others.end(), [](tuning::SpectralLine const& line) {
        return line.kind == LineKind::mains || line.kind == LineKind::at_rest;
      });
  // Where something else keeps its frequency, it would not be true that nothing does.
  bool const tells_lines = search.lines && !(shakes && *search.lines == tuning::LinesDoubt::no_lines);
  if (tells_lines && search.pieces > 0) {
    why.push_back({sentence_of(line_doubts, *search.lines),
                   {{"fewest", std::to_string(fewest_pieces)}, {"pieces", std::to_string(search.pieces)}}});
  }
  for (auto const& line : search.others) {
    if (line.kind == LineKind::ambiguous) {
      why.push_back({says::ambiguous_line, {{"place", place_of(line.frequency)}}});
    } else if (line.kind == LineKind::mains || line.kind == LineKind::at_rest) {
      why.push_back({says::shaken, {{"place", place_of(line.frequency)}}});
    }
  }
  return {names_of(paths), std::move(why), csv_malformed};
}

}  // namespace axisc
