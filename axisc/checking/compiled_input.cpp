#include "axisc/checking/compiled_input.hpp"

#include "axisc/environment/failure.hpp"
#include "axisc/environment/sentences.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/format_number.hpp"

#include <variant>

namespace axisc::says {

constexpr Sentence other_cycle_time{
    "{file} was compiled for an NC cycle time of {image}, not {asked}; compile its lists for that one",
    "{file} wurde für eine NC-Zykluszeit von {image} kompiliert, nicht {asked}; die Listen dafür "
    "kompilieren"};

}  // namespace axisc::says

namespace axisc {

std::optional<ImageFile> image_in(Workspace& workspace, std::string const& path) {
  bool const is_called_so = ascii::has_extension(path, ".axim");
  auto const read = workspace.files().read(path);
  if (auto const* const text = std::get_if<std::string>(&read)) {
    bool const is_image = is_called_so || text->starts_with("AXIM");
    return is_image ? std::optional(image_of_bytes(path, *text)) : std::nullopt;
  }
  auto const error = std::get<configuration::FileError>(read);
  bool const is_binary =
      error == configuration::FileError::image || error == configuration::FileError::binary;
  return is_called_so || is_binary ? std::optional(load_image(path)) : std::nullopt;
}

std::optional<ImageFile> image_alone(Workspace& workspace, std::string const& path) {
  auto image = image_in(workspace, path);
  auto const& asked = workspace.overrides().options.cycle_time;
  if (!image || !asked || *asked == image->contents.cycle_time) return image;
  throw Failure({says::other_cycle_time,
                 {{"file", path},
                  {"image", exact_number(image->contents.cycle_time.microseconds()) + " µs"},
                  {"asked", exact_number(asked->microseconds()) + " µs"}}});
}

std::optional<InputImage> compiled_input(Workspace& workspace, MachineRequest const& request,
                                         ErrorSink const& errors) {
  auto const& input = request.input;
  if (auto image = image_alone(workspace, input)) {
    return InputImage{.image = std::move(*image), .machine = {}};
  }
  auto checked = checked_machine(workspace, request, errors);
  if (!checked) return std::nullopt;
  auto image = image_of(checked->machine, input);
  return InputImage{.image = std::move(image), .machine = std::move(checked)};
}

}  // namespace axisc
