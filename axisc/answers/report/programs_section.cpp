#include "axisc/answers/figures/path_figure.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "axisc/answers/simulation/program_answer.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/program_lines.hpp"
#include "configuration/machine/part.hpp"
#include "diagnostics/writers/writers.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence program_heading{"{program} in channel {group}", "{program} im Kanal {group}"};
constexpr Sentence not_followed{"The program is not followed:", "Dem Programm wird nicht gefolgt:"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

/// As `simulate` shows them.
Table passes_of(PathRecorder const& recorder, SimulatedPath const& path) {
  ProgramSummary summary(path);
  for (auto const& pass : recorder.passes()) summary.pass(pass);
  auto passes = summary.passes();
  passes.left_out = recorder.pass_count() - recorder.passes().size();
  return passes;
}

/// What `simulate` says of the program, or why it cannot follow it.
ReportBlocks followed(ReportSubject const& subject, std::size_t channel, std::string const& path) {
  // The channel alone; what the program's commands need is added to it.
  auto const& whole = *subject.machine;
  auto part = machine::part_of(whole, whole.groups[channel].axes);
  auto& machine = part.machine;
  auto const own = std::find(part.groups.begin(), part.groups.end(), channel);
  auto const group = static_cast<std::size_t>(own - part.groups.begin());
  ProgramRequest const request{.machine_path = subject.input, .program_path = path};
  ProgramLines program(path);
  std::string problems;
  TakeProblem const note = [&](Finding const& problem, SourceSet const& sources) {
    problems += write_text(problem, sources, {.language = subject.language, .color = false}) + "\n";
  };
  bool const is_followed = survey_program(program, request, machine, group, note);
  Verbatim told{.key = {}, .text = std::move(problems), .audience = Audience::people};
  if (!is_followed) return {Paragraph{says::not_followed}, std::move(told)};
  auto const& axes = machine.groups[group].axes;
  std::size_t const up = axes.size() > 1 ? 1 : 0;
  PathRecorder recorder(0, up);
  static_cast<void>(follow_program(program, request, machine, group, recorder));
  SimulatedPath const simulated{.group = machine.groups[group].name,
                                .axes = channel_of(machine, machine.groups[group]).axes,
                                .cycle_time = machine.cycle_time};
  auto figure = path_figure(recorder,
                            {.program = std::string(validator::file_name(path)),
                             .axes = {machine.axes[axes[0]].name, machine.axes[axes[up]].name},
                             .cycle_seconds = machine.cycle_time.seconds(),
                             .tolerance_um = std::nullopt},
                            subject.language);
  // The plane keeps its proportions; what is over time may be flat, so that a page holds the picture.
  constexpr double flat = 130;
  for (auto& panel : figure.panels) {
    if (&panel != &figure.panels.front()) panel.height = flat;
  }
  return {std::move(told), passes_of(recorder, simulated), Picture{std::move(figure)}};
}

}  // namespace

ReportBlocks programs_section(ReportSubject const& subject) {
  if (!subject.plots || subject.machine == nullptr) return {};
  ReportBlocks sections;
  auto const& groups = subject.machine->groups;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (groups[i].axes.empty()) continue;
    for (auto const& path : groups[i].programs) {
      std::string const name(validator::file_name(path));
      Section section{
          .key = {},
          .title = groups[i].name.empty() || groups.size() == 1
                       ? as_given(name)
                       : Words(says::program_heading, {{"program", name}, {"group", groups[i].name}}),
          .blocks = {},
          .id = "program-" + std::to_string(sections.size())};
      try {
        section.blocks = followed(subject, i, path);
      } catch (Failure const& failure) {
        // A filter that the runtime refuses, a file that is gone: the sentence takes the pictures' place.
        section.blocks = {Paragraph{as_given(failure.sentence(subject.language))}};
      }
      sections.emplace_back(std::move(section));
    }
  }
  return sections;
}

}  // namespace axisc
