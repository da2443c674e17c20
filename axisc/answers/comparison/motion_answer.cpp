#include "axisc/answers/comparison/motion_answer.hpp"

#include "axisc/answers/comparison/motion_words.hpp"
#include "axisc/answers/execution/mapping_table.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/joined.hpp"
#include "diagnostics/writers/json_stream.hpp"

#include <cmath>
#include <string_view>
#include <utility>

namespace axisc::says {

constexpr Sentence motion_title{"{recording} compared with the plan of {program} (axes: {axes})",
                                "{recording}, verglichen mit dem Plan von {program} (Achsen: {axes})"};
constexpr Sentence plans_alike{"the same: the control plans as axisc does",
                               "gleich: die Steuerung plant wie axisc"};
constexpr Sentence plans_otherwise{"different: the control does not plan as axisc does",
                                   "verschieden: die Steuerung plant anders als axisc"};
constexpr Sentence plans_unknown{
    "different, and no combination of the known readings fits; check the lists, the NC cycle and that the "
    "override was 100 %",
    "verschieden, und keine Kombination der bekannten Lesarten passt; Listen, NC-Zyklus und Override 100 % "
    "prüfen"};
constexpr Sentence moves_counted{
    "{moves} moves of {compared} cycles in a recording of {cycles} (lost {lost}, repeated {repeated})",
    "{moves} Bewegungen von {compared} Zyklen in einer Aufzeichnung von {cycles} (verloren {lost}, "
    "wiederholt {repeated})"};
constexpr Sentence motion_jumps{"jumps by the modulo range, taken out: {jumps}",
                                "Sprünge um den Modulobereich, herausgerechnet: {jumps}"};
constexpr Sentence planned_as_set{
    "with the readings in force: largest deviation {largest}, rms {rms}; rounding of the recording "
    "explains {allowed}",
    "mit den geltenden Lesarten: größte Abweichung {largest}, Effektivwert {rms}; das Runden der "
    "Aufzeichnung erklärt {allowed}"};
constexpr Sentence planned_best{
    "with those that fit best: largest deviation {largest}, rms {rms}",
    "mit denen, die am besten passen: größte Abweichung {largest}, Effektivwert {rms}"};
constexpr Sentence moves_unexplained{
    "no known reading explains the moves below; what is told comes from the others, and is what the best "
    "readings are compared with",
    "keine bekannte Lesart erklärt die Bewegungen unten; was feststeht, ergibt sich aus den anderen, und mit "
    "ihnen sind die besten Lesarten verglichen"};
constexpr Sentence column_block{"block", "Satz"};
constexpr Sentence column_least{"least deviation", "kleinste Abweichung"};
constexpr Sentence key_open{
    "\"{key}\" is left open: {possible} explain this recording alike; it takes {motion}",
    "\"{key}\" bleibt offen: {possible} erklären diese Aufzeichnung gleich gut; nötig ist {motion}"};
constexpr Sentence key_unseen{
    "\"{key}\" is left open: no move that is explained depends on it; it takes {motion}",
    "\"{key}\" bleibt offen: keine erklärte Bewegung hängt davon ab; nötig ist {motion}"};
constexpr Sentence program_tells{
    "`axisc compare MACHINE --emit program` writes a program with the motions that tell on this machine",
    "`axisc compare MASCHINE --emit program` schreibt ein Programm mit den Bewegungen, die an dieser "
    "Maschine entscheiden"};
constexpr Sentence cannot_tell{"cannot tell", "nicht entscheidbar"};
constexpr Sentence none_fits{"none fits", "keine passt"};
constexpr Sentence column_key{"key", "Schlüssel"};
constexpr Sentence column_reading{"reading", "Lesart"};
constexpr Sentence column_in_force{"in force", "geltend"};
constexpr Sentence column_next{"next best, which does not fit", "nächstbeste, die nicht passt"};
constexpr Sentence column_next_largest{"largest deviation", "größte Abweichung"};

}  // namespace axisc::says

namespace axisc {

namespace {

using comparison::MotionComparison;
using comparison::MotionKey;
using comparison::MotionKeyVerdict;
using namespace presentation;

constexpr int deviation_digits = 3;

std::string word_of(std::size_t key, std::uint8_t number) {
  return std::string(comparison::motion_key_words().at(key).words[number]);
}

Names words_of(std::size_t key, std::vector<std::uint8_t> const& numbers) {
  Names words;
  for (auto const number : numbers) words.push_back(word_of(key, number));
  return words;
}

bool fits_none(MotionComparison const& result) {
  return !result.best.deviation.fits();
}

Message left_open(std::size_t key, MotionKeyVerdict const& verdict) {
  return {verdict.acts ? SentenceRef(says::key_open) : SentenceRef(says::key_unseen),
          {{"key", std::string(comparison::motion_key_words().at(key).key)},
           {"possible", joined(words_of(key, verdict.possible))},
           {"motion", wording_of(telling_motion_of(static_cast<MotionKey>(key)))}}};
}

/// For programs: µm or 0.001°. Nothing where the plan takes longer than the recording.
Value length(double units) {
  if (!std::isfinite(units)) return {};
  return units / motion::units_per_um;
}

class MotionAnswer {
 public:
  explicit MotionAnswer(RecordedMotion const& recorded)
      : recorded_(recorded),
        result_(recorded.result),
        in_force_(comparison::combination_of(recorded.in_force)) {}

  presentation::Document document() {
    facts();
    sentences();
    blocks_.emplace_back(mapping_table(recorded_.axes, recorded_.mapping));
    blocks_.emplace_back(unexplained());
    blocks_.emplace_back(readings());
    auto const open = motion_left_open(result_);
    for (auto const& message : open) blocks_.emplace_back(Paragraph{Words(message)});
    if (!open.empty()) tell(says::program_tells);
    return {.title = Words(says::motion_title, {{"recording", recorded_.recording},
                                                {"program", recorded_.program},
                                                {"axes", joined(recorded_.axes)}}),
            .blocks = std::move(blocks_),
            .csv_table = "readings"};
  }

 private:
  void tell(SentenceRef sentence, std::vector<NamedValue> values = {}) {
    blocks_.emplace_back(Paragraph{Words(sentence, std::move(values))});
  }
  /// For people.
  [[nodiscard]] Value shown(double units) const {
    if (!std::isfinite(units)) return {};
    return recorded_.is_rotary ? rounded(units / motion::units_per_mm, Unit::degree, deviation_digits)
                               : rounded(units / motion::units_per_um, Unit::micrometre, deviation_digits);
  }
  [[nodiscard]] static Section deviation(std::string key, comparison::ExplainedMotion const& explained) {
    std::vector<Field> fields{data("largest", length(explained.deviation.largest)),
                              data("rms", length(explained.deviation.rms()))};
    return data_section(std::move(key), std::move(fields));
  }
  [[nodiscard]] std::string_view verdict() const {
    if (result_.agrees()) return "same";
    return fits_none(result_) ? "none-fits" : "different";
  }

  void facts() {
    blocks_ = {Facts{{data("program", recorded_.program), data("recording", recorded_.recording),
                      data("axes", Names(recorded_.axes)), data("cycles", recorded_.cycles),
                      data("moves", result_.moves), data("compared", result_.cycles),
                      data("lost", recorded_.lost), data("repeated", recorded_.repeated),
                      data("jumps", recorded_.jumps), data("unit", recorded_.is_rotary ? "0.001°" : "µm"),
                      data("verdict", verdict()), data("allowed_largest", length(recorded_.allowed))}},
               deviation("current", result_.current), deviation("best", result_.best)};
  }

  void sentences() {
    bool const is_unknown = fits_none(result_);
    SentenceRef const otherwise = is_unknown ? says::plans_unknown : says::plans_otherwise;
    tell(result_.agrees() ? SentenceRef(says::plans_alike) : otherwise);
    tell(says::moves_counted, {{"moves", result_.moves},
                               {"compared", result_.cycles},
                               {"cycles", recorded_.cycles},
                               {"lost", recorded_.lost},
                               {"repeated", recorded_.repeated}});
    if (recorded_.jumps > 0) tell(says::motion_jumps, {{"jumps", recorded_.jumps}});
    tell(says::planned_as_set, {{"largest", shown(result_.current.deviation.largest)},
                                {"rms", shown(result_.current.deviation.rms())},
                                {"allowed", shown(recorded_.allowed)}});
    if (result_.agrees()) return;
    if (!is_unknown && !result_.unexplained.empty()) tell(says::moves_unexplained);
    tell(says::planned_best,
         {{"largest", shown(result_.best.deviation.largest)}, {"rms", shown(result_.best.deviation.rms())}});
  }

  /// Where nothing is explained, people need no list of all moves.
  [[nodiscard]] Table unexplained() const {
    auto const unit = recorded_.is_rotary ? Unit::degree : Unit::micrometre;
    auto const audience =
        fits_none(result_) || result_.unexplained.empty() ? Audience::programs : Audience::all;
    Table table{
        .key = "unexplained",
        .columns = {head_column("line", labels::line), column("block", says::column_block),
                    Column{
                        .key = {}, .label = says::column_least, .unit = unit, .audience = Audience::people},
                    data_column("largest")},
        .rows = {},
        .audience = audience};
    for (auto const& move : result_.unexplained) {
      table.rows.push_back({move.line, move.block, shown(move.largest), length(move.largest)});
    }
    return table;
  }

  [[nodiscard]] Table readings() const {
    auto const unit = recorded_.is_rotary ? Unit::degree : Unit::micrometre;
    Table table{.key = "readings",
                .columns = {head_column("key", says::column_key), column("reading", says::column_reading),
                            column("in_force", says::column_in_force), data_column("acts"),
                            data_column("possible"), column("next", says::column_next),
                            Column{.key = {},
                                   .label = says::column_next_largest,
                                   .unit = unit,
                                   .audience = Audience::people},
                            data_column("next_largest"), data_column("next_rms")},
                .rows = {}};
    SentenceRef const why = fits_none(result_) ? says::none_fits : says::cannot_tell;
    for (std::size_t key = 0; key < result_.keys.size(); ++key) {
      auto const& verdict = result_.keys.at(key);
      bool const is_told = verdict.is_told();
      auto& row = table.rows.emplace_back(
          Row{comparison::motion_key_words().at(key).key,
              is_told ? Value(word_of(key, verdict.possible.front())) : Value(Nothing{Words(why)}),
              word_of(key, in_force_.at(key)), verdict.acts, words_of(key, verdict.possible)});
      if (verdict.next) {
        auto const& [combination, deviation] = *verdict.next;
        row.insert(row.end(), {word_of(key, combination.at(key)), shown(deviation.largest),
                               length(deviation.largest), length(deviation.rms())});
      } else {
        row.resize(table.columns.size());
      }
    }
    return table;
  }

  RecordedMotion const& recorded_;
  MotionComparison const& result_;
  comparison::Combination in_force_;
  std::vector<Block> blocks_;
};

}  // namespace

presentation::Document motion_answer(RecordedMotion const& recorded) {
  return MotionAnswer(recorded).document();
}

std::optional<std::string> motion_settings(MotionComparison const& result) {
  std::string members;
  for (std::size_t key = 0; key < result.keys.size(); ++key) {
    auto const& verdict = result.keys.at(key);
    if (!verdict.is_told()) continue;
    if (!members.empty()) members += ", ";
    members += json_string(comparison::motion_key_words().at(key).key) + ": " +
               json_string(word_of(key, verdict.possible.front()));
  }
  if (members.empty()) return std::nullopt;
  return "{\n  \"motion\": {" + members + "}\n}\n";
}

std::vector<Message> motion_left_open(MotionComparison const& result) {
  std::vector<Message> open;
  if (fits_none(result)) return open;
  for (std::size_t key = 0; key < result.keys.size(); ++key) {
    if (!result.keys.at(key).is_told()) open.push_back(left_open(key, result.keys.at(key)));
  }
  return open;
}

}  // namespace axisc
