#include "editor/capabilities/pages.hpp"

#include "axisc/answers/contour/cascade_line.hpp"
#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/answers/figures/picture_answer.hpp"
#include "axisc/answers/figures/script_digest.hpp"
#include "axisc/answers/machine/machine_answer.hpp"
#include "axisc/answers/report/report_answer.hpp"
#include "axisc/asked/finding_codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/disk_files.hpp"
#include "editor/reading/requests.hpp"
#include "presentation/pictures/page.hpp"
#include "presentation/writers.hpp"
#include "validator/engine/rule.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace axisc::editor::says {

constexpr Sentence title_report{"Report: {machine}", "Bericht: {machine}"};
constexpr Sentence title_machine{"Machine: {machine}", "Maschine: {machine}"};
constexpr Sentence errors_first{"{machine} has errors: correct them first, they are among the problems",
                                "{machine} hat Fehler: zuerst diese beheben, sie stehen unter den Problemen"};
constexpr Sentence unknown_picture_kind{
    "no picture \"{kind}\": response, step, delay, corner, circle or dynamics",
    "kein Bild \"{kind}\": response, step, delay, corner, circle oder dynamics"};
constexpr Sentence unknown_rule{"no rule \"{code}\"", "keine Regel \"{code}\""};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

/// The kinds of pictures that need nothing but the machine come first.
constexpr std::ptrdiff_t drawn_without_more = 7;

Page machine_page(PageSubject const& subject) {
  auto const language = subject.language;
  Workspace workspace(subject.files, subject.options);
  SourceSet sources;
  auto const loaded = loaded_machine(workspace, subject.machine, sources);
  auto const name = std::string(validator::file_name(subject.machine));
  auto const title = say(says::title_machine, language, {{"machine", name}});
  auto const answer = machine_answer(loaded, sources);
  return {.title = title, .html = write(answer, presentation::Format::html, {.language = language})};
}

Page explanation_page(PageSubject const& subject) {
  auto const language = subject.language;
  auto const word = subject.words.empty() ? std::string() : subject.words.front();
  auto const code = find_code(word);
  auto const* const rule = code ? validator::find_rule(*code) : nullptr;
  if (rule == nullptr) {
    throw RequestRefused(say(says::unknown_rule, language, {{"code", word}}));
  }
  return {.title = code_text(rule->code),
          .html = write(rule_answer(*rule), presentation::Format::html, {.language = language})};
}

/// The client shows why an input fails.
template <Page (*make)(PageSubject const&)>
Page page(PageSubject const& subject) {
  try {
    return make(subject);
  } catch (Failure const& failure) {
    throw RequestRefused(failure.sentence(subject.language));
  }
}

/// With the digest of the program's own script.
Page with_script(std::string title, std::string html, Language language) {
  return {.title = std::move(title),
          .html = std::move(html),
          .script_digests = {script_digest(pictures::page_script(language))}};
}

/// Those of a check that makes the machine, too.
OptionsOf options_of(PageSubject const& subject) {
  return [&subject](std::string const& path) {
    auto options = subject.options(path);
    options.machine = true;
    return options;
  };
}

/// The client lists them anyway.
ErrorSink no_errors(PageSubject const& subject) {
  return {.language = subject.language, .take = [](std::vector<Finding> const&, SourceSet const&) {}};
}

Page report_of_machine(PageSubject const& subject) {
  auto const name = std::string(validator::file_name(subject.machine));
  Workspace workspace(subject.files, options_of(subject));
  std::vector<Message> notes;
  auto report =
      report_answer(workspace, {.input = subject.machine, .alone = true, .language = subject.language},
                    no_errors(subject), notes);
  return with_script(say(says::title_report, subject.language, {{"machine", name}}), std::move(report->page),
                     subject.language);
}

Page plot_of_machine(PageSubject const& subject) {
  auto const word = subject.words.empty() ? std::string("response") : subject.words.front();
  auto const* const last = picture_kinds.begin() + drawn_without_more;
  auto const* const kind =
      std::find_if(picture_kinds.begin(), last, [&word](auto const& row) { return row.first == word; });
  if (kind == last) throw Failure({says::unknown_picture_kind, {{"kind", word}}});
  Workspace workspace(subject.files, options_of(subject));
  PictureQuestion question;
  question.input = subject.machine;
  question.kind = kind->second;
  question.alone = true;
  question.axis = kind->second == PictureKind::delay ? std::nullopt : subject.axis;
  question.language = subject.language;
  auto const picture = picture_answer(workspace, question, no_errors(subject));
  if (!picture) {
    throw Failure({says::errors_first, {{"machine", std::string(validator::file_name(subject.machine))}}});
  }
  auto const& figure = picture->figure;
  return with_script(figure.title, pictures::page(figure, subject.language), subject.language);
}

constexpr std::array commands = {PageCommand{.name = "axisc.report", .page = page<report_of_machine>},
                                 PageCommand{.name = "axisc.plot", .page = page<plot_of_machine>},
                                 PageCommand{.name = "axisc.machine", .page = page<machine_page>},
                                 PageCommand{.name = "axisc.explain", .page = page<explanation_page>}};

}  // namespace

std::span<PageCommand const> page_commands() {
  return commands;
}

std::string cascade_line(PageSubject const& subject) {
  try {
    Workspace workspace(subject.files, options_of(subject));
    return axisc::cascade_line(workspace, subject.machine, subject.axis, subject.language);
  } catch (Failure const& failure) {
    return failure.sentence(subject.language);
  }
}

}  // namespace axisc::editor
