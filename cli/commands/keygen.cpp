#include "cli/options/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/failure.hpp"
#include "cli/files/key_file.hpp"

namespace axisc::cli {

ExitStatus keygen(Invocation const& invocation) {
  std::optional<std::string> path;
  CommandLine command_line("keygen", Text::cli_keygen_purpose, Text::cli_keygen_examples,
                           invocation.language);
  command_line.argument("KEY", path, Text::cli_arg_new_key);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(path.has_value(), "KEY");
  auto const key = image::make_secret_key();
  write_keys(*path, key);
  invocation.streams.out.write(
      render({.text = Text::cli_keys_made,
              .arguments = {{"file", *path}, {"key", key_name(image::key_id(key.public_key()))}}},
             invocation.language) +
      "\n");
  return ExitStatus::success;
}

}  // namespace axisc::cli
