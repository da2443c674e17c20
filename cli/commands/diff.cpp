#include "cli/checking/machine_input.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/files/disk_files.hpp"
#include "cli/files/path_machine.hpp"
#include "cli/formats/diff_formats.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/inputs.hpp"
#include "cli/options/quantities.hpp"
#include "cli/sentences.hpp"

#include <variant>

namespace axisc::cli::says {

constexpr Sentence purpose{
    R"(Compares two axis lists, machine files or images: which parameters mean something else, and what that does to
the axes: delay, settling time, gain at the characteristic frequencies, deviation at a corner.)",
    R"(Vergleicht zwei Achslisten, Maschinendateien oder Abbilder: welche Parameter etwas anderes bedeuten und was das
mit den Achsen macht: Verzögerung, Einschwingzeit, Verstärkung bei den Kennfrequenzen, Abweichung an einer Ecke.)"};
constexpr Sentence examples{R"(Examples:
  axisc diff old/machine.json new/machine.json
  axisc diff x.lis.orig x.lis --cycle-time 1ms
  axisc diff running.axim machine.json --format markdown)",
                            R"(Beispiele:
  axisc diff alt/maschine.json neu/maschine.json
  axisc diff x.lis.orig x.lis --cycle-time 1ms
  axisc diff laufend.axim maschine.json --format markdown)"};
constexpr Sentence argument_diff{"two lists, machine files or images, also mixed",
                                 "zwei Listen, Maschinendateien oder Abbilder, auch gemischt"};
constexpr Sentence option_feed{"path feed in mm/min for the corner (default: 1000)",
                               "Bahnvorschub in mm/min für die Ecke (Standardwert: 1000)"};
constexpr Sentence option_format{"output format (default: text)", "Ausgabeformat (Standardwert: text)"};
constexpr Sentence option_exit_code{"exit status 1 if something changed",
                                    "Rückgabewert 1, wenn sich etwas geändert hat"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

enum class Format : std::uint8_t { text, json, markdown };

struct DiffOptions {
  std::vector<std::string> inputs;
  std::vector<std::string> schema_files;
  std::optional<std::string> cycle_time;
  std::optional<std::string> feed;
  Format format = Format::text;
  bool exit_code = false;
};

void declare(CommandLine& command_line, DiffOptions& options) {
  command_line.arguments("OLD NEW", options.inputs, says::argument_diff);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  command_line.value("--feed", "MM_PER_MIN", options.feed, says::option_feed);
  command_line.choice("--format",
                      {{"text", Format::text}, {"json", Format::json}, {"markdown", Format::markdown}},
                      options.format, says::option_format);
  declare_schema(command_line, options.schema_files);
  command_line.flag("--exit-code", options.exit_code, says::option_exit_code);
}

double feed_of(DiffOptions const& options) {
  constexpr double otherwise = 1000;
  if (!options.feed) return otherwise;
  auto const feed = parse_finite(*options.feed);
  if (!feed || !(*feed > 0)) {
    throw Failure(
        {.sentence = says::bad_number, .arguments = {{"option", "--feed"}, {"value", *options.feed}}});
  }
  return *feed;
}

bool is_image(std::string_view bytes) {
  return bytes.substr(0, 4) == "AXIM";
}

/// Returns the content of a file that has been read already; other files come from `files`.
class HeldFiles final : public configuration::Files {
 public:
  HeldFiles(configuration::Files& files, std::string path, std::string content)
      : files_(files), path_(std::move(path)), content_(std::move(content)) {}
  [[nodiscard]] std::variant<std::string, configuration::FileError> read(std::string const& path) override {
    if (path == path_) return content_;
    return files_.read(path);
  }
  [[nodiscard]] std::optional<configuration::FileError> read_pieces(
      std::string const& path, configuration::PieceReceiver const& receive) override {
    return path == path_ ? Files::read_pieces(path, receive) : files_.read_pieces(path, receive);
  }

 private:
  configuration::Files& files_;
  std::string path_, content_;
};

/// A list or machine is compiled to an image, so that both sides are compared as the runtime would execute them. None
/// after errors, which are printed.
std::optional<ImageFile> load_side(std::string const& input, CheckJob const& job,
                                   Invocation const& invocation, bool color) {
  auto const path = machine_input(input);
  DiskFiles disk(path == "-");
  auto read = disk.read(path);
  if (auto const* const error = std::get_if<configuration::FileError>(&read)) {
    if (*error == configuration::FileError::image || *error == configuration::FileError::binary) {
      return load_image(path);
    }
    throw unreadable(path, *error);
  }
  auto& content = std::get<std::string>(read);
  if (is_image(content)) return load_image(path);
  HeldFiles files(disk, path, std::move(content));
  auto const result = check_machine(job, path, files, invocation, color);
  if (!result) return std::nullopt;
  return image_of(*result->machine, path);
}

}  // namespace

ExitStatus diff(Invocation const& invocation) {
  DiffOptions options;
  CommandLine command_line("diff", says::purpose, says::examples, invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.inputs.size() == 2, "OLD NEW");
  double const feed = feed_of(options);
  SettingsFinder settings(options.schema_files);
  CheckJob job;
  job.options.cycle_time = asked_cycle_time(options.cycle_time);
  job.settings = &settings;
  bool const color = use_color(command_line.color(), system::Stream::error);
  auto const load = [&](std::string const& path) { return load_side(path, job, invocation, color); };
  auto const before = load(options.inputs[0]);
  auto const after = load(options.inputs[1]);
  if (!before || !after) return ExitStatus::findings;

  auto const difference =
      image::compare_images({.image = before->bytes.bytes(), .contents = before->contents},
                            {.image = after->bytes.bytes(), .contents = after->contents});
  ShownDifference const shown{.before = options.inputs[0],
                              .after = options.inputs[1],
                              .difference = difference,
                              .feed_mm_per_min = feed};
  switch (options.format) {
    case Format::text:
      invocation.streams.out.write(diff_text(shown, invocation.language));
      break;
    case Format::json:
      invocation.streams.out.write(diff_json(shown));
      break;
    case Format::markdown:
      invocation.streams.out.write(diff_markdown(shown, invocation.language));
      break;
  }
  return options.exit_code && !difference.empty() ? ExitStatus::findings : ExitStatus::success;
}

}  // namespace axisc::cli
