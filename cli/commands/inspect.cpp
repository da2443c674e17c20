#include "axisc/answers/inspect/inspect_answer.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/files/image_file.hpp"
#include "axisc/files/key_file.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/command_line.hpp"
#include "cli/output/answer_output.hpp"
#include "image/signature.hpp"

namespace axisc::cli::says {

constexpr Sentence not_an_image_unsigned{
    "{file} is not signed ({status}); `axisc sign {file} --key KEY` signs it",
    "{file} ist nicht signiert ({status}); `axisc sign {file} --key SCHLÜSSEL` signiert es"};
constexpr Sentence other_key{
    "{file} was signed with key {signer}, not with {key} ({status}); give the other public key, or sign "
    "again",
    "{file} wurde mit Schlüssel {signer} signiert, nicht mit {key} ({status}); den anderen öffentlichen "
    "Schlüssel angeben oder neu signieren"};
constexpr Sentence signature{
    "{file} was changed after it was signed with key {key} ({status}); copy it again, or compile and sign it "
    "again",
    "{file} wurde verändert, nachdem es mit Schlüssel {key} signiert war ({status}); neu kopieren oder neu "
    "kompilieren und signieren"};

constexpr Sentence option_public_key{
    "check the signature with this public key; exit status 2 if it is not valid",
    "die Signatur mit diesem öffentlichen Schlüssel prüfen; Rückgabewert 2, wenn sie nicht gültig ist"};
constexpr Sentence option_inspected_axis{"only this axis", "nur diese Achse"};
constexpr Sentence option_as_list{"write the lists back, with the origin of each value as a comment",
                                  "die Listen zurückschreiben, mit der Herkunft jedes Werts als Kommentar"};
constexpr Sentence option_memory{
    "also print the memory that the runtime needs on this target (host: this computer; 32-bit processors "
    "need less than portable)",
    "auch den Speicher nennen, den das Laufzeitsystem auf diesem Ziel braucht (host: dieser Rechner; "
    "32-Bit-Prozessoren brauchen weniger als portable)"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

/// Failure if the signature is not valid for this key.
void require_signature(std::string const& path, ImageFile const& file, std::string const& key_path) {
  auto const key = load_public_key(key_path);
  auto const status = image::check_signature(file.bytes.bytes(), key);
  if (status == AXISRT_OK) return;
  auto const wanted = image::key_id(key);
  auto const signer = image::signer(file.bytes.bytes());
  bool const other_key = signer && *signer != wanted;
  throw Failure({!signer     ? says::not_an_image_unsigned
                 : other_key ? says::other_key
                             : says::signature,
                 {{"file", path},
                  {"status", axisrt_status_name(status)},
                  {"key", key_name(wanted)},
                  {"signer", signer ? key_name(*signer) : ""}}},
                not_an_image);
}

}  // namespace

ExitStatus inspect(Invocation const& invocation) {
  std::optional<std::string> path, key;
  InspectQuestion question;
  auto format = presentation::Format::text;
  bool as_list = false;
  CommandLine command_line("inspect", invocation.language);
  command_line.argument("IMAGE.axim", path, says::argument_image);
  declare_format(command_line, format);
  command_line.value("--axis", "NAME", question.axis, says::option_inspected_axis);
  command_line.flag("--as-list", as_list, says::option_as_list);
  command_line.value("--key", "KEY.pub", key, says::option_public_key);
  command_line.choice<std::optional<std::uint32_t>>("--memory",
                                                    {{"host", AXISRT_LEVEL_AUTOMATIC},
                                                     {"portable", AXISRT_LEVEL_PORTABLE},
                                                     {"x86-64-v2", AXISRT_LEVEL_X86_64_V2},
                                                     {"x86-64-v3", AXISRT_LEVEL_X86_64_V3},
                                                     {"x86-64-v4", AXISRT_LEVEL_X86_64_V4},
                                                     {"aarch64", AXISRT_LEVEL_NEON}},
                                                    question.level, says::option_memory);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(path.has_value(), "IMAGE.axim");
  question.image = *path;
  auto const file = load_image(*path);
  if (key) require_signature(*path, file, *key);
  question.is_checked = key.has_value();
  if (as_list) {
    invocation.streams.out.write(inspect_as_list(question, file.contents, invocation.language));
  } else {
    print(inspect_answer(question, file), format, invocation, command_line);
  }
  return ExitStatus::success;
}

}  // namespace axisc::cli
