// Manual pages in the language of man(7), from what --help is made of. Pure ASCII: other characters are
// named.
#pragma once

#include "cli/options/command_description.hpp"

#include <span>
#include <string>
#include <string_view>

namespace axisc::cli {

/// The edition that the foot of a page names.
struct Edition {
  std::string_view version;
  std::string_view date;  ///< "2026-11-23"
};

/// `listed` are the commands that the page of the program names.
[[nodiscard]] std::string man_page(CommandDescription const& command,
                                   std::span<CommandDescription const> listed, Edition const& edition,
                                   Language language);

}  // namespace axisc::cli
