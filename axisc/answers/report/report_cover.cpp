#include "axisc/answers/labels.hpp"
#include "axisc/answers/report/cover_space.hpp"
#include "axisc/answers/report/overview.hpp"
#include "diagnostics/markup.hpp"
#include "presentation/pictures/svg_text.hpp"
#include "presentation/pictures/text_width.hpp"

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

/// Its look, and its words.
std::pair<std::string_view, std::string> verdict(ReportSubject const& subject) {
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
  return {kind,
          text_of(Words(sentence, {{"counts", counted},
                                   {"tolerance", tolerance},
                                   {"feed", exact(subject.highest_feed(), Unit::millimetre_per_minute)}}),
                  subject.language)};
}

std::string overview_words(ReportSubject const& subject) {
  auto const feed = exact(subject.highest_feed(), Unit::millimetre_per_minute);
  return text_of(Words(says::overview_of, {{"feed", feed}}), subject.language);
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

/// The first table and how to read it: HTML.
std::string overview_html(ReportSubject const& subject, Table table) {
  return "<div class=\"overview\">" + subject.html({std::move(table)}, 3) +
         paragraph("small", overview_words(subject)) + "</div>\n";
}

/// Titles that need more than two lines in large letters are smaller.
PrintedText title_style(std::string const& title) {
  constexpr PrintedText large{.size = 24, .line = 36, .is_bold = true};
  constexpr PrintedText small{.size = 14.4, .line = 21.6, .is_bold = true};
  return printed_height(title, large) > 2 * large.line ? small : large;
}

/// What people wrote, as far as a cover has room for it.
ReportCover shortened(ReportCover cover) {
  constexpr double title_room = 1300;
  constexpr double room = 560;
  cover.title = pictures::fitted(cover.title, PrintedText().size, title_room);
  for (auto* const text : {&cover.customer, &cover.author, &cover.date}) {
    *text = pictures::fitted(*text, PrintedText().size, room);
  }
  return cover;
}

/// Everything above the first table.
double height_above(ReportSubject const& subject, std::string const& title, std::vector<Facts> const& facts,
                    std::string const& verdict) {
  double height =
      printed_paragraph(subject.say(says::cover_kind)) + printed_height(title, title_style(title)) + 6;
  bool const is_alone = facts.front().fields.empty() || facts.back().fields.empty();
  double const width = is_alone ? PrintedText().width : 243;
  double highest = 0;
  for (auto const& side : facts) {
    highest = std::max(highest,
                       printed_height(side, subject.language, {.size = 8.5, .line = 11.5, .width = width}));
  }
  return height + highest + cover_heading +
         printed_height(verdict, {.size = 13.2, .line = 19.8, .width = 480, .is_bold = true}) + 18;
}

struct CoverParts {
  ReportBlocks changes, costs, to_do;
  Table overview;
  bool has_overview = false;
};

/// How many rows of each table the page has room for: all of the overview where it can be, else those that
/// cost most. False where the parts must move together.
bool fit(CoverParts& parts, ReportSubject const& subject, double room) {
  for (auto const* const blocks : {&parts.changes, &parts.costs, &parts.to_do}) {
    if (!blocks->empty()) room -= cover_heading + paragraphs_height(*blocks, subject.language);
  }
  std::vector<CoverTable> tables;
  for (auto* const blocks : {&parts.changes, &parts.to_do, &parts.costs}) add_tables(tables, *blocks);
  constexpr PrintedText dense{.size = 8, .line = 10.8, .second_column = 132};
  auto const try_overview = [&](Table table, std::size_t least) {
    parts.overview = std::move(table);
    auto with = tables;
    with.push_back({.table = &parts.overview, .least = least, .style = dense});
    double const words = printed_paragraph(overview_words(subject), {.size = 8.5, .line = 12.8});
    parts.has_overview = fit_tables(with, room - words, subject.language);
  };
  if (subject.plots) {
    constexpr std::size_t some = 3;
    auto const whole = overview_table(subject);
    try_overview(whole, whole.rows.size());
    if (!parts.has_overview && whole.rows.size() > some) {
      try_overview(overview_table(subject, OverviewOrder::costliest_first), some);
    }
  }
  if (parts.has_overview) return true;
  bool fits = fit_tables(tables, room, subject.language);
  while (!fits && !tables.empty() && tables.front().least > 1) {
    for (auto& table : tables) --table.least;
    fits = fit_tables(tables, room, subject.language);
  }
  return fits;
}

}  // namespace

std::string report_overview(ReportSubject const& subject) {
  return overview_html(subject, overview_table(subject));
}

ReportCoverPage report_cover(ReportSubject const& subject) {
  constexpr int level = 3;
  auto const heading = [&subject](SentenceRef words) {
    return "<h2>" + escaped(subject.say(words)) + "</h2>\n";
  };
  auto const cover = shortened(subject.cover);
  bool const is_long = title_style(cover.title).size < title_style({}).size;
  std::vector<Facts> const facts{facts_of_people(cover), facts_of_machine(subject)};
  auto const [kind, words] = verdict(subject);
  CoverParts parts;
  if (subject.difference != nullptr) parts.changes = change_summary(*subject.difference);
  parts.costs = cost_blocks(subject);
  parts.to_do = {subject.findings.empty() ? Block(Paragraph{says::nothing_to_do}) : to_do_table(subject)};
  double const lines_to_sign = 55 + printed_height(subject.say(says::for_customer) + ": " + cover.customer,
                                                   {.width = 240, .is_bold = true});
  bool const fits =
      fit(parts, subject, cover_height - height_above(subject, cover.title, facts, words) - lines_to_sign);

  std::string html = std::string("<header class=\"cover") + (fits ? "" : " tight") + "\">\n" +
                     paragraph("kind", subject.say(says::cover_kind)) + "<h1" +
                     (is_long ? pictures::attribute("class", "long") : std::string()) + ">" +
                     escaped(cover.title) + "</h1>\n" + "<div class=\"facts\">";
  for (auto const& side : facts) {
    if (auto const table = subject.html({side}, level); !table.empty()) html += "<div>" + table + "</div>\n";
  }
  html += "</div>\n";
  html += heading(says::may_it_run) + paragraph(kind, words);
  if (!parts.changes.empty()) html += heading(says::what_changed) + subject.html(parts.changes, level);
  if (subject.plots) html += heading(says::what_costs) + subject.html(parts.costs, level);
  bool const is_whole_overview = parts.has_overview && is_whole(parts.overview);
  if (parts.has_overview) html += overview_html(subject, std::move(parts.overview));
  html += heading(says::to_do) + subject.html(parts.to_do, level);
  html += "<section class=\"sign\"" + pictures::attribute("aria-label", subject.say(says::signatures)) +
          ">\n" + signature(subject, says::for_maker, {}) +
          signature(subject, says::for_customer, cover.customer) + "</section>\n";
  return {.html = html + "</header>\n", .has_whole_overview = is_whole_overview};
}

}  // namespace axisc
