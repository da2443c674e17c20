#include "axisc/answers/comparison/compare_formats.hpp"

#include "axisc/answers/execution/recorded_axis.hpp"
#include "axisc/answers/json_text.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/terminal.hpp"

#include <algorithm>
#include <array>

namespace axisc::says {

constexpr Sentence compared{
    "axis {axis}, {input} beside {output}: {compared} of {cycles} cycles count (lost {lost}, repeated "
    "{repeated})",
    "Achse {axis}, {input} neben {output}: {compared} von {cycles} Zyklen zählen (verloren {lost}, "
    "wiederholt "
    "{repeated})"};
constexpr Sentence jumps_taken_out{"jumps by the modulo range, taken out: {jumps}",
                                   "Sprünge um den Modulobereich, herausgerechnet: {jumps}"};
constexpr Sentence found_on{"found: #FILTER ON at cycle {cycle}", "gefunden: #FILTER ON in Zyklus {cycle}"};
constexpr Sentence found_off{"found: #FILTER OFF at cycle {cycle}",
                             "gefunden: #FILTER OFF in Zyklus {cycle}"};
constexpr Sentence is_same{"the same: the control does what axisc computes",
                           "gleich: die Steuerung tut, was axisc rechnet"};
constexpr Sentence is_delayed{"the same but for a delay (in cycles: {delay})",
                              "gleich bis auf eine Verzögerung (in Zyklen: {delay})"};
constexpr Sentence is_different{"different: the control does not do what axisc computes",
                                "verschieden: die Steuerung tut nicht, was axisc rechnet"};
constexpr Sentence too_little{
    "cannot tell: the axis moves too little; record several moves with sharp changes of velocity",
    "nicht entscheidbar: die Achse bewegt sich zu wenig; mehrere Bewegungen mit harten "
    "Geschwindigkeitswechseln aufzeichnen"};
constexpr Sentence deviation{
    "largest deviation {largest} {unit}, rms {rms} {unit}; rounding of the recording explains "
    "{allowed_largest} {unit}, rms {allowed} {unit}",
    "größte Abweichung {largest} {unit}, Effektivwert {rms} {unit}; das Runden der Aufzeichnung erklärt "
    "{allowed_largest} {unit}, Effektivwert {allowed} {unit}"};
constexpr Sentence explained_by{
    "what fits: {reading}; largest deviation {largest} {unit}, rms {rms} {unit}, delay in cycles {delay}",
    "dazu passt: {reading}; größte Abweichung {largest} {unit}, Effektivwert {rms} {unit}, Verzögerung in "
    "Zyklen {delay}"};
constexpr Sentence next_one{
    "the next, which does not fit: {reading}; largest deviation {largest} {unit}, rms {rms} {unit}",
    "das nächste, das nicht passt: {reading}; größte Abweichung {largest} {unit}, Effektivwert {rms} {unit}"};
constexpr Sentence equal_readings{"{reading} (the same with these lists: {others})",
                                  "{reading} (mit diesen Listen dasselbe: {others})"};
constexpr Sentence lists_tell{
    "only lists with other values, such as another order, tell what is the same with these",
    "was mit diesen Listen dasselbe ist, unterscheiden nur Listen mit anderen Werten, etwa einer anderen "
    "Ordnung"};
constexpr Sentence left_open{"\"{key}\" is left open: {possible} explain this recording alike",
                             "\"{key}\" bleibt offen: {possible} erklären diese Aufzeichnung gleich gut"};
constexpr Sentence setting_in_force{"the present setting", "die jetzige Einstellung"};
constexpr Sentence fits_nothing{"no known reading fits", "keine bekannte Lesart passt"};
constexpr Sentence fits_several{"the recording does not tell these readings apart:",
                                "die Aufzeichnung unterscheidet diese Lesarten nicht:"};
constexpr Sentence fits_too{"this motion does not tell it from these readings:",
                            "diese Bewegung unterscheidet es nicht von diesen Lesarten:"};
constexpr Sentence velocity_jump_tells{
    "to tell them apart, record a jump of the velocity to {feed} {unit}/min, without #SLOPE, and back",
    "um sie zu unterscheiden, einen Geschwindigkeitssprung auf {feed} {unit}/min aufzeichnen, ohne #SLOPE, "
    "und zurück"};
constexpr Sentence step_tells{
    "to tell them apart, record a step of the position by {step} {unit}; a jump of the velocity to {feed} "
    "{unit}/min is not enough",
    "um sie zu unterscheiden, einen Positionssprung um {step} {unit} aufzeichnen; ein "
    "Geschwindigkeitssprung auf {feed} {unit}/min reicht nicht"};
constexpr Sentence nothing_tells{
    "they compute the same within this resolution, even behind a step of {step} {unit}: it does not matter "
    "which one the control has",
    "sie rechnen innerhalb dieser Auflösung dasselbe, sogar nach einem Sprung um {step} {unit}: welche die "
    "Steuerung hat, spielt keine Rolle"};
constexpr Sentence as_listed{"what axisc computes", "was axisc rechnet"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr int digits = 3;
using comparison::Verdict;

std::string say(SentenceRef sentence, Language language, std::vector<Argument> arguments = {}) {
  return render({.sentence = sentence, .arguments = std::move(arguments)}, language);
}

std::string words(std::vector<comparison::Departure> const& departures, Language language) {
  std::string text;
  for (auto const& departure : departures) {
    text += (text.empty() ? "" : " + ") + say(departure.meaning, language);
  }
  return text.empty() ? say(says::as_listed, language) : text;
}

std::string ids(std::vector<comparison::Departure> const& departures) {
  std::string text;
  for (auto const& departure : departures) text += (text.empty() ? "" : ", ") + json_string(departure.id);
  return "[" + text + "]";
}

std::string_view word(comparison::Comparison const& result) {
  constexpr std::array<std::string_view, 4> names{"same", "delayed", "different", "cannot-tell"};
  return names[static_cast<std::size_t>(result.verdict)];
}

class Writer {
 public:
  Writer(ShownComparison const& shown, Language language) : shown_(shown), language_(language) {}

  [[nodiscard]] std::string text() {
    auto const& result = shown_.result;
    line(says::compared, {{"axis", printable(shown_.axis)},
                          {"input", printable(shown_.input_name)},
                          {"output", printable(shown_.output_name)},
                          {"compared", std::to_string(result.compared)},
                          {"cycles", std::to_string(shown_.cycles)},
                          {"lost", std::to_string(result.lost)},
                          {"repeated", std::to_string(shown_.repeated)}});
    if (shown_.jumps > 0) line(says::jumps_taken_out, {{"jumps", std::to_string(shown_.jumps)}});
    for (auto const& one : shown_.found_switches) {
      line(one.kernel ? says::found_on : says::found_off, {{"cycle", std::to_string(one.cycle)}});
    }
    verdict();
    if (result.verdict == Verdict::cannot_tell) return text_;
    line(says::deviation, {{"largest", length(result.listed.largest)},
                           {"rms", length(result.listed.rms)},
                           {"allowed", length(result.allowed_rms)},
                           {"allowed_largest", length(result.allowed_largest)},
                           {"unit", unit()}});
    if (result.verdict == Verdict::different) {
      if (result.fitting.empty()) line(says::fits_nothing);
      if (result.fitting.size() > 1) line(says::fits_several);
    } else if (!result.fitting.empty()) {
      line(says::fits_too);
    }
    for (auto const& one : result.fitting) explained(says::explained_by, one);
    if (result.verdict == Verdict::different && result.next) explained(says::next_one, *result.next);
    if (shown_.telling) motion(*shown_.telling);
    bool const has_equals =
        std::any_of(result.fitting.begin(), result.fitting.end(),
                    [](comparison::Explained const& one) { return !one.reading.equals.empty(); });
    if (has_equals) line(says::lists_tell);
    return text_;
  }

 private:
  [[nodiscard]] std::string length(double value) const {
    return format_rounded(value * shown_.thousandths, digits).in(language_);
  }
  [[nodiscard]] std::string unit() const {
    return shown_.is_rotary ? exact_number(0.001).in(language_) + "°" : "µm";
  }
  void line(SentenceRef sentence, std::vector<Argument> arguments = {}) {
    text_ += say(sentence, language_, std::move(arguments)) + "\n";
  }
  void verdict() {
    switch (shown_.result.verdict) {
      case Verdict::same:
        line(says::is_same);
        break;
      case Verdict::delayed:
        line(says::is_delayed, {{"delay", format_rounded(shown_.result.listed.delay_cycles, digits)}});
        break;
      case Verdict::different:
        line(says::is_different);
        break;
      case Verdict::cannot_tell:
        line(says::too_little);
        break;
    }
  }
  void motion(comparison::Motion telling) {
    constexpr std::array<SentenceRef, 3> sentences{says::velocity_jump_tells, says::step_tells,
                                                   says::nothing_tells};
    line(sentences.at(static_cast<std::size_t>(telling)), {{"feed", format_rounded(telling_feed, digits + 1)},
                                                           {"step", format_rounded(telling_step, digits)},
                                                           {"unit", shown_.is_rotary ? "°" : "mm"}});
  }
  void explained(SentenceRef sentence, comparison::Explained const& one) {
    line(sentence, {{"reading", reading_words(one.reading, language_)},
                    {"largest", length(one.residual.largest)},
                    {"rms", length(one.residual.rms)},
                    {"delay", format_rounded(one.residual.delay_cycles, digits)},
                    {"unit", unit()}});
  }

  ShownComparison const& shown_;
  Language language_;
  std::string text_;
};

std::string_view word(std::optional<comparison::Motion> telling) {
  constexpr std::array<std::string_view, 3> names{R"("velocity-jump")", R"("step")", R"("none")"};
  return telling ? names.at(static_cast<std::size_t>(*telling)) : "null";
}

std::string json_residual(comparison::Residual const& residual, double thousandths) {
  return "\"delay_cycles\": " + json_number(residual.delay_cycles) +
         ", \"largest\": " + json_number(residual.largest * thousandths) +
         ", \"rms\": " + json_number(residual.rms * thousandths);
}

std::string json_explained(comparison::Explained const& one, ShownComparison const& shown,
                           Language language) {
  std::string equals;
  for (auto const& other : one.reading.equals) equals += (equals.empty() ? "" : ", ") + ids(other);
  return "{\"readings\": " + ids(one.reading.departures) + ", \"equal_with_these_lists\": [" + equals +
         "], \"meaning\": " + json_string(reading_words(one.reading, language)) + ", " +
         json_residual(one.residual, shown.thousandths) + "}";
}

}  // namespace

std::string reading_words(comparison::Reading const& reading, Language language) {
  auto const own = words(reading.departures, language);
  std::string others;
  for (auto const& other : reading.equals) others += (others.empty() ? "" : "; ") + words(other, language);
  return others.empty() ? own : say(says::equal_readings, language, {{"reading", own}, {"others", others}});
}

std::string open_setting_text(comparison::OpenSetting const& open, Language language) {
  std::string possible;
  for (auto const id : open.possible) {
    possible += (possible.empty() ? "" : ", ") +
                (id.empty() ? say(says::setting_in_force, language) : std::string(id));
  }
  return say(says::left_open, language, {{"key", std::string(open.key)}, {"possible", possible}});
}

std::string compare_text(ShownComparison const& shown, Language language) {
  return Writer(shown, language).text();
}

std::string compare_json(ShownComparison const& shown, Language language) {
  auto const& result = shown.result;
  std::string switches;
  for (auto const& one : shown.found_switches) {
    if (!switches.empty()) switches += ", ";
    switches += R"({"cycle": )" + std::to_string(one.cycle) + R"(, "command": )" +
                json_string(one.kernel ? "#FILTER ON" : "#FILTER OFF") + "}";
  }
  std::string fitting;
  for (auto const& one : result.fitting) {
    fitting += (fitting.empty() ? "\n    " : ",\n    ") + json_explained(one, shown, language);
  }
  return "{\n  \"version\": 1,\n  \"axis\": " + json_string(shown.axis) +
         ",\n  \"input\": " + json_string(shown.input_name) +
         ",\n  \"output\": " + json_string(shown.output_name) +
         ",\n  \"cycles\": " + std::to_string(shown.cycles) +
         ",\n  \"compared\": " + std::to_string(result.compared) +
         ",\n  \"lost\": " + std::to_string(result.lost) +
         ",\n  \"repeated\": " + std::to_string(shown.repeated) +
         ",\n  \"jumps\": " + std::to_string(shown.jumps) + ",\n  \"found_switches\": [" + switches + "]" +
         ",\n  \"unit\": " + json_string(shown.is_rotary ? "0.001°" : "µm") +
         ",\n  \"verdict\": " + json_string(word(result)) +
         ",\n  \"allowed_rms\": " + json_number(result.allowed_rms * shown.thousandths) +
         ",\n  \"allowed_largest\": " + json_number(result.allowed_largest * shown.thousandths) +
         ",\n  \"listed\": {" + json_residual(result.listed, shown.thousandths) + "},\n  \"fitting\": [" +
         fitting + (fitting.empty() ? "" : "\n  ") +
         "],\n  \"next\": " + (result.next ? json_explained(*result.next, shown, language) : "null") +
         ",\n  \"telling_motion\": " + std::string(word(shown.telling)) + "\n}\n";
}

std::string design_settings(design::Readings const& readings) {
  std::string members;
  auto const add = [&members](std::string_view key, auto reading) {
    if (reading == decltype(reading)::documented) return;
    if (!members.empty()) members += ", ";
    members += json_string(key) + ": " + json_string(word_of(reading));
  };
  add("filters", readings.filters);
  add("kernels", readings.kernels);
  add("cycle_time", readings.cycle_time);
  return "{\n  \"design\": {" + members + "}\n}\n";
}

}  // namespace axisc
