// What a command says about itself, in --help and on its manual page: the files en.md and de.md in
// cli/help/COMMAND, which cmake/HelpFolders.cmake embeds.
#pragma once

#include "diagnostics/page.hpp"

#include <span>
#include <string_view>

namespace axisc::cli {

/// Paragraphs and indented examples, as help_paragraphs() of cli/options/help_text.hpp lays them out.
struct HelpPage {
  std::string_view purpose;   ///< the first paragraph: comes before the options
  std::string_view examples;  ///< what follows it: the last part of the help
};

/// The page of a command that the build found a folder for; the program itself has no name.
[[nodiscard]] HelpPage help_page(std::string_view command, Language language);

/// The embedded pages, in the order of `help_folders` (generated help_folders.hpp).
[[nodiscard]] std::span<Page const> page_table();

}  // namespace axisc::cli
