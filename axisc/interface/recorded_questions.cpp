#include "axisc/interface/recorded_questions.hpp"

#include "axisc/answers/circle/circle_answer.hpp"
#include "axisc/answers/circle/circular_figure.hpp"
#include "axisc/answers/comparison/compare_answer.hpp"
#include "axisc/answers/execution/recorded_input.hpp"
#include "axisc/answers/identify/identify_answer.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/checking/compiled_input.hpp"
#include "presentation/pictures/svg.hpp"
#include "presentation/writers.hpp"

#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::interface {

namespace {

constexpr std::array numbers = {std::pair(std::string_view("recognised"), ScaledNumbers::recognised),
                                std::pair(std::string_view("scaled"), ScaledNumbers::shown),
                                std::pair(std::string_view("raw"), ScaledNumbers::raw)};

PositionUnits units(Asked const& asked) {
  return {.unit = asked.find("unit") ? asked.word("unit", recorded_units) : RecordedUnit::recognised,
          .numbers = asked.word("numbers", numbers)};
}

CircleQuestion circle_question(Asked const& asked) {
  CircleQuestion question;
  question.machine.input = asked.text("input");
  question.plane = asked.find("plane");
  for (auto const& text : asked.texts("feed")) {
    for (auto const& word : split_list(text)) {
      question.feeds.push_back(positive_number("--feed", word, "mm/min"));
    }
  }
  if (auto const radius = asked.find("radius")) {
    question.radius_mm = positive_number("--radius", *radius, "mm");
  }
  if (auto const most = asked.find("tolerance")) {
    question.tolerance_um = positive_number("--tolerance", *most, "µm");
  }
  question.recordings = asked.texts("recording");
  question.recorded.setpoints = axis_columns("--setpoint", asked.texts("setpoint"));
  question.recorded.actuals = axis_columns("--actual", asked.texts("actual"));
  question.recorded.units = units(asked);
  question.recorded.is_external = asked.word("external", no_or_yes);
  return question;
}

/// None: a picture.
std::optional<presentation::Format> format_or_picture(Asked const& asked) {
  std::vector<std::pair<std::string_view, std::optional<presentation::Format>>> rows(
      presentation::formats.begin(), presentation::formats.end());
  rows.emplace_back("svg", std::nullopt);
  return asked.word("format", rows);
}

}  // namespace

std::optional<std::string> compare(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  RecordedQuestion const question{.input = asked.text("input"),
                                  .recording = asked.text("recording"),
                                  .axis = asked.find("axis"),
                                  .commands = {},
                                  .columns = {.input = asked.find("in"), .output = asked.find("out")},
                                  .units = units(asked),
                                  .language = errors.language};
  auto const input = compiled_input(workspace, {.input = question.input}, errors);
  if (!input) return std::nullopt;
  auto const [axis, recorded] = recorded_input(question, *input);
  return presentation::write(compare_answer(axis_label(input->image.contents, axis), recorded),
                             asked.word("format", presentation::formats), {.language = errors.language});
}

std::optional<std::string> circle(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  auto const question = circle_question(asked);
  auto const format = format_or_picture(asked);
  Workspace tolerant(workspace.disk(), with_unlike_delays(workspace.overrides()));
  tolerant.put_all(workspace.unsaved());
  auto const test = circular_test(tolerant, question, errors);
  if (!test) return std::nullopt;
  if (!format) return pictures::svg(circular_figure(*test, errors.language), errors.language);
  return presentation::write(circle_answer(*test), *format, {.language = errors.language});
}

std::optional<std::string> identify(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  auto const found =
      identified_axis(workspace,
                      {.machine = {.input = asked.text("input")},
                       .recordings = asked.texts("recording"),
                       .axis = asked.find("axis"),
                       .columns = {.actual = asked.find("actual"), .force = asked.find("force")},
                       .units = units(asked)},
                      errors);
  if (!found) return std::nullopt;
  return presentation::write(identify_answer(*found), asked.word("format", presentation::formats),
                             {.language = errors.language});
}

}  // namespace axisc::interface
