#include "editor/capabilities/pages.hpp"

#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/answers/figures/script_digest.hpp"
#include "axisc/answers/machine/machine_answer.hpp"
#include "axisc/answers/report/machine_pages.hpp"
#include "axisc/asked/finding_codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/disk_files.hpp"
#include "editor/reading/requests.hpp"
#include "presentation/pictures/page.hpp"
#include "presentation/writers.hpp"
#include "validator/engine/rule.hpp"
#include "validator/loading/loader.hpp"

#include <array>
#include <utility>
#include <variant>

namespace axisc::says {

constexpr Sentence title_report{"Report: {machine}", "Bericht: {machine}"};
constexpr Sentence title_machine{"Machine: {machine}", "Maschine: {machine}"};
constexpr Sentence unknown_rule{"no rule \"{code}\"", "keine Regel \"{code}\""};

}  // namespace axisc::says

namespace axisc::editor {

namespace {

Page machine_page(PageSubject const& subject) {
  auto const language = subject.language;
  SourceSet sources;
  auto const loaded =
      validator::load(subject.files, subject.machine, subject.options(subject.machine), sources);
  if (auto const* const error = std::get_if<configuration::FileError>(&loaded)) {
    throw unreadable(subject.machine, *error);
  }
  auto const name = std::string(validator::file_name(subject.machine));
  auto const title = say(says::title_machine, language, {{"machine", name}});
  auto const answer = machine_answer(std::get<validator::LoadedMachine>(loaded), sources);
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

MachinePages pages_of(PageSubject const& subject) {
  return {subject.files, subject.machine, subject.options(subject.machine), subject.language};
}

/// With the digest of the program's own script.
Page with_script(std::string title, std::string html, Language language) {
  return {.title = std::move(title),
          .html = std::move(html),
          .script_digests = {script_digest(pictures::page_script(language))}};
}

Page report_of_machine(PageSubject const& subject) {
  auto const name = std::string(validator::file_name(subject.machine));
  return with_script(say(says::title_report, subject.language, {{"machine", name}}),
                     pages_of(subject).report(), subject.language);
}

Page plot_of_machine(PageSubject const& subject) {
  auto const kind = subject.words.empty() ? std::string("response") : subject.words.front();
  auto const figure = pages_of(subject).figure(kind, subject.axis);
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
    return pages_of(subject).cascade(subject.axis);
  } catch (Failure const& failure) {
    return failure.sentence(subject.language);
  }
}

}  // namespace axisc::editor
