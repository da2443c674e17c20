#include "cli/help/help_page.hpp"

#include "help_folders.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace axisc::cli {

HelpPage help_page(std::string_view command, Language language) {
  auto const folder =
      std::find(help_folders.begin(), help_folders.end(), command.empty() ? "axisc" : command);
  if (folder == help_folders.end()) throw std::logic_error("no folder cli/help/" + std::string(command));
  auto const text = page_table()[static_cast<std::size_t>(folder - help_folders.begin())].in(language);
  constexpr std::string_view blank_line = "\n\n";
  auto const end = std::min(text.find(blank_line), text.size());
  return {.purpose = text.substr(0, end),
          .examples = text.substr(std::min(end + blank_line.size(), text.size()))};
}

}  // namespace axisc::cli
