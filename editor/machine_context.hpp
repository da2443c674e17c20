// The machine that an open file belongs to.
#pragma once

#include "configuration/files.hpp"
#include "validator/options.hpp"

#include <functional>
#include <string>

namespace axisc::editor {

/// The options with which `lint` checks an input.
using OptionsOf = std::function<validator::CheckOptions(std::string const& path)>;

/// The input whose check covers the file: the nearest machine file or start-up list, in the file's folder or above, that
/// reads it; the file itself where there is none, and where it is a machine. Machine files come before start-up lists.
/// Cost: looks into every list of the folders.
[[nodiscard]] std::string machine_of(configuration::Files& files, std::string const& path,
                                     OptionsOf const& options);

}  // namespace axisc::editor
