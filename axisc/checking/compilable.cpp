#include "axisc/checking/compilable.hpp"

#include "axisc/environment/failure.hpp"
#include "axisc/environment/sentences.hpp"
#include "diagnostics/ascii.hpp"

#include <optional>

namespace axisc::says {

constexpr Sentence cycle_time_missing{
    "the NC cycle time for {file} is not known and decides every coefficient; give it, as in --cycle-time "
    "1ms",
    "die NC-Zykluszeit zu {file} ist nicht bekannt und bestimmt alle Koeffizienten; sie angeben, etwa "
    "--cycle-time 1ms"};
constexpr Sentence machine_cycle_time_missing{
    "{file} states no NC cycle time, which decides every coefficient; add \"cycle_time_us\" or give "
    "--cycle-time 1ms",
    "{file} nennt keine NC-Zykluszeit, die alle Koeffizienten bestimmt; \"cycle_time_us\" ergänzen oder "
    "--cycle-time 1ms angeben"};
constexpr Sentence incomplete{
    "{file} describes no complete machine: a file that it names is missing, unreadable or of another kind, "
    "or it has mistakes itself (AX4020, AX7002, AX7009); correct that, whether these findings are shown or "
    "not",
    "{file} beschreibt keine vollständige Maschine: eine genannte Datei fehlt, ist nicht lesbar oder von "
    "anderer Art, oder {file} hat selbst Fehler (AX4020, AX7002, AX7009); das beheben, ob diese Befunde "
    "gezeigt werden oder nicht"};
constexpr Sentence hidden_errors{
    "{file} has errors, and nothing is compiled while there are errors, whether they are shown or not",
    "{file} hat Fehler, und solange es Fehler gibt, wird nichts kompiliert, ob sie gezeigt werden oder "
    "nicht"};
constexpr Sentence no_axis{
    "{file} configures no axis, so there is nothing to compile; name the lists of its axes",
    "{file} konfiguriert keine Achse, zu kompilieren ist also nichts; die Listen der Achsen nennen"};
constexpr Sentence other_list{"{file} is not an axis list, so it configures no filter",
                              "{file} ist keine Achsliste und konfiguriert keinen Filter"};
constexpr Sentence update{
    "{file} is an axis list in XML, which by itself holds only changes; name the machine that it belongs to: "
    "its start-up list, or the folder with it",
    "{file} ist eine Achsliste in XML und enthält für sich allein nur Änderungen; die Maschine nennen, zu "
    "der sie gehört: deren Hochlaufliste oder den Ordner damit"};
constexpr Sentence not_compiled{
    "{place}: this version cannot compile {feature}; switch it off to compile the rest",
    "{place}: diese Version kann {feature} nicht kompilieren; abschalten, um den Rest zu kompilieren"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::optional<SentenceRef> sentence_of(validator::Obstacle obstacle) {
  switch (obstacle) {
    case validator::Obstacle::incomplete: return says::incomplete;
    case validator::Obstacle::errors: return says::hidden_errors;
    case validator::Obstacle::no_axis: return says::no_axis;
    case validator::Obstacle::none: break;
  }
  return std::nullopt;
}

SentenceRef sentence_of_other_list(validator::CheckResult const& result) {
  return result.is_update_of_axis ? SentenceRef(says::update) : SentenceRef(says::other_list);
}

}  // namespace

void require_cycle_time(std::string const& input, validator::CheckResult const& result) {
  bool const is_machine = ascii::has_extension(input, ".json");
  if (result.is_other_list) throw Failure({sentence_of_other_list(result), {{"file", input}}});
  // Findings about the machine come first: the cycle time may be part of it.
  bool const lacks_more =
      result.obstacle == validator::Obstacle::incomplete || (is_machine && !result.machine);
  if (result.cycle_time_known || lacks_more) return;
  throw Failure(
      {is_machine ? says::machine_cycle_time_missing : says::cycle_time_missing, {{"file", input}}});
}

std::optional<Failure> refusal(std::string const& input, validator::CheckResult const& result,
                               SourceSet const& sources, Language language) {
  auto const said = [&input](SentenceRef sentence) { return Failure({sentence, {{"file", input}}}); };
  if (result.is_other_list) return said(sentence_of_other_list(result));
  if (ascii::has_extension(input, ".nc")) return said(says::nc_program);
  if (auto const sentence = sentence_of(result.obstacle)) return said(*sentence);
  if (result.not_compiled.empty()) return std::nullopt;
  auto const& first = result.not_compiled.front();
  auto const& source = sources[first.place.source];
  return Failure(
      {says::not_compiled,
       {{"place", source.name() + ":" + std::to_string(source.position(first.place.span.begin).line)},
        {"feature", render(first.feature, language)}}});
}

void require_machine(std::string const& input, validator::CheckResult const& result, SourceSet const& sources,
                     Language language) {
  if (auto const refused = refusal(input, result, sources, language)) throw Failure(*refused);
}

}  // namespace axisc
