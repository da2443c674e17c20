#include "axisc/answers/report/report_answer.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/contour_words.hpp"
#include "cli/options/named_files.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/decimal_comma.hpp"
#include "cli/output/printed_errors.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/terminal.hpp"

namespace axisc::cli::says {

constexpr Sentence argument_reported{
    "a list, a machine file, a start-up list, a project, or a folder with one machine",
    "eine Liste, eine Maschinendatei, eine Hochlaufliste, ein Projekt oder ein Ordner mit einer Maschine"};
constexpr Sentence option_page{"where the page goes, - for standard output",
                               "wohin die Seite geht, - für die Standardausgabe"};
constexpr Sentence option_title{"title instead of the machine's name", "Titel statt des Namens der Maschine"};
constexpr Sentence option_customer{"customer", "Kunde"};
constexpr Sentence option_author{"who prepared the report", "wer den Bericht erstellt hat"};
constexpr Sentence option_date{"date on the cover; today's date is never filled in",
                               "Datum auf dem Deckblatt; das heutige wird nie eingesetzt"};
constexpr Sentence bad_cover{"{option} needs one line of visible text",
                             "{option} braucht eine Zeile sichtbaren Text"};
constexpr Sentence option_earlier{
    "an earlier state of the same machine: adds every change and its effect",
    "ein früherer Stand derselben Maschine: dazu jede Änderung und ihre Wirkung"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

struct ReportOptions {
  std::optional<std::string> input, before, output, cycle_time, title, customer, author, date;
  bool alone = false;
  ContourWords contour;
};

void declare(CommandLine& command_line, ReportOptions& options) {
  command_line.argument("INPUT", options.input, says::argument_reported);
  command_line.value("-o,--output", "FILE.html", options.output, says::option_page);
  command_line.value("--title", "TEXT", options.title, says::option_title);
  command_line.value("--customer", "TEXT", options.customer, says::option_customer);
  command_line.value("--author", "TEXT", options.author, says::option_author);
  command_line.value("--date", "TEXT", options.date, says::option_date);
  command_line.value("--before", "OTHER", options.before, says::option_earlier);
  declare_feeds(command_line, options.contour);
  declare_angle(command_line, options.contour);
  declare_radius(command_line, options.contour);
  declare_tolerance(command_line, options.contour);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, options.alone);
}

std::string cover_text(std::string_view option, std::optional<std::string> const& text) {
  if (text && (ascii::trimmed(*text).empty() || !is_visible(*text))) {
    throw Failure({says::bad_cover, {{"option", option}}});
  }
  return text.value_or("");
}

void write(std::string const& page, std::string const& path, Invocation const& invocation) {
  if (path == "-") {
    invocation.streams.out.write(page);
    return;
  }
  OutputFile file(path);
  file.write(page);
  file.commit();
}

}  // namespace

ExitStatus report(Invocation const& invocation) {
  ReportOptions options;
  CommandLine command_line("report", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.input.has_value(), "INPUT");
  command_line.require(options.output.has_value(), "-o FILE.html");
  std::vector<std::string> named{*options.input};
  if (options.before) named.push_back(*options.before);
  refuse_overwriting({*options.output}, named);

  ReportQuestion question{.input = *options.input,
                          .cover = {.title = cover_text("--title", options.title),
                                    .customer = cover_text("--customer", options.customer),
                                    .author = cover_text("--author", options.author),
                                    .date = cover_text("--date", options.date)},
                          .before = options.before,
                          .contour = read_contour_words(options.contour),
                          .alone = options.alone,
                          .language = invocation.language};
  remark_decimal_comma(invocation, "--feed", options.contour.feeds);
  if (!options.contour.feeds) question.contour.feeds = ReportQuestion().contour.feeds;
  Workspace workspace(overrides_with(options.cycle_time));
  std::vector<Message> notes;
  auto const report = report_answer(
      workspace, question, printed_errors(invocation, use_color(command_line.color(), system::Stream::error)),
      notes);
  invocation.streams.err.write(note_lines(notes, invocation.language));
  if (!report) return ExitStatus::findings;
  refuse_overwriting({*options.output}, report->files);
  write(report->page, *options.output, invocation);
  return report->counts.errors > 0 ? ExitStatus::findings : ExitStatus::success;
}

}  // namespace axisc::cli
