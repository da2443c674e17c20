// The sentences of the whole program, read from its sources: what the compiler cannot say of them.
#include "diagnostics/terminal.hpp"
#include "diagnostics/utf8.hpp"
#include "support/catch.hpp"
#include "support/file_contents.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

using namespace axisc;

namespace {

namespace fs = std::filesystem;

struct Source {
  fs::path path;
  std::string text;
};

struct Definition {
  std::string source;  ///< relative to the project
  std::string name;
  std::string english;
  std::string german;
};

std::vector<Source> sources_of_the_program() {
  std::vector<Source> sources;
  for (auto const& folder : fs::directory_iterator(AXISC_SOURCE_DIR)) {
    std::string const name = folder.path().filename().string();
    if (!folder.is_directory() || name == "build" || name == "tests" || name.starts_with('.')) continue;
    for (auto const& entry : fs::recursive_directory_iterator(folder.path())) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
      sources.push_back({entry.path(), test::file_contents(entry.path())});
    }
  }
  return sources;
}

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Reads what a definition consists of, one thing after the other; each says whether it was there.
class Reader {
 public:
  Reader(std::string_view text, std::size_t at) : rest_(text.substr(at)) {}

  bool token(std::string_view expected) {
    skip_blanks();
    if (!rest_.starts_with(expected)) return false;
    rest_.remove_prefix(expected.size());
    return true;
  }

  bool name(std::string& result) {
    skip_blanks();
    while (!rest_.empty() && is_name_character(rest_.front())) take(result);
    return !result.empty();
  }

  /// Literals one after the other are one.
  bool literals(std::string& result) {
    bool found = false;
    for (; raw_literal(result) || literal(result); found = true) {
    }
    return found;
  }

 private:
  bool raw_literal(std::string& result) {
    if (!token("R\"(")) return false;
    std::size_t const end = rest_.find(")\"");
    if (end == std::string_view::npos) return false;
    result += rest_.substr(0, end);
    rest_.remove_prefix(end + 2);
    return true;
  }

  bool literal(std::string& result) {
    if (!token("\"")) return false;
    while (!rest_.empty() && rest_.front() != '"') {
      if (rest_.front() != '\\') {
        take(result);
        continue;
      }
      rest_.remove_prefix(1);
      if (rest_.empty() || std::string_view("n\"\\").find(rest_.front()) == std::string_view::npos)
        return false;
      result += rest_.front() == 'n' ? '\n' : rest_.front();
      rest_.remove_prefix(1);
    }
    return token("\"");
  }

  void take(std::string& result) {
    result += rest_.front();
    rest_.remove_prefix(1);
  }
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \n"), rest_.size())); }

  std::string_view rest_;
};

std::optional<Definition> read_definition(std::string_view text, std::size_t at) {
  Reader reader(text, at);
  Definition found;
  bool const whole = reader.name(found.name) && reader.token("{") && reader.literals(found.english) &&
                     reader.token(",") && reader.literals(found.german) && reader.token("};");
  return whole ? std::optional(found) : std::nullopt;
}

std::vector<Definition> definitions(std::vector<Source> const& sources) {
  std::vector<Definition> result;
  for (Source const& source : sources) {
    std::string const path = source.path.lexically_relative(AXISC_SOURCE_DIR).generic_string();
    for (std::string_view const begin :
         {"\nconstexpr Sentence ", "\nconstinit Sentence const ", "\ninline constexpr Sentence "}) {
      for (std::size_t at = source.text.find(begin); at != std::string::npos;
           at = source.text.find(begin, at + 1)) {
        auto definition = read_definition(source.text, at + begin.size());
        INFO(path << ": " << source.text.substr(at, 120));
        REQUIRE(definition);
        definition->source = path;
        result.push_back(*std::move(definition));
      }
    }
  }
  return result;
}

std::vector<Definition> const& all_definitions() {
  static std::vector<Definition> const all = definitions(sources_of_the_program());
  return all;
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80; }));
}

/// The texts of the project that people read, with the sources that hold sentences.
std::vector<fs::path> readable_files() {
  std::vector<fs::path> files;
  for (auto at = fs::recursive_directory_iterator(AXISC_SOURCE_DIR); at != fs::recursive_directory_iterator();
       ++at) {
    std::string const name = at->path().filename().string();
    bool const is_foreign = name == "build" || name == "tests" || name == "uplot" || name == "node_modules" ||
                            name == "dist" || name.starts_with('.');
    if (at->is_directory() && is_foreign) at.disable_recursion_pending();
    std::string const extension = at->path().extension().string();
    for (std::string_view const readable : {".cpp", ".hpp", ".md", ".json", ".ts", ".html", ".js", ".yml"}) {
      if (extension == readable && !is_foreign) files.push_back(at->path());
    }
  }
  return files;
}

/// Without what is in backticks, or between lines of three.
std::string prose_of(std::string_view text) {
  std::string prose;
  bool in_code = false;
  while (!text.empty()) {
    std::size_t const mark = std::min(text.find('`'), text.size());
    if (!in_code) prose += text.substr(0, mark);
    text.remove_prefix(mark);
    std::size_t const after = std::min(text.find_first_not_of('`'), text.size());
    if (after > 0) in_code = !in_code;
    text.remove_prefix(after);
  }
  return prose;
}

/// A number with a decimal point, which is no number of a section; empty where there is none.
std::string number_with_point(std::string_view german) {
  static std::regex const number(R"((Abschnitt)?(^|[^\w.])\d+\.\d+(?!\w|\.\w))");
  std::string const prose = prose_of(german);
  for (std::sregex_iterator found(prose.begin(), prose.end(), number); found != std::sregex_iterator();
       ++found) {
    if (!(*found)[1].matched) return found->str();
  }
  return {};
}

/// Without the indented lines, the examples of a command's help: what one types.
std::string without_examples(std::string const& text) {
  static std::regex const example("(^|\n)  [^\n]*");
  return std::regex_replace(text, example, "");
}

/// "says::name" as a whole word.
bool says(std::string_view text, std::string const& name) {
  for (std::string const& word : {"says::" + name, "labels::" + name}) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
      if (at + word.size() == text.size() || !is_name_character(text[at + word.size()])) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("the sentences of all folders are found") {
  CHECK(all_definitions().size() > 800);
}

TEST_CASE("a sentence is well-formed UTF-8 on one line") {
  for (Definition const& definition : all_definitions()) {
    for (std::string const& sentence : {definition.english, definition.german}) {
      INFO(definition.source << " " << definition.name << ": " << sentence);
      CHECK(valid_utf8_prefix(sentence) == sentence.size());
      CHECK(printable(sentence) == sentence);
    }
  }
}

TEST_CASE("a sentence can be read at a glance, and says as much in one language as in the other") {
  for (Definition const& definition : all_definitions()) {
    std::size_t const english = characters(definition.english);
    std::size_t const german = characters(definition.german);
    INFO(definition.source << " " << definition.name << ": " << definition.english << " | "
                           << definition.german);
    CHECK(std::max(english, german) <= 240);
    // Of words and fragments one may well be twice as long.
    if (std::max(english, german) > 40) CHECK(std::max(english, german) < 2 * std::min(english, german));
  }
}

TEST_CASE("no text was read in one encoding and written in another") {
  auto const files = readable_files();
  CHECK(files.size() > 800);
  for (fs::path const& path : files) {
    std::string const text = test::file_contents(path);
    INFO(path);
    // How UTF-8 looks when it is read as windows-1252: each of its first bytes is one of these letters.
    for (std::string_view const letter : {"\u00C3", "\u00C2", "\u00E2\u20AC"}) {
      CHECK(text.find(letter) == std::string::npos);
    }
  }
}

TEST_CASE("German texts have decimal commas") {
  CHECK_FALSE(number_with_point("höchstens 12.5 mm, Abschnitt 3.2").empty());
  CHECK(number_with_point("`0.5` und 0,5, V3.1.3080.00").empty());
  for (Definition const& definition : all_definitions()) {
    INFO(definition.source << " " << definition.name << ": " << definition.german);
    CHECK(number_with_point(definition.german).empty());
  }
  for (fs::path const& path : readable_files()) {
    if (path.filename() != "de.md") continue;
    INFO(path);
    bool const is_help = path.parent_path().parent_path().filename() == "help";
    CHECK(number_with_point(is_help ? without_examples(test::file_contents(path)) : test::file_contents(path))
              .empty());
  }
  static std::regex const german(R"x("de": "([^"]*)")x");
  std::string const descriptions =
      test::file_contents(fs::path(AXISC_SOURCE_DIR) / "schema" / "axis-descriptions.json");
  for (std::sregex_iterator found(descriptions.begin(), descriptions.end(), german);
       found != std::sregex_iterator(); ++found) {
    INFO(found->str(1));
    CHECK(number_with_point(found->str(1)).empty());
  }
}

TEST_CASE("every sentence is said") {
  std::vector<Source> const sources = sources_of_the_program();
  for (Definition const& definition : all_definitions()) {
    bool const is_shared =
        definition.source.ends_with("/sentences.cpp") || definition.source.ends_with(".hpp");
    INFO(definition.source << " " << definition.name);
    CHECK(std::any_of(sources.begin(), sources.end(), [&](Source const& source) {
      return (is_shared || source.path.generic_string().ends_with('/' + definition.source)) &&
             says(source.text, definition.name);
    }));
  }
}
