#include "axisc/answers/labels.hpp"
#include "axisc/answers/report/overview.hpp"
#include "presentation/pictures/svg_text.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence cover_kind{"Acceptance report: filters of the axes", "Abnahmebericht: Filter der Achsen"};
constexpr Sentence cover_customer{"customer", "Kunde"};
constexpr Sentence cover_author{"prepared by", "erstellt von"};
constexpr Sentence cover_date{"date", "Datum"};
constexpr Sentence cover_checked{"checked", "geprüft"};
constexpr Sentence checked_files{"{files} files with {program}", "{files} Dateien mit {program}"};
constexpr Sentence may_it_run{"May this machine run?", "Darf diese Maschine laufen?"};
constexpr Sentence what_changed{"What has changed?", "Was hat sich geändert?"};
constexpr Sentence what_costs{"What do the filters cost?", "Was kosten die Filter?"};
constexpr Sentence to_do{"What must be done?", "Was ist zu tun?"};
constexpr Sentence nothing_to_do{"Nothing: there are no findings.", "Nichts: es gibt keine Befunde."};
constexpr Sentence verdict_errors{"No: {counts}. Nothing is compiled while there are errors.",
                                  "Nein: {counts}. Solange es Fehler gibt, wird nichts kompiliert."};
constexpr Sentence verdict_tolerance{
    "Not at {feed}: the tolerance of {tolerance} is exceeded; {counts}.",
    "Nicht mit {feed}: die Toleranz von {tolerance} wird überschritten; {counts}."};
constexpr Sentence verdict_unknown{
    "Whether the tolerance of {tolerance} is kept cannot be told; {counts}.",
    "Ob die Toleranz von {tolerance} eingehalten wird, lässt sich nicht sagen; {counts}."};
constexpr Sentence verdict_warnings{"Yes, once the warnings have been looked at: {counts}.",
                                    "Ja, sobald die Warnungen geprüft sind: {counts}."};
constexpr Sentence verdict_good{"Yes, as far as its lists tell: {counts}.",
                                "Ja, soweit es ihre Listen zeigen: {counts}."};
constexpr Sentence counted{"errors: {errors}, warnings: {warnings}, notes: {notes}",
                           "Fehler: {errors}, Warnungen: {warnings}, Hinweise: {notes}"};
constexpr Sentence overview_of{
    "Deviations are those of one axis at {feed}, the largest of the axes in the row; “as passed” takes into "
    "account that the control brakes before the corner (a reading).",
    "Abweichungen sind die einer Achse bei {feed}, die größte der Achsen in der Zeile; „wie gefahren“ "
    "berücksichtigt, dass die Steuerung vor der Ecke bremst (eine Lesart)."};
constexpr Sentence signatures{"signatures", "Unterschriften"};
constexpr Sentence for_maker{"For the manufacturer", "Für den Hersteller"};
constexpr Sentence for_customer{"For the customer", "Für den Kunden"};
constexpr Sentence place_and_date{"place, date", "Ort, Datum"};
constexpr Sentence name_and_signature{"name, signature", "Name, Unterschrift"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

using pictures::escaped;

std::string paragraph(std::string_view kind, std::string const& words) {
  return "<p" + pictures::attribute("class", kind) + ">" + escaped(words) + "</p>\n";
}

bool exceeds_tolerance(ReportSubject const& subject) {
  if (!subject.plots) return false;
  auto const all = equal_axes(*subject.plots);
  return std::any_of(all.begin(), all.end(), [&subject](EqualAxes const& axes) {
    return margin_um(subject, cost_of(subject, axes)).value_or(0) < 0;
  });
}

/// A channel with a tolerance whose contour cannot be predicted.
bool is_tolerance_unknown(ReportSubject const& subject) {
  return subject.contour.tolerance_mm &&
         std::any_of(subject.contours.begin(), subject.contours.end(),
                     [](ReportedContour const& one) { return !one.figures && !one.reason.empty(); });
}

std::string verdict(ReportSubject const& subject) {
  auto const& counts = subject.counts;
  auto const counted = subject.say(says::counted, {{"errors", std::to_string(counts.errors)},
                                                   {"warnings", std::to_string(counts.warnings)},
                                                   {"notes", std::to_string(counts.notes)}});
  auto const [kind, sentence] =
      counts.errors > 0               ? std::pair("verdict error", SentenceRef(says::verdict_errors))
      : exceeds_tolerance(subject)    ? std::pair("verdict warning", SentenceRef(says::verdict_tolerance))
      : is_tolerance_unknown(subject) ? std::pair("verdict warning", SentenceRef(says::verdict_unknown))
      : counts.warnings > 0           ? std::pair("verdict warning", SentenceRef(says::verdict_warnings))
                                      : std::pair("verdict good", SentenceRef(says::verdict_good));
  auto const tolerance = exact(subject.contour.tolerance_mm.value_or(0), Unit::millimetre);
  return paragraph(
      kind, text_of(Words(sentence, {{"counts", counted},
                                     {"tolerance", tolerance},
                                     {"feed", exact(subject.highest_feed(), Unit::millimetre_per_minute)}}),
                    subject.language));
}

Facts facts_of_people(ReportCover const& cover) {
  return {{shown(says::cover_customer, cover.customer), shown(says::cover_author, cover.author),
           shown(says::cover_date, cover.date)}};
}

Facts facts_of_machine(ReportSubject const& subject) {
  Facts facts;
  if (!subject.plots) return facts;
  auto const& contents = subject.plots->contents();
  facts.fields.push_back(shown(labels::axes, subject.plots->names()));
  facts.fields.push_back(
      shown(labels::cycle_time, exact(contents.cycle_time.microseconds(), Unit::microsecond)));
  facts.fields.push_back(shown(
      says::cover_checked, Words(says::checked_files, {{"files", subject.files},
                                                       {"program", "axisc " + contents.compiler_version}})));
  return facts;
}

std::string signature(ReportSubject const& subject, SentenceRef who, std::string const& name) {
  return "<div>" + paragraph("who", subject.say(who) + (name.empty() ? "" : ": " + name)) +
         paragraph("line", subject.say(says::place_and_date)) +
         paragraph("line", subject.say(says::name_and_signature)) + "</div>\n";
}

}  // namespace

bool has_overview(ReportSubject const& subject) {
  constexpr std::size_t most_rows = 5;
  return subject.plots && subject.difference == nullptr && overview_table(subject).rows.size() <= most_rows;
}

std::string report_overview(ReportSubject const& subject) {
  auto const feed = exact(subject.highest_feed(), Unit::millimetre_per_minute);
  return "<div class=\"overview\">" + subject.html({overview_table(subject)}, 3) +
         paragraph("small", text_of(Words(says::overview_of, {{"feed", feed}}), subject.language)) +
         "</div>\n";
}

std::string report_cover(ReportSubject const& subject) {
  constexpr int level = 3;
  auto const heading = [&subject](SentenceRef words) {
    return "<h2>" + escaped(subject.say(words)) + "</h2>\n";
  };
  std::string html = "<header class=\"cover\">\n" + paragraph("kind", subject.say(says::cover_kind)) +
                     "<h1>" + escaped(subject.cover.title) + "</h1>\n" + "<div class=\"facts\">";
  for (auto const& facts : {facts_of_people(subject.cover), facts_of_machine(subject)}) {
    if (auto const table = subject.html({facts}, level); !table.empty()) html += "<div>" + table + "</div>\n";
  }
  html += "</div>\n";
  html += heading(says::may_it_run) + verdict(subject);
  if (subject.difference != nullptr) {
    html += heading(says::what_changed) + subject.html(change_summary(*subject.difference), level);
  }
  if (subject.plots) {
    html += heading(says::what_costs) + subject.html(cost_sentences(subject), level);
    if (has_overview(subject)) html += report_overview(subject);
  }
  html += heading(says::to_do);
  html += subject.findings.empty() ? paragraph("", subject.say(says::nothing_to_do))
                                   : subject.html({to_do_table(subject)}, level);
  html += "<section class=\"sign\"" + pictures::attribute("aria-label", subject.say(says::signatures)) +
          ">\n" + signature(subject, says::for_maker, {}) +
          signature(subject, says::for_customer, subject.cover.customer) + "</section>\n";
  return html + "</header>\n";
}

}  // namespace axisc
