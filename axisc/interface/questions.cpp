#include "axisc/interface/questions.hpp"

#include "axisc/answers/contour/contour_answer.hpp"
#include "axisc/answers/contour/delay_budget_answer.hpp"
#include "axisc/answers/difference/difference_answer.hpp"
#include "axisc/answers/execution/response_answer.hpp"
#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/answers/figures/picture_answer.hpp"
#include "axisc/answers/inspect/filters_answer.hpp"
#include "axisc/answers/inspect/inspect_answer.hpp"
#include "axisc/answers/machine/machine_answer.hpp"
#include "axisc/answers/machine/machines_answer.hpp"
#include "axisc/answers/report/report_answer.hpp"
#include "axisc/answers/values/values_answer.hpp"
#include "axisc/asked/frequencies.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/checking/compiled_input.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/exporting/exported_fmu.hpp"
#include "axisc/files/disk_files.hpp"
#include "axisc/interface/recorded_questions.hpp"
#include "presentation/pictures/svg.hpp"
#include "presentation/writers.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace axisc::says {

constexpr Sentence not_a_question{R"("{question}" is not a question: {known})",
                                  R"("{question}" ist keine Frage: {known})"};
}  // namespace axisc::says

namespace axisc::interface {

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

Answer machines(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  return written(machines_answer(workspace, asked.text("input")), asked, errors.language);
}

Answer filters(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  auto const path = asked.text("input");
  auto const input = compiled_input(workspace, {.input = path}, errors);
  if (!input) return std::nullopt;
  auto const& name = input->machine ? input->machine->machine.name : path;
  return written(filters_answer(name, input->image), asked, errors.language);
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

Answer get(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  ValuesQuestion const question{.machine = {.input = asked.text("input")},
                                .words = split_list(asked.text("words"), ' ')};
  return written(values_answer(workspace, question), asked, errors.language);
}

Answer diff(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  auto const before = asked.text("before");
  auto const after = asked.text("input");
  auto const sides = compared_sides(workspace, before, after, errors);
  if (!sides) return std::nullopt;
  auto const difference = compare_machines(*sides->before, *sides->after, false);
  return written(
      difference_answer(
          {.before = before, .after = after, .difference = difference, .read_by_both = sides->read_by_both}),
      asked, errors.language);
}

/// Why there is none.
Failure no_image(Workspace& workspace, std::string const& path) {
  auto const read = workspace.files().read(path);
  auto const* const error = std::get_if<configuration::FileError>(&read);
  return error != nullptr ? unreadable(path, *error) : unusable_image(path, AXISRT_WRONG_MAGIC);
}

Answer inspect(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  InspectQuestion const question{.image = asked.text("input"), .axis = asked.find("axis")};
  auto const image = image_in(workspace, question.image);
  if (!image) throw no_image(workspace, question.image);
  return written(inspect_answer(question, *image), asked, errors.language);
}

Answer response(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  ResponseQuestion question;
  question.image = asked.text("input");
  question.axis = asked.find("axis");
  question.port = asked.word("port", ports);
  auto const input = compiled_input(workspace, {.input = question.image}, errors);
  if (!input) return std::nullopt;
  if (!question.axis) question.axis = input->axis();
  if (auto const list = asked.find("frequencies")) {
    question.frequencies = parse_frequencies(*list, input->image.contents.cycle_time);
  }
  return written(response_answer(question, input->image), asked, errors.language);
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
  question.recording = asked.find("recording");
  question.columns = {.input = asked.find("in"), .output = asked.find("out")};
  question.language = errors.language;
  auto const picture = picture_answer(workspace, question, errors);
  return picture ? Answer(pictures::svg(picture->figure, errors.language)) : std::nullopt;
}

Answer report(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  std::vector<Message> notes;
  auto report = report_answer(workspace,
                              {.input = asked.text("input"),
                               .cover = {.title = asked.find("title").value_or(""),
                                         .customer = asked.find("customer").value_or(""),
                                         .author = asked.find("author").value_or(""),
                                         .date = asked.find("date").value_or("")},
                               .before = asked.find("before"),
                               .language = errors.language},
                              errors, notes);
  return report ? Answer(std::move(report->page)) : std::nullopt;
}

Answer explain(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  return written(explain_answer({.word = asked.text("word"), .of_axes = workspace.settings().catalogue("-")}),
                 asked, errors.language);
}

/// The bytes of the file.
Answer fmu(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  constexpr std::array versions = {std::pair{std::string_view("3"), image::FmiVersion::three},
                                   std::pair{std::string_view("2"), image::FmiVersion::two}};
  auto const input = asked.text("input");
  auto const version = asked.word("version", versions);
  auto const machine =
      image_in(workspace, input) ? input : machine_of_input(workspace, {.input = input}).machine;
  auto const exported = exported_image(workspace, {.input = machine}, errors);
  if (!exported) return std::nullopt;
  image::FmuOptions const options{.version = version, .name = asked.find("name").value_or(model_name(input))};
  return exported_fmu(exported->file, options, {}).archive;
}

struct Question {
  std::string_view name, keys;
  Answer (*answer)(Workspace& workspace, Asked const& asked, ErrorSink const& errors);
};

constexpr std::array questions = {
    Question{.name = "machine", .keys = "input format", .answer = machine},
    Question{.name = "machines", .keys = "input format", .answer = machines},
    Question{.name = "filters", .keys = "input format", .answer = filters},
    Question{.name = "get", .keys = "input words format", .answer = get},
    Question{.name = "contour", .keys = "input format", .answer = contour},
    Question{.name = "delay_budget", .keys = "input format", .answer = delay_budget},
    Question{.name = "diff", .keys = "input before format", .answer = diff},
    Question{.name = "inspect", .keys = "input axis format", .answer = inspect},
    Question{.name = "response", .keys = "input axis port frequencies format", .answer = response},
    Question{.name = "picture",
             .keys = "input kind axis group before program plant move recording in out",
             .answer = picture},
    Question{.name = "compare", .keys = "input recording axis in out unit numbers format", .answer = compare},
    Question{
        .name = "circle",
        .keys = "input feed radius plane tolerance recording external setpoint actual unit numbers format",
        .answer = circle},
    Question{.name = "identify",
             .keys = "input recording axis actual force unit numbers format",
             .answer = identify},
    Question{.name = "report", .keys = "input before title customer author date", .answer = report},
    Question{.name = "fmu", .keys = "input version name", .answer = fmu},
    Question{.name = "explain", .keys = "word format", .answer = explain}};

}  // namespace

std::optional<std::string> answer(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  auto const name = asked.text("question");
  auto const* const found = std::find_if(questions.begin(), questions.end(),
                                         [&name](Question const& row) { return row.name == name; });
  if (found != questions.end()) {
    asked.refuse_others(std::string(found->keys) + " question");
    return found->answer(workspace, asked, errors);
  }
  std::string known;
  for (auto const& row : questions) known.append(known.empty() ? "" : ", ").append(row.name);
  throw BadArgument({says::not_a_question, {{"question", name}, {"known", known}}});
}

}  // namespace axisc::interface
