#include "axisc/answers/replay/replay_report.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/files/csv.hpp"
#include "axisc/files/disk_files.hpp"
#include "axisc/files/image_file.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/command_line.hpp"
#include "cli/output/answer_output.hpp"

#include <cstdint>

namespace axisc::cli::says {

constexpr Sentence argument_flight_recording{
    "what axisrt_recorder_dump or `axisc run --record` wrote, or - for standard input",
    "was axisrt_recorder_dump oder `axisc run --record` geschrieben hat, oder - für die Standardeingabe"};
constexpr Sentence option_replayed_cycles{
    "write the recorded setpoints and outputs of every cycle to this CSV file",
    "die aufgezeichneten Sollwerte und Ausgaben jedes Zyklus in diese CSV-Datei schreiben"};

constexpr Sentence recording{
    "{file} is not a recording, is of another version, or is damaged ({status}); take the dump again",
    "{file} ist keine Aufzeichnung, hat eine andere Version oder ist beschädigt ({status}); den Abzug noch "
    "einmal machen"};
constexpr Sentence other_image{
    "{file} was recorded with another image ({status}); give the one that the controller used",
    "{file} wurde mit einem anderen Abbild aufgezeichnet ({status}); das angeben, das die Steuerung "
    "verwendet hat"};

constexpr Sentence level{"this processor does not have the instruction set that {file} was recorded with",
                         "dieser Prozessor hat den Befehlssatz nicht, mit dem {file} aufgezeichnet wurde"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

struct ReplayOptions {
  std::optional<std::string> image, recording, output;
  presentation::Format format = presentation::Format::text;
};

[[nodiscard]] Failure unusable_recording(std::string const& path, axisrt_status status) {
  if (status == AXISRT_NO_LEVEL) {
    return Failure({says::level, {{"file", path}}});
  }
  SentenceRef const text = status == AXISRT_OTHER_IMAGE ? says::other_image : says::recording;
  return Failure({text, {{"file", path}, {"status", axisrt_status_name(status)}}}, not_an_image);
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
  ReplayOptions options;
  CommandLine command_line("replay", invocation.language);
  command_line.argument("IMAGE.axim", options.image, says::argument_image);
  command_line.argument("RECORDING", options.recording, says::argument_flight_recording);
  command_line.value("-o,--output", "FILE.csv", options.output, says::option_replayed_cycles);
  declare_format(command_line, options.format);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.image.has_value(), "IMAGE.axim");
  command_line.require(options.recording.has_value(), "RECORDING");
  auto const image = load_image(*options.image);
  auto recording = open_recording(*options.recording, image);
  if (options.output) refuse_overwriting({*options.output}, {*options.image, *options.recording});
  std::optional<CycleTable> table;
  if (options.output) table.emplace(*options.output, image.contents);
  ReplayReport report(image.contents);
  image::ReplayedEntry entry;
  while (recording.next(entry)) {
    report.add(entry);
    if (table) table->add(entry);
  }
  if (recording.damaged()) throw unusable_recording(*options.recording, AXISRT_BAD_RECORDING);
  if (table) table->commit();
  print(report.answer(recording.level()), options.format, invocation, command_line);
  return report.differences() == 0 ? ExitStatus::success : ExitStatus::findings;
}

}  // namespace axisc::cli
