#include "cli/commands/simulate_plant.hpp"

#include "axisc/answers/simulation/plant_formats.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"

namespace axisc::cli {

ExitStatus simulate_plant(SimulatedPlant const& asked, CheckedMachine const& checked,
                          Invocation const& invocation) {
  auto const run = run_plant(asked.request, checked, true);
  if (asked.output) {
    auto sources = checked.files;
    sources.push_back(asked.request.plant_path);
    refuse_overwriting({*asked.output}, sources);
    OutputFile file(*asked.output);
    file.write(plant_csv(run.without, run.with, run.cycle_seconds));
    file.commit();
  }
  auto& out = invocation.streams.out;
  switch (asked.format) {
    case SimulateFormat::text:
      out.write(plant_text(run.figures, invocation.language));
      break;
    case SimulateFormat::csv:
      out.write(plant_csv(run.without, run.with, run.cycle_seconds));
      break;
    case SimulateFormat::json:
      out.write(plant_json(run.figures));
      break;
  }
  return ExitStatus::success;
}

}  // namespace axisc::cli
