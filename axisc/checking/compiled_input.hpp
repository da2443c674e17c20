// An image, or the image of a machine that is compiled in memory.
#pragma once

#include "axisc/checking/path_machine.hpp"
#include "axisc/files/image_file.hpp"

#include <optional>
#include <string>

namespace axisc {

/// The image that a file is: one called .axim, or whose bytes begin as those of an image, or are no text.
/// None for lists and folders. Failure for a damaged one. Unsaved bytes count; "-" is standard input.
[[nodiscard]] std::optional<ImageFile> image_in(Workspace& workspace, std::string const& path);

/// The same as the whole input. Failure where the options name another NC cycle time than the image has.
[[nodiscard]] std::optional<ImageFile> image_alone(Workspace& workspace, std::string const& path);

struct InputImage {
  ImageFile image;
  std::optional<CheckedMachine> machine;  ///< from which it was compiled; an image is read as it is

  /// For a list in its machine, see CheckedMachine.
  [[nodiscard]] std::optional<std::string> axis() const { return machine ? machine->axis : std::nullopt; }
  [[nodiscard]] std::optional<std::string> group() const { return machine ? machine->group : std::nullopt; }
};

/// The image of a list, a machine file, a start-up list, a project, the only machine in a folder, or an image
/// file. None after errors in lists. Failure where the input cannot be read or compiled.
[[nodiscard]] std::optional<InputImage> compiled_input(Workspace& workspace, MachineRequest const& request,
                                                       ErrorSink const& errors);

}  // namespace axisc
