#include "cli/options/command_line.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/checking/depfile.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/environment/version.hpp"
#include "cli/options/help_text.hpp"
#include "cli/options/sentences.hpp"
#include "support/catch.hpp"

#include <array>
#include <cstdlib>

namespace command_line_test {

using namespace axisc;
using namespace axisc;
using namespace axisc::cli;

namespace {

constexpr Sentence option_fix{
    "write the fixes that do not change what the machine does; =all: the others as well",
    "die Korrekturen schreiben, die nicht ändern, was die Maschine tut; =all: auch die anderen"};
constexpr Sentence option_disable{"leave these codes out; may be repeated",
                                  "diese Codes weglassen; mehrmals möglich"};
constexpr Sentence option_quiet{"no notes and no summary", "keine Hinweise und keine Zusammenfassung"};
constexpr Sentence option_image_output{
    "the image to write, or - for standard output; an image that would not change is left untouched",
    "das Abbild, das geschrieben wird, oder - für die Standardausgabe; eines, das gleich bliebe, wird nicht "
    "angefasst"};
constexpr Sentence option_inspect_format{"output format (default: text)",
                                         "Ausgabeformat (Standardwert: text)"};

struct Words {
  std::vector<std::string> inputs;
  std::optional<std::string> output;
  std::vector<std::string> codes;
  bool quiet = false;
  int level = 0;
};

std::optional<std::string> read(Words& words, std::vector<std::string> const& arguments) {
  CommandLine line("lint", Language::english);
  line.arguments("INPUT...", words.inputs, cli::says::argument_inputs);
  line.value("-o,--output", "FILE", words.output, option_image_output);
  line.values("--disable", "CODE", words.codes, option_disable);
  line.flag("-q,--quiet", words.quiet, option_quiet);
  line.choice("--level", {{"low", 1}, {"high", 2}}, words.level, option_inspect_format);
  return line.read(arguments);
}

std::string failure_of(std::vector<std::string> const& arguments) {
  Words words;
  try {
    static_cast<void>(read(words, arguments));
  } catch (Failure const& failure) {
    return failure.what();
  }
  return "no failure";
}

}  // namespace

TEST_CASE("options and arguments in any order") {
  Words words;
  CHECK_FALSE(read(
      words, {"a", "--disable", "x,y", "-q", "b", "--output=c", "--disable", "z", "-", "--level", "high"}));
  CHECK(words.inputs == std::vector<std::string>{"a", "b", "-"});
  CHECK(words.output == "c");
  CHECK(words.codes == std::vector<std::string>{"x,y", "z"});
  CHECK(words.quiet);
  CHECK(words.level == 2);
}

TEST_CASE("letters stand together behind one dash, the value of the last behind them") {
  Words words;
  CHECK_FALSE(read(words, {"a", "-qoc"}));
  CHECK(words.inputs == std::vector<std::string>{"a"});
  CHECK(words.quiet);
  CHECK(words.output == "c");
}

TEST_CASE("behind -- everything is an argument") {
  Words words;
  CHECK_FALSE(read(words, {"-q", "--", "-o", "--what"}));
  CHECK(words.inputs == std::vector<std::string>{"-o", "--what"});
  CHECK_FALSE(words.output);
}

TEST_CASE("the last of several values counts, negative numbers are values") {
  Words words;
  CHECK_FALSE(read(words, {"-o", "a", "-o", "-5"}));
  CHECK(words.output == "-5");
}

TEST_CASE("complaints name the option and the way out") {
  CHECK(failure_of({"--quite"}) == "\"axisc lint\" has no option --quite; did you mean --quiet?");
  CHECK(failure_of({"--xyzzy=1"}) == "\"axisc lint\" has no option --xyzzy; `axisc lint --help` lists them");
  CHECK(failure_of({"--level", "medium"}) == "--level does not know \"medium\"; choose from low, high");
  CHECK(failure_of({"-o"}) == "option --output needs a value; `axisc lint --help` shows how it is written");
  CHECK(failure_of({"--quiet=1"}) ==
        "option --quiet takes no value; `axisc lint --help` shows how it is written");
}

TEST_CASE("help and version come before complaints") {
  Words words;
  CHECK(read(words, {"--help", "--xyzzy"}).value_or("").find("Usage: axisc lint [OPTIONS] INPUT...") !=
        std::string::npos);
  CHECK(read(words, {"--version"}) == version_text());
}

TEST_CASE("the version names commit and compiler") {
  CHECK(version_text().starts_with("axisc " AXISC_PROJECT_VERSION " (commit "));
  CHECK(version_text().find(", " AXISC_COMPILER "; image format ") != std::string::npos);
}

TEST_CASE("help rows break between words") {
  constexpr std::size_t width = 100;
  CHECK(help_row("-x", "short", width) == "  -x                          short\n");
  CHECK(help_row("--a-very-long-option NAME-OF-VALUE", "short", width) ==
        "  --a-very-long-option NAME-OF-VALUE\n                              short\n");
  CHECK(help_row("-x", std::string(69, 'a') + " b", width) ==
        "  -x                          " + std::string(69, 'a') + "\n                              b\n");
  CHECK(help_row("--option", "on a narrow terminal", 20) ==
        "  --option\n      on a narrow\n      terminal\n");
}

TEST_CASE("help is as wide as the terminal") {
  std::string const full(80, 'x');
  CHECK(help_paragraphs(full + "\nand its rest.\nA new paragraph\n\nExamples:\n  axisc lint x   one axis",
                        100) ==
        full + " and its rest.\nA new paragraph\n\nExamples:\n  axisc lint x   one axis\n");
  CHECK(help_paragraphs("One line becomes two.\n  axisc lint x   one axis", 20) ==
        "One line becomes\ntwo.\n  axisc lint x\n      one axis\n");
}

TEST_CASE("lists are split at commas") {
  CHECK(axisc::split_list(" a, b ,,c,") == std::vector<std::string>{"a", "b", "c"});
  CHECK(axisc::split_list("").empty());
}

TEST_CASE("dependency rules are escaped for make") {
  CHECK(dependency_rule("a b.axim", {"x#1.lis", "-", "$y.lis"}) ==
        "a\\ b.axim: \\\n  x\\#1.lis \\\n  $$y.lis\n");
}

TEST_CASE("the language is chosen before anything is read") {
  using Arguments = std::vector<std::string>;
  ::unsetenv("LC_ALL");
  ::unsetenv("LC_MESSAGES");
  ::setenv("LANG", "de_AT.UTF-8", 1);
  CHECK(choose_language(Arguments{}) == Language::german);
  CHECK(choose_language(Arguments{"lint", "--lang", "en"}) == Language::english);
  CHECK(choose_language(Arguments{"--lang=en"}) == Language::english);
  CHECK(choose_language(Arguments{"--", "--lang=en"}) == Language::german);
  ::setenv("LC_ALL", "C", 1);
  CHECK(choose_language(Arguments{}) == Language::english);
  CHECK(choose_language(Arguments{"--lang", "de"}) == Language::german);
  ::unsetenv("LC_ALL");
}

TEST_CASE("a flag may have a word, and one option may begin like another") {
  struct Given {
    std::optional<std::string> word, output, folder;
    bool quiet = false;
  };
  auto const given = [](std::vector<std::string> const& arguments) {
    Given words;
    CommandLine line("lint", Language::english);
    line.flag_with_value("--fix", "all", words.word, option_fix);
    line.value("-o,--output", "FILE", words.output, option_image_output);
    line.value("--output-folder", "FOLDER", words.folder, option_image_output);
    line.flag("-q,--quiet", words.quiet, option_quiet);
    CHECK_FALSE(line.read(arguments));
    return words;
  };
  CHECK(given({}).word == std::nullopt);
  CHECK(given({"--fix"}).word == "");
  CHECK(given({"--fix=all", "-q"}).word == "all");
  CHECK(given({"--output-folder", "f"}).folder == "f");
  CHECK(given({"--output-folder", "f"}).output == std::nullopt);
  CHECK(given({"-o", "-q"}).output == "-q");
  CHECK_FALSE(given({"-o", "-q"}).quiet);
}

}  // namespace command_line_test
