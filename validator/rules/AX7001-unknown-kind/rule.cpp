#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"

namespace axisc::validator::checks::ax7001::says {

constexpr Sentence headline{"nothing in this list tells what kind of list it is: it is not checked",
                            "nichts in dieser Liste zeigt, von welcher Art sie ist: sie wird nicht geprüft"};
constexpr Sentence is_empty{"the list is empty", "die Liste ist leer"};
constexpr Sentence help_empty{"restore its text, or remove the file",
                              "ihren Text wiederherstellen oder die Datei entfernen"};
constexpr Sentence help_defaults{
    "restore its text: as it is, every value is that of the default list or the control's own",
    "ihren Text wiederherstellen: so gelten überall die Werte der Standardliste oder die der Steuerung"};
constexpr Sentence help{
    "`--kind axis`, or \"kind\" in axisc.json, checks it as an axis list, \"exclude\" there leaves it out; "
    "other kinds: {kinds}",
    "`--kind axis` oder \"kind\" in axisc.json prüft sie als Achsliste, \"exclude\" dort lässt sie aus; "
    "andere Arten: {kinds}"};

}  // namespace axisc::validator::checks::ax7001::says

namespace axisc::validator::checks::ax7001 {
namespace {

std::string other_kinds() {
  std::string words;
  for (schema::ListKindRow const& row : schema::list_kind_rows) {
    if (row.kind == schema::ListKind::axis) continue;
    words.append(words.empty() ? "" : ", ").append(row.word);
  }
  return words;
}

/// A list in a file of its own, whose text was probably lost.
void find_blank_lists(MachineContext const& context, Report& report) {
  for (NamedList const& named : context.machine.lists) {
    SourceText const& text = context.sources[named.list.source];
    if (text.is_window() || text.is_translation() || !is_blank(text)) continue;
    report.add(beginning_of(named.list.source, text), message(says::is_empty))
        .help.push_back(message(says::help_defaults));
  }
}

void unknown_kind(MachineContext const& context, Report& report) {
  if (!context.machine.list_of_unknown_kind) {
    find_blank_lists(context, report);
    return;
  }
  SourceId const source = *context.machine.list_of_unknown_kind;
  SourceText const& text = context.sources[source];
  Place const place = beginning_of(source, text);
  if (is_blank(text)) {
    // Its former content is unknown: perhaps it was the start-up list that combines the others into a
    // machine.
    Finding& finding = report.add(place, message(says::is_empty));
    finding.severity = Severity::error;
    finding.help.push_back(message(says::help_empty));
    return;
  }
  Finding& finding = report.add(place, message(says::headline));
  finding.help.push_back(message(says::help, {{"kinds", other_kinds()}}));
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .check = unknown_kind,
};

}  // namespace axisc::validator::checks::ax7001
