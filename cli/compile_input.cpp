#include "cli/compile_input.hpp"

#include "cli/machine_outline.hpp"

#include <string_view>
#include <utility>

namespace axisc::cli {

namespace {

/// An image for a guessed cycle time would move every frequency.
void require_cycle_time(std::string const& input, validator::CheckResult const& result) {
  bool const is_machine = has_extension(input, ".json");
  // A machine file with mistakes is judged first: the cycle time may be one of them.
  if (result.cycle_time_known || (is_machine && !result.machine)) return;
  throw Failure({.text = is_machine ? Text::cli_machine_cycle_time_missing : Text::cli_cycle_time_missing,
                 .arguments = {{"file", input}}});
}

/// A configured filter is never left out silently.
void require_complete(validator::CheckResult const& result, SourceSet const& sources, Language language) {
  if (result.not_compiled.empty()) return;
  auto const& first = result.not_compiled.front();
  auto const& source = sources[first.place.source];
  throw Failure({.text = Text::cli_not_compiled,
                 .arguments = {{"place", source.name() + ":" +
                                             std::to_string(source.position(first.place.span.begin).line)},
                               {"feature", render(first.feature, language)}}});
}

CompiledImage image_of(validator::Machine const& machine, CompileJob const& job) {
  CompiledImage image;
  for (auto const& axis : machine.axes) {
    image.filters += axis.filters.size() + axis.interface_filters.size() + (axis.kernel ? 1 : 0);
    if (axis.position_control) image.filters += axis.position_control->stages.size();
  }
  image.axes = machine.axes.size();
  auto const bytes = codegen::write_image(machine, job.image, job.designs);
  image.bytes.assign(reinterpret_cast<char const*>(bytes.data()), bytes.size());
  return image;
}

void compile(CompileJob const& job, std::string const& path, validator::Files& files,
             CompiledInput& compiled) {
  SourceSet sources;
  std::deque<WrittenFinding> findings;
  FindingWriter writer(sources, job.form, keep_in(findings));
  auto const result =
      validator::check(files, path, options_for(job.check, path), sources, [&](Finding const& finding) {
        if (!job.words.quiet || finding.severity != Severity::note) writer.add(finding);
      });
  if (result.unreadable) throw unreadable(path, *result.unreadable);
  require_cycle_time(path, result);
  auto const counts = writer.counts();
  compiled.checked.findings = std::move(findings);
  compiled.checked.artifacts = writer.artifacts();
  compiled.checked.files = result.files;
  if (!result.machine || objectionable(job.words, counts)) return;
  require_complete(result, sources, job.form.write.language);
  compiled.image = image_of(*result.machine, job);
}

}  // namespace

CompiledInput compile_input(CompileJob const& job, std::string const& path, validator::Files& files) {
  CompiledInput compiled;
  try {
    compile(job, path, files, compiled);
  } catch (Failure const& failure) {
    compiled.checked.failure = failure;
  }
  return compiled;
}

std::string to_bytes(CompiledInput const& compiled) {
  ByteWriter bytes;
  write_bytes(bytes, compiled.checked);
  bytes.number(compiled.image ? 1 : 0);
  if (compiled.image) {
    bytes.number(compiled.image->axes);
    bytes.number(compiled.image->filters);
    bytes.text(compiled.image->bytes);
  }
  return std::move(bytes).take();
}

std::optional<CompiledInput> read_compiled_input(std::string_view text) {
  ByteReader bytes(text);
  auto checked = read_checked_input(bytes);
  if (!checked) return std::nullopt;
  CompiledInput compiled{.checked = *std::move(checked), .image = {}};
  if (bytes.number() != 0) {
    CompiledImage image;
    image.axes = static_cast<std::size_t>(bytes.number());
    image.filters = static_cast<std::size_t>(bytes.number());
    image.bytes = bytes.text();
    compiled.image = std::move(image);
  }
  return bytes.ok() ? std::optional(std::move(compiled)) : std::nullopt;
}

}  // namespace axisc::cli
