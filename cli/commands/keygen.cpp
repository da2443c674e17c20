#include "axisc/environment/failure.hpp"
#include "axisc/files/key_file.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/command_line.hpp"

namespace axisc::cli::says {

constexpr Sentence keys_made{
    "{file}: secret key, to be kept safe; {file}.pub: public key {key}",
    "{file}: geheimer Schlüssel, sicher zu verwahren; {file}.pub: öffentlicher Schlüssel {key}"};
constexpr Sentence argument_new_key{
    "file for the secret key; the public key is written next to it, with .pub appended",
    "Datei für den geheimen Schlüssel; der öffentliche kommt daneben, mit angehängtem .pub"};

}  // namespace axisc::cli::says

namespace axisc::cli {

ExitStatus keygen(Invocation const& invocation) {
  std::optional<std::string> path;
  CommandLine command_line("keygen", invocation.language);
  command_line.argument("KEY", path, says::argument_new_key);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(path.has_value(), "KEY");
  auto const key = image::make_secret_key();
  write_keys(*path, key);
  invocation.streams.out.write(
      render({says::keys_made, {{"file", *path}, {"key", key_name(image::key_id(key.public_key()))}}},
             invocation.language) +
      "\n");
  return ExitStatus::success;
}

}  // namespace axisc::cli
