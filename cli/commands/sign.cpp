#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/files/image_file.hpp"
#include "cli/files/key_file.hpp"
#include "cli/files/output_file.hpp"
#include "cli/options/command_line.hpp"

namespace axisc::cli::says {

constexpr Sentence purpose{
    R"(Appends an Ed25519 signature to an image, so that controllers with the public key refuse any other image.
A signature that the image already has is replaced.)",
    R"(Hängt eine Ed25519-Signatur an ein Abbild an, sodass Steuerungen mit dem öffentlichen Schlüssel jedes andere
ablehnen. Eine Signatur, die das Abbild schon hatte, wird ersetzt.)"};
constexpr Sentence examples{R"(Examples:
  axisc sign mill.axim --key plant.key
  axisc sign mill.axim --key plant.key -o mill-signed.axim
  axisc inspect mill.axim --key plant.key.pub)",
                            R"(Beispiele:
  axisc sign fraese.axim --key werk.key
  axisc sign fraese.axim --key werk.key -o fraese-signiert.axim
  axisc inspect fraese.axim --key werk.key.pub)"};
constexpr Sentence cli_signed{"{file}: signed with key {key}, {bytes} bytes",
                              "{file}: mit Schlüssel {key} signiert, {bytes} Bytes"};
constexpr Sentence option_secret_key{"secret key of `axisc keygen`", "geheimer Schlüssel von `axisc keygen`"};
constexpr Sentence option_signed_output{
    "signed image to write (default: IMAGE.axim itself)",
    "zu schreibendes signiertes Abbild (Standardwert: ABBILD.axim selbst)"};
constexpr Sentence option_quiet{"no summary line", "keine Zusammenfassung"};

}  // namespace axisc::cli::says

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
  CommandLine command_line("sign", says::purpose, says::examples, invocation.language);
  command_line.argument("IMAGE.axim", words.image, says::argument_image);
  command_line.value("--key", "KEY", words.key, says::option_secret_key);
  command_line.value("-o,--output", "OUT.axim", words.output, says::option_signed_output);
  command_line.flag("--quiet", words.quiet, says::option_quiet);
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
  invocation.streams.err.write(render({.sentence = says::cli_signed,
                                       .arguments = {{"file", target},
                                                     {"key", key_name(image::key_id(key.public_key()))},
                                                     {"bytes", std::to_string(bytes.size())}}},
                                      invocation.language) +
                               "\n");
  return ExitStatus::success;
}

}  // namespace axisc::cli
