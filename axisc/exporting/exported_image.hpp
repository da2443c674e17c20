// What `axisc export` turns into something else: an image, or a machine that is compiled first.
#pragma once

#include "axisc/checking/machine_input.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/files/image_file.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct ExportedImage {
  ImageFile file;
  std::vector<std::string> sources;  ///< files that were read
};

/// An image as it is; a list, a machine file, a start-up list, or the only machine in a folder compiled.
/// After errors nothing is returned, and `errors` has taken them. Failure as load_image() and
/// checked_machine().
[[nodiscard]] std::optional<ExportedImage> exported_image(Workspace& workspace, MachineRequest const& request,
                                                          ErrorSink const& errors);

}  // namespace axisc
