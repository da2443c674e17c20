#include "axisc/answers/comparison/compare_answer.hpp"

#include "axisc/answers/execution/mapping_table.hpp"
#include "diagnostics/writers/json_stream.hpp"

#include <algorithm>
#include <array>

namespace axisc::says {

constexpr Sentence title{"axis {axis}: {output} beside {input}", "Achse {axis}: {output} neben {input}"};
constexpr Sentence counted{"{compared} of {cycles} cycles count (lost {lost}, repeated {repeated})",
                           "{compared} von {cycles} Zyklen zählen (verloren {lost}, wiederholt {repeated})"};
constexpr Sentence jumps_taken_out{"jumps by the modulo range, taken out: {jumps}",
                                   "Sprünge um den Modulobereich, herausgerechnet: {jumps}"};
constexpr Sentence found{"found: {command} at cycle {cycle}", "gefunden: {command} in Zyklus {cycle}"};
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
constexpr Sentence residual{"largest deviation {largest}, rms {rms}",
                            "größte Abweichung {largest}, Effektivwert {rms}"};
constexpr Sentence deviation{
    "{residual}; rounding of the recording explains {allowed_largest}, rms {allowed}",
    "{residual}; das Runden der Aufzeichnung erklärt {allowed_largest}, Effektivwert {allowed}"};
constexpr Sentence explained_by{"what fits: {reading}; {residual}, delay in cycles {delay}",
                                "dazu passt: {reading}; {residual}, Verzögerung in Zyklen {delay}"};
constexpr Sentence next_one{"the next, which does not fit: {reading}; {residual}",
                            "das nächste, das nicht passt: {reading}; {residual}"};
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
    "to tell them apart, record a jump of the velocity to {feed}/min, without #SLOPE, and back",
    "um sie zu unterscheiden, einen Geschwindigkeitssprung auf {feed}/min aufzeichnen, ohne #SLOPE, "
    "und zurück"};
constexpr Sentence step_tells{
    "to tell them apart, record a step of the position by {step}; a jump of the velocity to {feed}/min is "
    "not enough",
    "um sie zu unterscheiden, einen Positionssprung um {step} aufzeichnen; ein "
    "Geschwindigkeitssprung auf {feed}/min reicht nicht"};
constexpr Sentence nothing_tells{
    "they compute the same within this resolution, even behind a step of {step}: it does not matter "
    "which one the control has",
    "sie rechnen innerhalb dieser Auflösung dasselbe, sogar nach einem Sprung um {step}: welche die "
    "Steuerung hat, spielt keine Rolle"};
constexpr Sentence as_listed{"what axisc computes", "was axisc rechnet"};

}  // namespace axisc::says

namespace axisc {

namespace {

using comparison::Explained;
using comparison::Verdict;
using namespace presentation;

constexpr int residual_digits = 3;

/// By Verdict and by Motion.
constexpr std::array<std::string_view, 4> verdicts{"same", "delayed", "different", "cannot-tell"};
constexpr std::array<std::string_view, 3> motions{"velocity-jump", "step", "none"};
constexpr std::array<SentenceRef, 4> verdict_sentences{says::is_same, says::is_delayed, says::is_different,
                                                       says::too_little};
constexpr std::array<SentenceRef, 3> motion_sentences{says::velocity_jump_tells, says::step_tells,
                                                      says::nothing_tells};

Quantity number(double value) {
  return rounded(value, Unit::none, residual_digits);
}

Wording words_of(std::vector<comparison::Departure> const& departures) {
  Wording text;
  for (auto const& departure : departures) {
    text += (text.empty() ? "" : " + ") + wording_of(departure.meaning);
  }
  return text.empty() ? wording_of(says::as_listed) : text;
}

Names ids_of(std::vector<comparison::Departure> const& departures) {
  Names ids;
  for (auto const& departure : departures) ids.emplace_back(departure.id);
  return ids;
}

class FilterAnswer {
 public:
  FilterAnswer(std::string const& axis, RecordedAxis const& recorded)
      : axis_(axis), recorded_(recorded), result_(recorded.result) {}

  presentation::Document document() {
    facts();
    tell(verdict_sentences.at(static_cast<std::size_t>(result_.verdict)),
         {{"delay", number(result_.listed.delay_cycles)}});
    tell(says::counted, {{"compared", result_.compared},
                         {"cycles", recorded_.columns.recording.input.size()},
                         {"lost", result_.lost},
                         {"repeated", recorded_.columns.repeated}});
    if (recorded_.jumps > 0) tell(says::jumps_taken_out, {{"jumps", recorded_.jumps}});
    for (auto const& one : recorded_.found_switches) {
      tell(says::found, {{"command", command_of(one)}, {"cycle", one.cycle}});
    }
    blocks_.emplace_back(mapping_table({"in", "out"}, recorded_.mapping));
    if (result_.verdict != Verdict::cannot_tell) explanations();
    return {.title = Words(says::title, {{"axis", axis_},
                                         {"input", recorded_.columns.input_name},
                                         {"output", recorded_.columns.output_name}}),
            .blocks = std::move(blocks_),
            .csv_table = "fitting"};
  }

 private:
  void tell(SentenceRef sentence, std::vector<NamedValue> values = {}) {
    blocks_.emplace_back(Paragraph{Words(sentence, std::move(values))});
  }
  /// For programs: µm or 0.001°.
  [[nodiscard]] double length(double value) const { return value * recorded_.thousandths; }
  /// For people.
  [[nodiscard]] Quantity shown(double value) const {
    return recorded_.is_rotary ? rounded(length(value) / 1000, Unit::degree, residual_digits)
                               : rounded(length(value), Unit::micrometre, residual_digits);
  }
  [[nodiscard]] Words shown(comparison::Residual const& of) const {
    return {says::residual, {{"largest", shown(of.largest)}, {"rms", shown(of.rms)}}};
  }

  [[nodiscard]] std::vector<Field> residual(comparison::Residual const& of) const {
    return {data("delay_cycles", of.delay_cycles), data("largest", length(of.largest)),
            data("rms", length(of.rms))};
  }
  [[nodiscard]] std::vector<Field> explained(Explained const& one) const {
    NameLists equals;
    for (auto const& other : one.reading.equals) equals.push_back(ids_of(other));
    std::vector<Field> fields{data("readings", ids_of(one.reading.departures)),
                              data("equal_with_these_lists", std::move(equals)),
                              data("meaning", reading_words(one.reading))};
    for (auto& field : residual(one.residual)) fields.push_back(std::move(field));
    return fields;
  }

  /// As a program would write the switch.
  [[nodiscard]] std::string command_of(comparison::KernelSwitch const& one) const {
    machine::FilterCommand command{
        .filter_switch = one.kernel ? machine::FilterSwitch::on : machine::FilterSwitch::off,
        .parameters = {}};
    command.parameters.guard = recorded_.is_guard;
    return to_text(command);
  }

  /// What programs read.
  void facts() {
    auto const& columns = recorded_.columns;
    auto switches = table_of("found_switches", data_columns({"cycle", "command"}), recorded_.found_switches,
                             [this](auto const& one) {
                               return Row{one.cycle, command_of(one)};
                             });
    switches.audience = Audience::programs;
    Table fitting{.key = "fitting", .columns = {}, .rows = {}, .audience = Audience::programs};
    for (auto const& field : explained({})) fitting.columns.push_back(data_column(field.key));
    for (auto const& one : result_.fitting) {
      auto& row = fitting.rows.emplace_back();
      for (auto& field : explained(one)) row.push_back(std::move(field.value));
    }
    std::optional<std::string_view> telling;
    if (recorded_.telling) telling = motions.at(static_cast<std::size_t>(*recorded_.telling));
    blocks_ = {
        Facts{{data("axis", axis_), data("input", columns.input_name), data("output", columns.output_name),
               data("cycles", columns.recording.input.size()), data("compared", result_.compared),
               data("lost", result_.lost), data("repeated", columns.repeated), data("jumps", recorded_.jumps),
               data("unit", recorded_.unit()),
               data("verdict", verdicts.at(static_cast<std::size_t>(result_.verdict))),
               data("allowed_rms", length(result_.allowed_rms)),
               data("allowed_largest", length(result_.allowed_largest)), data("telling_motion", telling)}},
        std::move(switches), data_section("listed", residual(result_.listed)), std::move(fitting)};
    if (result_.next) {
      blocks_.emplace_back(data_section("next", explained(*result_.next)));
    } else {
      blocks_.emplace_back(Facts{{data("next", {})}});
    }
  }

  void explanations() {
    tell(says::deviation, {{"residual", shown(result_.listed)},
                           {"allowed", shown(result_.allowed_rms)},
                           {"allowed_largest", shown(result_.allowed_largest)}});
    bool const differs = result_.verdict == Verdict::different;
    auto const& fitting = result_.fitting;
    if (differs && fitting.empty()) tell(says::fits_nothing);
    if (differs && fitting.size() > 1) tell(says::fits_several);
    if (!differs && !fitting.empty()) tell(says::fits_too);
    for (auto const& one : fitting) explain(says::explained_by, one);
    if (differs && result_.next) explain(says::next_one, *result_.next);
    if (recorded_.telling) {
      auto const unit = recorded_.is_rotary ? Unit::degree : Unit::millimetre;
      tell(motion_sentences.at(static_cast<std::size_t>(*recorded_.telling)),
           {{"feed", exact(telling_feed, unit)}, {"step", exact(telling_step, unit)}});
    }
    if (std::any_of(fitting.begin(), fitting.end(),
                    [](Explained const& one) { return !one.reading.equals.empty(); })) {
      tell(says::lists_tell);
    }
  }
  void explain(SentenceRef sentence, Explained const& one) {
    tell(sentence, {{"reading", reading_words(one.reading)},
                    {"residual", shown(one.residual)},
                    {"delay", number(one.residual.delay_cycles)}});
  }

  std::string const& axis_;
  RecordedAxis const& recorded_;
  comparison::Comparison const& result_;
  std::vector<Block> blocks_;
};

}  // namespace

presentation::Document compare_answer(std::string const& axis, RecordedAxis const& recorded) {
  return FilterAnswer(axis, recorded).document();
}

Wording reading_words(comparison::Reading const& reading) {
  Wording others;
  for (auto const& other : reading.equals) others += (others.empty() ? "" : "; ") + words_of(other);
  auto own = words_of(reading.departures);
  if (others.empty()) return own;
  return wording_of({says::equal_readings, {{"reading", own}, {"others", others}}});
}

Message left_open(comparison::OpenSetting const& open) {
  Wording possible;
  for (auto const id : open.possible) {
    possible +=
        (possible.empty() ? "" : ", ") + (id.empty() ? wording_of(says::setting_in_force) : Wording(id));
  }
  return {says::left_open, {{"key", std::string(open.key)}, {"possible", std::move(possible)}}};
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
  add("vibration_guard", readings.guard);
  add("cycle_time", readings.cycle_time);
  return "{\n  \"design\": {" + members + "}\n}\n";
}

}  // namespace axisc
