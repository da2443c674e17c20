// What has to be written into the lists of a machine so that its axes get a chain.
#pragma once

#include "analysis/tuning/suggestion/list_lines.hpp"
#include "axisc/workspace/edited_files.hpp"
#include "validator/loading/loading.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace axisc {

/// The lines of one axis: those of the chain, and those that switch off what the axis has now or reset what
/// the new filters do not use.
struct AxisLines {
  std::string axis;
  std::string list;  ///< as the machine names it
  std::vector<tuning::ListLine> lines;
};

[[nodiscard]] AxisLines lines_of(validator::LoadedMachine const& machine, std::size_t axis,
                                 tuning::Chain const& chain, machine::KernelFamily family);

/// Lists with their new bytes: values are replaced where they stand, missing lines follow the last line of
/// their filter, or come at the end. Everything else is as it was.
struct ListEdits {
  EditedBytes original, edited;
  std::optional<std::string>
      refused;  ///< a list that cannot be edited in its notation; then nothing is edited
};

/// The lines of some axes, by index.
using LinesByAxis = std::vector<std::pair<std::size_t, std::vector<tuning::ListLine>>>;

/// What becomes of a line that says the default where no list gives the parameter.
enum class Defaults : std::uint8_t { left_out, written };

[[nodiscard]] ListEdits edit_lists(validator::LoadedMachine const& machine, LinesByAxis const& lines,
                                   SourceSet const& sources, Defaults defaults = Defaults::left_out);

[[nodiscard]] ListEdits edit_lists(validator::LoadedMachine const& machine,
                                   std::vector<std::size_t> const& axes, SourceSet const& sources,
                                   tuning::Chain const& chain, machine::KernelFamily family);

}  // namespace axisc
