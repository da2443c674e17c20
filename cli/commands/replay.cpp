#include "cli/codes.hpp"
#include "cli/options/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/report/csv.hpp"
#include "cli/files/disk_files.hpp"
#include "cli/files/image_file.hpp"
#include "cli/files/output_file.hpp"
#include "cli/formats/replay_report.hpp"

#include <cstdint>

namespace axisc::cli {

namespace {

enum class ReplayForm : std::uint8_t { text, json };

struct ReplayWords {
  std::optional<std::string> image, recording, output;
  ReplayForm form = ReplayForm::text;
};

[[nodiscard]] Failure unusable_recording(std::string const& path, axisrt_status status) {
  if (status == AXISRT_NO_LEVEL) {
    return Failure({.text = Text::cli_replay_level, .arguments = {{"file", path}}});
  }
  Text const text = status == AXISRT_OTHER_IMAGE ? Text::ax9004_other_image : Text::ax9004_recording;
  return Failure({.text = text, .arguments = {{"file", path}, {"status", axisrt_status_name(status)}}},
                 not_an_image);
}

image::Recording open_recording(std::string const& path, ImageFile const& image) {
  auto const bytes = read_whole(path);
  auto recording = image::Recording::open(image.bytes.bytes(), std::as_bytes(std::span(bytes)));
  if (auto const* const status = std::get_if<axisrt_status>(&recording)) {
    throw unusable_recording(path, *status);
  }
  return std::get<image::Recording>(std::move(recording));
}

/// One row for each cycle: setpoint and output of every axis.
class CycleTable {
 public:
  CycleTable(std::string const& path, image::ImageContents const& image) : file_(path) {
    text_ = "cycle";
    for (std::size_t axis = 0; axis < image.axes.size(); ++axis) {
      for (char const* const column : {".setpoint", ""}) {
        text_ += ',';
        append_csv_name(text_, axis_label(image, axis) + column);
      }
    }
    text_ += '\n';
  }
  void add(image::ReplayedEntry const& entry) {
    if (entry.kind != image::RecordedKind::step) return;
    row_.assign(1, static_cast<double>(entry.cycle));
    for (std::size_t axis = 0; axis < entry.in.size(); ++axis) {
      row_.insert(row_.end(), {entry.in[axis], entry.recorded[axis]});
    }
    append_csv_row(text_, row_);
    file_.write(text_);
    text_.clear();
  }
  void commit() {
    file_.write(text_);
    file_.commit();
  }

 private:
  OutputFile file_;
  std::string text_;
  std::vector<double> row_;
};

}  // namespace

ExitStatus replay(Invocation const& invocation) {
  ReplayWords words;
  CommandLine command_line("replay", Text::cli_replay_purpose, Text::cli_replay_examples,
                           invocation.language);
  command_line.argument("IMAGE.axim", words.image, Text::cli_arg_image);
  command_line.argument("RECORDING", words.recording, Text::cli_arg_recording);
  command_line.value("-o,--output", "FILE.csv", words.output, Text::cli_opt_replay_output);
  command_line.choice("--format", {{"text", ReplayForm::text}, {"json", ReplayForm::json}}, words.form,
                      Text::cli_opt_replay_format);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(words.image.has_value(), "IMAGE.axim");
  command_line.require(words.recording.has_value(), "RECORDING");
  auto const image = load_image(*words.image);
  auto recording = open_recording(*words.recording, image);
  if (words.output) refuse_overwriting(*words.output, {*words.image, *words.recording});
  std::optional<CycleTable> table;
  if (words.output) table.emplace(*words.output, image.contents);
  ReplayReport report(image.contents, invocation.language);
  image::ReplayedEntry entry;
  while (recording.next(entry)) {
    report.add(entry);
    if (table) table->add(entry);
  }
  if (recording.damaged()) throw unusable_recording(*words.recording, AXISRT_BAD_RECORDING);
  if (table) table->commit();
  auto const level = recording.level();
  invocation.streams.out.write(words.form == ReplayForm::json ? report.json(level) : report.text(level));
  return report.differences() == 0 ? ExitStatus::success : ExitStatus::findings;
}

}  // namespace axisc::cli
