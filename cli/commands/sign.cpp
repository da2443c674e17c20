#include "axisc/files/image_file.hpp"
#include "axisc/files/key_file.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/command_line.hpp"

namespace axisc::cli::says {

constexpr Sentence cli_signed{"{file}: signed with key {key}, {bytes} bytes",
                              "{file}: mit Schlüssel {key} signiert, {bytes} Bytes"};
constexpr Sentence option_secret_key{"secret key of `axisc keygen`", "geheimer Schlüssel von `axisc keygen`"};
constexpr Sentence option_signed_output{
    "signed image to write (default: IMAGE.axim itself)",
    "zu schreibendes signiertes Abbild (Standardwert: ABBILD.axim selbst)"};
constexpr Sentence option_no_summary{"no summary line", "keine Zusammenfassung"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

struct SignOptions {
  std::optional<std::string> image;
  std::optional<std::string> key;
  std::optional<std::string> output;
  bool quiet = false;
};

}  // namespace

ExitStatus sign(Invocation const& invocation) {
  SignOptions options;
  CommandLine command_line("sign", invocation.language);
  command_line.argument("IMAGE.axim", options.image, says::argument_image);
  command_line.value("--key", "KEY", options.key, says::option_secret_key);
  command_line.value("-o,--output", "OUT.axim", options.output, says::option_signed_output);
  command_line.flag("--quiet", options.quiet, says::option_no_summary);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.image.has_value(), "IMAGE.axim");
  command_line.require(options.key.has_value(), "--key");
  command_line.require(options.image != "-" || options.output, "-o");
  auto const key = load_secret_key(*options.key);
  auto const file = load_image(*options.image);
  auto const bytes = image::sign(file.bytes.bytes(), key);
  auto const& target = options.output ? *options.output : *options.image;
  // Without -o the image itself is replaced.
  refuse_overwriting({target}, {*options.key, options.output ? *options.image : *options.key});
  std::string_view const content(reinterpret_cast<char const*>(bytes.data()), bytes.size());
  if (options.output) {
    OutputFile output(target);
    output.write(content);
    output.commit();
  } else {
    auto const before = file.bytes.bytes();
    replace_content(target, {reinterpret_cast<char const*>(before.data()), before.size()}, content);
  }
  if (options.quiet) return ExitStatus::success;
  invocation.streams.err.write(render({says::cli_signed,
                                       {{"file", target},
                                        {"key", key_name(image::key_id(key.public_key()))},
                                        {"bytes", std::to_string(bytes.size())}}},
                                      invocation.language) +
                               "\n");
  return ExitStatus::success;
}

}  // namespace axisc::cli
