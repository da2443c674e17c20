#include "axisc/exporting/exported_image.hpp"

#include "axisc/checking/compiled_input.hpp"

#include <utility>

namespace axisc {

std::optional<ExportedImage> exported_image(Workspace& workspace, MachineRequest const& request,
                                            ErrorSink const& errors) {
  if (auto image = image_alone(workspace, request.input)) {
    return ExportedImage{.file = std::move(*image), .sources = {request.input}};
  }
  auto const checked = checked_machine(workspace, request, errors);
  if (!checked) return std::nullopt;
  return ExportedImage{.file = image_of(checked->machine, request.input, {.bounds = true}),
                       .sources = checked->files};
}

}  // namespace axisc
