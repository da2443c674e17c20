#include "cli/options/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/image_file.hpp"
#include "cli/files/key_file.hpp"
#include "cli/files/output_file.hpp"

namespace axisc::cli {

namespace {

struct SignWords {
  std::optional<std::string> image;
  std::optional<std::string> key;
  std::optional<std::string> output;
  bool quiet = false;
};

}  // namespace

ExitStatus sign(Invocation const& invocation) {
  SignWords words;
  CommandLine command_line("sign", Text::cli_sign_purpose, Text::cli_sign_examples, invocation.language);
  command_line.argument("IMAGE.axim", words.image, Text::cli_arg_image);
  command_line.value("--key", "KEY", words.key, Text::cli_opt_secret_key);
  command_line.value("-o,--output", "OUT.axim", words.output, Text::cli_opt_signed_output);
  command_line.flag("--quiet", words.quiet, Text::cli_opt_sign_quiet);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(words.image.has_value(), "IMAGE.axim");
  command_line.require(words.key.has_value(), "--key");
  command_line.require(words.image != "-" || words.output, "-o");
  auto const key = load_secret_key(*words.key);
  auto const file = load_image(*words.image);
  auto const bytes = image::sign(file.bytes.bytes(), key);
  auto const& target = words.output ? *words.output : *words.image;
  refuse_overwriting(target, {*words.key});
  OutputFile output(target);
  output.write({reinterpret_cast<char const*>(bytes.data()), bytes.size()});
  output.commit();
  if (words.quiet) return ExitStatus::success;
  invocation.streams.err.write(render({.text = Text::cli_signed,
                                       .arguments = {{"file", target},
                                                     {"key", key_name(image::key_id(key.public_key()))},
                                                     {"bytes", std::to_string(bytes.size())}}},
                                      invocation.language) +
                               "\n");
  return ExitStatus::success;
}

}  // namespace axisc::cli
