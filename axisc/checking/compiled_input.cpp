#include "axisc/checking/compiled_input.hpp"

#include "diagnostics/ascii.hpp"
#include "system/file.hpp"

#include <variant>

namespace axisc {

namespace {

/// Text is left to the check, which reports what is wrong with it.
bool may_be_image(configuration::Files& files, std::string const& input) {
  if (input == "-" || system::kind_of(input) == system::FileKind::folder) return false;
  if (ascii::has_extension(input, ".axim")) return true;
  bool is_image = false;
  auto const failed = files.read_pieces(input, [&](std::string_view beginning) {
    auto const checked = configuration::check_text(beginning);
    auto const* const error = std::get_if<configuration::FileError>(&checked);
    is_image = error != nullptr && *error == configuration::FileError::image;
    return false;
  });
  return !failed && is_image;
}

}  // namespace

std::optional<InputImage> compiled_input(Workspace& workspace, MachineRequest const& request,
                                         ErrorSink const& errors) {
  auto const& input = request.input;
  if (may_be_image(workspace.files(), input)) return InputImage{.image = load_image(input), .machine = {}};
  auto checked = checked_machine(workspace, request, errors);
  if (!checked) return std::nullopt;
  auto image = image_of(checked->machine, input);
  return InputImage{.image = std::move(image), .machine = std::move(checked)};
}

}  // namespace axisc
