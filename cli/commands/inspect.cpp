#include "cli/formats/inspect_formats.hpp"

#include "cli/codes.hpp"
#include "cli/options/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/image_file.hpp"
#include "cli/files/key_file.hpp"

namespace axisc::cli {

namespace {

enum class Form : std::uint8_t { text, json };
/// Levels, and nothing.
enum class Target : std::uint32_t {
  host = AXISRT_LEVEL_AUTOMATIC,
  portable = AXISRT_LEVEL_PORTABLE,
  x86_64_v2 = AXISRT_LEVEL_X86_64_V2,
  x86_64_v3 = AXISRT_LEVEL_X86_64_V3,
  x86_64_v4 = AXISRT_LEVEL_X86_64_V4,
  aarch64 = AXISRT_LEVEL_NEON,
  none
};

/// Failure where the signature is not right by this key.
void require_signature(std::string const& path, ImageFile const& file, std::string const& key_path) {
  auto const key = load_public_key(key_path);
  auto const status = image::check_signature(file.bytes.bytes(), key);
  if (status == AXISRT_OK) return;
  auto const wanted = image::key_id(key);
  auto const signer = image::signer(file.bytes.bytes());
  bool const other_key = signer && *signer != wanted;
  throw Failure({.text = !signer     ? Text::ax9004_unsigned
                         : other_key ? Text::ax9004_other_key
                                     : Text::ax9004_signature,
                 .arguments = {{"file", path},
                               {"status", axisrt_status_name(status)},
                               {"key", key_name(wanted)},
                               {"signer", signer ? key_name(*signer) : ""}}},
                not_an_image);
}

}  // namespace

ExitStatus inspect(Invocation const& invocation) {
  std::optional<std::string> path;
  std::optional<std::string> axis;
  std::optional<std::string> key;
  Form form = Form::text;
  Target target = Target::none;
  bool as_list = false;
  CommandLine command_line("inspect", Text::cli_inspect_purpose, Text::cli_inspect_examples,
                           invocation.language);
  command_line.argument("IMAGE.axim", path, Text::cli_arg_image);
  command_line.choice("--format", {{"text", Form::text}, {"json", Form::json}}, form,
                      Text::cli_opt_inspect_format);
  command_line.value("--axis", "NAME", axis, Text::cli_opt_inspect_axis);
  command_line.flag("--as-list", as_list, Text::cli_opt_as_list);
  command_line.value("--key", "KEY.pub", key, Text::cli_opt_public_key);
  command_line.choice("--memory",
                      {{"host", Target::host},
                       {"portable", Target::portable},
                       {"x86-64-v2", Target::x86_64_v2},
                       {"x86-64-v3", Target::x86_64_v3},
                       {"x86-64-v4", Target::x86_64_v4},
                       {"aarch64", Target::aarch64}},
                      target, Text::cli_opt_memory);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(path.has_value(), "IMAGE.axim");
  auto const file = load_image(*path);
  if (key) require_signature(*path, file, *key);
  Shown shown{.file = *path,
              .image = file.contents,
              .axes = chosen_axes(file.contents, axis),
              .signer = image::signer(file.bytes.bytes()),
              .signature_checked = key.has_value(),
              .memory = std::nullopt};
  if (target != Target::none) {
    shown.memory = image::runtime_memory(file.bytes.bytes(), static_cast<std::uint32_t>(target));
  }
  if (as_list) {
    if (file.contents.lists.empty()) {
      throw Failure({.text = Text::cli_stripped, .arguments = {{"file", *path}}});
    }
    invocation.streams.out.write(inspect_as_list(shown, invocation.language));
  } else {
    invocation.streams.out.write(form == Form::json ? inspect_json(shown)
                                                    : inspect_text(shown, invocation.language));
  }
  return ExitStatus::success;
}

}  // namespace axisc::cli
