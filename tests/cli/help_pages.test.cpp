// The pages of cli/help: what commands say about themselves, in --help and on their manual pages.
#include "cli/commands/command_table.hpp"
#include "cli/help/help_page.hpp"
#include "cli/manual/man_page.hpp"
#include "cli/program.hpp"
#include "presentation/text_table.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"

#include <sstream>

namespace help_pages_test {

using namespace axisc;
using namespace axisc::cli;
using namespace axisc::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

/// Empty is the program itself.
std::vector<std::string> names_with_help() {
  std::vector<std::string> names{""};
  for (auto const& command : commands()) names.emplace_back(command.name);
  return names;
}

std::string page_of(std::string const& name, std::string const& language) {
  return read_source_file("cli/help/" + (name.empty() ? "axisc" : name) + "/" + language + ".md");
}

std::string shown_help(std::string const& name, std::string const& language) {
  std::vector<std::string> arguments{"--help", "--lang", language};
  if (!name.empty()) arguments.insert(arguments.begin(), name);
  return run_axisc(arguments).out;
}

/// One blank between words, so that texts can be compared whose lines break elsewhere.
std::string words_of(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::string words;
  for (std::string word; in >> word;) words += (words.empty() ? "" : " ") + word;
  return words;
}

}  // namespace

TEST_CASE("every command has a page in both languages, which its help begins and ends with") {
  for (auto const& name : names_with_help()) {
    for (auto const& [language, code] : {std::pair(Language::english, "en"), {Language::german, "de"}}) {
      INFO("cli/help/" << name << ", " << code);
      auto const [purpose, examples] = help_page(name, language);
      CHECK_FALSE(purpose.empty());
      CHECK_FALSE(examples.empty());
      CHECK(std::string(purpose) + "\n\n" + std::string(examples) == page_of(name, code));
      auto const help = words_of(shown_help(name, code));
      CHECK_THAT(help, StartsWith(words_of(purpose) + ' '));
      CHECK(help.ends_with(' ' + words_of(examples)));
    }
  }
}

TEST_CASE("the pages of help can be read as they are") {
  constexpr std::size_t widest = 110;
  for (auto const& name : names_with_help()) {
    for (std::string const language : {"en", "de"}) {
      std::istringstream lines(page_of(name, language));
      for (std::string line; std::getline(lines, line);) {
        INFO("cli/help/" << name << "/" << language << ".md: " << line);
        CHECK(presentation::display_width(line) <= widest);
        CHECK_FALSE(line.ends_with(' '));
      }
    }
  }
}

TEST_CASE("a manual page describes with the words of the help") {
  for (auto const& command : commands()) {
    auto const page = man_page(description_of(command), {}, {}, Language::english);
    auto const purpose = help_page(command.name, Language::english).purpose;
    INFO(command.name);
    CHECK_THAT(page, Contains(std::string(purpose.substr(0, purpose.find(' ')))));
    CHECK_THAT(page, Contains(".SH \"EXAMPLES\"\n.nf\naxisc " + std::string(command.name)));
  }
}

}  // namespace help_pages_test
