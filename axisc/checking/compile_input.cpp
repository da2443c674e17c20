#include "axisc/checking/compile_input.hpp"

#include "axisc/checking/compilable.hpp"
#include "axisc/environment/failure.hpp"
#include "axisrt.h"
#include "codegen/aligned_bytes.hpp"

#include <string_view>
#include <utility>

namespace axisc::says {

constexpr Sentence refused_image{
    "{file}: no image was written, because a controller would refuse it ({status}: {reason}); correct the "
    "findings about that, whether they are shown or not",
    "{file}: es wurde kein Abbild geschrieben, weil eine Steuerung es ablehnen würde ({status}: {reason}); "
    "die Befunde dazu beheben, ob sie gezeigt werden oder nicht"};

}  // namespace axisc::says

namespace axisc {

namespace {

CompiledImage image_of(machine::Machine const& machine, CompileJob const& job, std::string const& path) {
  CompiledImage image;
  for (auto const& axis : machine.axes) {
    image.filters += axis.filters.size() + axis.interface_filters.size() + (axis.kernel ? 1 : 0);
    if (axis.position_control) image.filters += axis.position_control->stages.size();
  }
  image.axes = machine.axes.size();
  auto const bytes = codegen::write_image(machine, job.image, job.designs);
  codegen::AlignedBytes const aligned(bytes);
  if (auto const status = axisrt_verify(aligned.data(), aligned.size()); status != AXISRT_OK) {
    throw Failure(
        {says::refused_image,
         {{"file", path}, {"status", axisrt_status_name(status)}, {"reason", axisrt_status_text(status)}}});
  }
  image.bytes.assign(reinterpret_cast<char const*>(bytes.data()), bytes.size());
  return image;
}

void compile(CompileJob const& job, std::string const& path, CompiledInput& compiled) {
  CheckedInput checked;
  auto const judged = judge_input(
      job.workspace, path, checked,
      [&checked](Finding&& finding, SourceSet const&) { checked.findings.push_back(std::move(finding)); });
  if (checked.failure) throw Failure(*checked.failure);
  compiled.skipped = judged.result.is_other_list && job.skips_other_lists;
  // Errors first: one of them may be why the cycle time is not known.
  bool const ends_here = compiled.skipped || objectionable(job.checking, judged.counts);
  if (!ends_here) require_cycle_time(path, judged.result);
  compiled.checked = std::move(checked);
  if (ends_here) return;
  require_machine(path, judged.result, compiled.checked.sources, job.language);
  compiled.image = image_of(*judged.result.machine, job, path);
}

}  // namespace

CompiledInput compile_input(CompileJob const& job, std::string const& path) {
  CompiledInput compiled;
  try {
    compile(job, path, compiled);
  } catch (Failure const& failure) {
    compiled.checked.failure = failure;
  }
  if (compiled.checked.findings.empty()) compiled.checked.sources = {};
  return compiled;
}

}  // namespace axisc
