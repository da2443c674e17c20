#include "axisc/exporting/exported_image.hpp"

#include "axisc/files/disk_files.hpp"

#include <variant>

namespace axisc {

namespace {

bool is_image(Workspace& workspace, std::string const& path) {
  auto const read = workspace.files().read(path);
  auto const* const error = std::get_if<configuration::FileError>(&read);
  if (error != nullptr) {
    return *error == configuration::FileError::image || *error == configuration::FileError::binary;
  }
  return std::get<std::string>(read).starts_with("AXIM");
}

}  // namespace

std::optional<ExportedImage> exported_image(Workspace& workspace, MachineRequest const& request,
                                            ErrorSink const& errors) {
  if (is_image(workspace, request.input)) {
    return ExportedImage{.file = load_image(request.input), .sources = {request.input}};
  }
  auto const checked = checked_machine(workspace, request, errors);
  if (!checked) return std::nullopt;
  return ExportedImage{.file = image_of(checked->machine, request.input, {.bounds = true}),
                       .sources = checked->files};
}

}  // namespace axisc
