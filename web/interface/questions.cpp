#include "web/interface/questions.hpp"

#include "axisc/answers/contour/contour_answer.hpp"
#include "axisc/answers/contour/delay_budget_answer.hpp"
#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/answers/figures/picture_answer.hpp"
#include "axisc/answers/machine/machine_answer.hpp"
#include "axisc/answers/report/report_answer.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "presentation/pictures/svg.hpp"
#include "presentation/writers.hpp"
#include "web/interface/asked.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::says {

constexpr Sentence not_a_question{R"("{question}" is not a question: {known})",
                                  R"("{question}" ist keine Frage: {known})"};
}  // namespace axisc::says

namespace axisc::web {

namespace {

using Answer = std::optional<std::string>;

std::string written(presentation::Document const& document, Asked const& asked, Language language) {
  return presentation::write(document, asked.word("format", presentation::formats), {.language = language});
}

Answer machine(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  auto const path = machine_of_input(workspace, {.input = asked.text("input")}).machine;
  SourceSet sources;
  auto const loaded = loaded_machine(workspace, path, sources);
  return written(machine_answer(loaded, sources), asked, errors.language);
}

Answer machine_of(Workspace& workspace, Asked const& asked, ErrorSink const& /*errors*/) {
  return machine_of_input(workspace, {.input = asked.text("input")}).machine;
}

Answer contour(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  auto const input = asked.text("input");
  auto const checked = checked_machine(workspace, {.input = input}, errors);
  if (!checked) return std::nullopt;
  ContourQuestion const question{
      .machine = input, .group = checked->group, .filter = {}, .wanted = {}, .language = errors.language};
  return written(contour_answer(question, checked->machine, {}), asked, errors.language);
}

Answer delay_budget(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  auto const found = delay_budget_answer(workspace, {.machine = {.input = asked.text("input")}}, errors);
  return found ? Answer(written(*found, asked, errors.language)) : std::nullopt;
}

Answer picture(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  PictureQuestion question;
  question.input = asked.text("input");
  question.kind = asked.word("kind", picture_kinds);
  question.axis = asked.find("axis");
  question.group = asked.find("group");
  question.before = asked.find("before");
  question.program = asked.find("program");
  question.plant = asked.find("plant");
  question.move = asked.find("move");
  question.language = errors.language;
  auto const figure = picture_answer(workspace, question, errors);
  return figure ? Answer(pictures::svg(*figure, errors.language)) : std::nullopt;
}

Answer report(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  std::vector<Message> notes;
  auto report = report_answer(
      workspace, {.input = asked.text("input"), .before = asked.find("before"), .language = errors.language},
      errors, notes);
  return report ? Answer(std::move(report->page)) : std::nullopt;
}

Answer explain(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  return written(explain_answer({.word = asked.text("word"), .of_axes = workspace.settings().catalogue("-")}),
                 asked, errors.language);
}

struct Question {
  std::string_view name, keys;
  Answer (*answer)(Workspace& workspace, Asked const& asked, ErrorSink const& errors);
};

constexpr std::array questions = {
    Question{.name = "machine", .keys = "input format", .answer = machine},
    Question{.name = "machine_of", .keys = "input", .answer = machine_of},
    Question{.name = "contour", .keys = "input format", .answer = contour},
    Question{.name = "delay_budget", .keys = "input format", .answer = delay_budget},
    Question{.name = "picture", .keys = "input kind axis group before program plant move", .answer = picture},
    Question{.name = "report", .keys = "input before", .answer = report},
    Question{.name = "explain", .keys = "word format", .answer = explain}};

}  // namespace

std::optional<std::string> answer(Workspace& workspace, std::string const& question,
                                  ErrorSink const& errors) {
  Asked const asked(question);
  auto const name = asked.text("question");
  auto const* const found = std::find_if(questions.begin(), questions.end(),
                                         [&name](Question const& row) { return row.name == name; });
  if (found != questions.end()) {
    asked.refuse_others(std::string(found->keys) + " question");
    return found->answer(workspace, asked, errors);
  }
  std::string known;
  for (auto const& row : questions) known.append(known.empty() ? "" : ", ").append(row.name);
  throw Failure({says::not_a_question, {{"question", name}, {"known", known}}});
}

}  // namespace axisc::web
