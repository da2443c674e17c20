#include "cli/commands/simulate_program.hpp"

#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "cli/output/printed_errors.hpp"
#include "cli/terminal/progress.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace axisc::cli {

namespace {

/// Passes the simulation's events to the summary and to the CSV of cycles.
class Recorder final : public motion::SimulationListener {
 public:
  void cycle(motion::MeasuredPoint const& point, motion::BlockSummary const& block) override {
    for (auto* const writer : cycles) writer->cycle(point, block);
  }
  void block(motion::BlockSummary const& found) override {
    if (summary) summary->block(found);
  }
  void pass(motion::PassSummary const& found) override {
    if (summary) summary->pass(found);
    if (!found.keeps_tolerance()) exceeded.push_back(found);
  }

  std::vector<CycleWriter*> cycles;
  std::vector<motion::PassSummary> exceeded;  ///< passes that do not keep their tolerance
  std::unique_ptr<SummaryWriter> summary;
};

}  // namespace

ExitStatus simulate_program(SimulatedProgram const& asked, CheckedMachine checked,
                            Invocation const& invocation) {
  auto request = asked.request;
  auto& machine = checked.machine;
  auto const index = chosen_group(machine, asked.group, request.machine_path);
  ProgramLines program(request.program_path);
  if (!survey_program(program, request, machine, index, printed_problems(invocation, asked.color))) {
    return ExitStatus::findings;
  }
  SimulatedPath const path{.group = machine.groups[index].name,
                           .axes = channel_of(machine, machine.groups[index]).axes,
                           .cycle_time = machine.cycle_time};
  auto& out = invocation.streams.out;
  TextSink const to_output = [&out](std::string_view text) { out.write(text); };
  Recorder recorder;
  std::optional<CycleWriter> printed;
  std::optional<OutputFile> file;
  std::optional<CycleWriter> filed;
  if (asked.output) {
    auto sources = checked.files;
    sources.push_back(request.program_path);
    refuse_overwriting({*asked.output}, sources);
    file.emplace(*asked.output);
    filed.emplace(path, [&file](std::string_view text) { file->write(text); });
    recorder.cycles.push_back(&*filed);
  }
  switch (asked.format) {
    case SimulateFormat::csv:
      printed.emplace(path, to_output);
      recorder.cycles.push_back(&*printed);
      break;
    case SimulateFormat::json:
      recorder.summary = json_summary(path, to_output);
      break;
    case SimulateFormat::text:
      recorder.summary = text_summary(path, invocation.language, to_output);
      break;
  }

  Progress progress(asked.show_progress, invocation.language);
  request.working = [&progress](double share, double seconds) { progress.show(share, seconds); };
  auto const followed = follow_program(program, request, machine, index, recorder);
  for (auto* const writer : recorder.cycles) writer->finish();
  if (recorder.summary) recorder.summary->finish(followed.blocks, followed.cycles);
  if (file) file->commit();
  for (auto const& pass : recorder.exceeded) {
    invocation.streams.err.write(not_kept(pass, request.program_path).line(invocation.language));
  }
  return recorder.exceeded.empty() ? ExitStatus::success : ExitStatus::findings;
}

}  // namespace axisc::cli
