// Writes manual pages and completions as packages contain them: axisc_manual FOLDER VERSION DATE
#include "cli/commands/command_table.hpp"
#include "cli/manual/completions.hpp"
#include "cli/manual/man_page.hpp"

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace axisc;
using namespace axisc::cli;

void write(std::filesystem::path const& path, std::string const& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream out(path, std::ios::binary);
  out.exceptions(std::ios::badbit | std::ios::failbit);
  out << text;
}

void write_manual(std::filesystem::path const& folder, Edition const& edition) {
  auto const program = program_description();
  std::vector<CommandDescription> described;
  for (auto const& command : commands()) described.push_back(description_of(command));
  for (auto const& [language, pages] :
       {std::pair(Language::english, "man/man1"), std::pair(Language::german, "man/de/man1")}) {
    write(folder / pages / "axisc.1", man_page(program, described, edition, language));
    for (auto const& command : described) {
      write(folder / pages / (page_name(command) + ".1"), man_page(command, {}, edition, language));
    }
  }
  write(folder / "bash-completion/completions/axisc", bash_completion(program, described));
  write(folder / "zsh/vendor-completions/_axisc", zsh_completion(program, described));
  write(folder / "fish/vendor_completions.d/axisc.fish", fish_completion(program, described));
}

}  // namespace

int main(int argc, char* argv[]) {
  try {
    constexpr int arguments = 4;
    if (argc != arguments) throw std::invalid_argument("usage: axisc_manual FOLDER VERSION DATE");
    write_manual(argv[1], {.version = argv[2], .date = argv[3]});
    return 0;
  } catch (std::exception const& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
