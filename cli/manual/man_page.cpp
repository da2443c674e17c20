#include "cli/manual/man_page.hpp"

#include "cli/help/help_page.hpp"
#include "cli/options/help_text.hpp"
#include "cli/options/sentences.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace axisc::cli::says {

constexpr Sentence man_name{"NAME", "NAME"};
constexpr Sentence man_synopsis{"SYNOPSIS", "ÜBERSICHT"};
constexpr Sentence man_description{"DESCRIPTION", "BESCHREIBUNG"};
constexpr Sentence man_commands{"COMMANDS", "BEFEHLE"};
constexpr Sentence man_options{"OPTIONS", "OPTIONEN"};
constexpr Sentence man_examples{"EXAMPLES", "BEISPIELE"};
constexpr Sentence man_exit_status{"EXIT STATUS", "RÜCKGABEWERT"};
constexpr Sentence man_see_also{"SEE ALSO", "SIEHE AUCH"};
constexpr Sentence man_command{"COMMAND", "BEFEHL"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

/// Lines of the source; readers of the page see them as wide as their terminal.
constexpr std::size_t source_width = 78;

enum class Dashes : std::uint8_t { hyphens, minuses };

/// Characters that mean something to the formatter, or are not ASCII, by their names. An option's dash is a
/// minus, which can be copied to a shell; that of a word is a hyphen.
std::string escaped(std::string_view text, Dashes dashes) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    auto const character = decode_utf8(text.substr(i));
    if (character.size > 1) {
      result += fmt::format("\\[u{:04X}]", static_cast<std::uint32_t>(character.value));
    } else if (text[i] == '\\') {
      result += "\\e";
    } else if (text[i] == '\'' && dashes == Dashes::minuses) {
      result += "\\(aq";
    } else if (text[i] == '-' &&
               (dashes == Dashes::minuses || i == 0 || text[i - 1] == ' ' || text[i - 1] == '-')) {
      result += "\\-";
    } else {
      result += text[i];
    }
    i += character.size;
  }
  return result;
}

std::string bold(std::string_view text) {
  return text.empty() ? "" : "\\fB" + escaped(text, Dashes::minuses) + "\\fR";
}

std::string italic(std::string_view text) {
  return text.empty() ? "" : "\\fI" + escaped(text, Dashes::minuses) + "\\fR";
}

/// Text between backticks is bold.
std::string with_fonts(std::string_view text) {
  std::string result;
  bool is_code = false;
  while (!text.empty()) {
    auto const part = text.substr(0, text.find('`'));
    result += is_code ? bold(part) : escaped(part, Dashes::hyphens);
    is_code = !is_code;
    text.remove_prefix(std::min(part.size() + 1, text.size()));
  }
  return result;
}

/// A line that begins with a dot or an apostrophe would be a request.
std::string guarded(std::string const& line) {
  return (line.starts_with('.') || line.starts_with('\'') ? "\\&" : "") + line;
}

std::string filled(std::string_view text) {
  std::string result;
  std::string line;
  auto const words = with_fonts(text);
  for (std::string_view rest = words; !rest.empty();) {
    auto const word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    if (!line.empty() && line.size() + 1 + word.size() > source_width) {
      result += guarded(std::exchange(line, {})) + "\n";
    }
    line.append(line.empty() ? "" : " ").append(word);
  }
  return result + guarded(line) + "\n";
}

class Page {
 public:
  explicit Page(Language language) : language_(language) {}

  [[nodiscard]] std::string say(SentenceRef sentence) const { return render({sentence}, language_); }

  void section(SentenceRef heading) {
    text += ".SH \"" + escaped(say(heading), Dashes::hyphens) + "\"\n";
    begins_ = true;
  }

  void row(OptionDescription const& option) {
    text += ".TP\n" + heading(option) + "\n" + filled(meaning_of(option, language_));
  }

  void rows(std::vector<OptionDescription> const& options, bool named) {
    for (auto const& option : options) {
      if (option.names.empty() != named) row(option);
    }
  }

  /// Paragraphs and indented examples; what --help gives a heading of its own has a section here.
  void body(std::string_view prose) {
    auto const source = help_paragraphs(prose, std::numeric_limits<std::size_t>::max());
    bool is_example = false;
    for (std::string_view rest = source; !rest.empty();) {
      auto const line = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(line.size() + 1);
      if (line.starts_with(' ') != is_example && !line.empty()) {
        is_example = !is_example;
        if (is_example && !std::exchange(begins_, false)) text += ".PP\n";
        text += is_example ? ".nf\n" : ".fi\n";
      }
      if (is_example) {
        std::size_t const indentation = line.find_first_not_of(' ') == 2 ? 2 : 0;
        if (!line.empty()) text += guarded(escaped(line.substr(indentation), Dashes::minuses)) + "\n";
      } else if (!line.empty()) {
        paragraph(line);
      }
    }
    if (is_example) text += ".fi\n";
  }

  std::string text;

 private:
  /// Names bold, placeholders italic.
  [[nodiscard]] std::string heading(OptionDescription const& option) const {
    auto const whole = heading_of(option, language_);
    auto const shown = placeholder_in(language_, option.shown);
    auto const names = whole.substr(0, whole.size() - shown.size());
    return bold(names) + italic(shown);
  }

  void paragraph(std::string_view line) {
    constexpr std::array exit_status{std::string_view("Exit status: "), std::string_view("Rückgabewert: ")};
    constexpr std::array examples{std::string_view("Examples:"), std::string_view("Example:"),
                                  std::string_view("Beispiele:"), std::string_view("Beispiel:")};
    if (std::find(examples.begin(), examples.end(), line) != examples.end()) {
      section(says::man_examples);
      return;
    }
    for (auto const heading : exit_status) {
      if (!line.starts_with(heading)) continue;
      section(says::man_exit_status);
      line.remove_prefix(heading.size());
    }
    if (!std::exchange(begins_, false)) text += ".PP\n";
    text += filled(line);
  }

  Language language_;
  bool begins_ = false;  ///< a paragraph right after a heading needs no request
};

}  // namespace

std::string man_page(CommandDescription const& command, std::span<CommandDescription const> listed,
                     Edition const& edition, Language language) {
  auto const name = page_name(command);
  auto const help = help_page(command.name, language);
  Page page(language);
  page.text = fmt::format(".\\\" Made of what --help prints.\n.TH {} 1 {} \"axisc {}\" axisc\n",
                          ascii::upper_case(name), edition.date, edition.version);
  page.section(says::man_name);
  page.text += filled(name + " - " + page.say(command.meaning));
  page.section(says::man_synopsis);
  page.text += ".B axisc" + (command.name.empty() ? "" : " " + command.name) + "\n";
  if (command.name.empty()) page.text += italic(page.say(says::man_command)) + " ";
  page.text += "[" + italic(page.say(says::help_options)) + "]";
  for (auto const& option : command.options) {
    if (option.names.empty()) page.text += " " + italic(placeholder_in(language, option.shown));
  }
  page.text += "\n";
  page.section(says::man_description);
  page.body(help.purpose);
  page.rows(command.options, false);
  if (!listed.empty()) page.section(says::man_commands);
  for (auto const& row : listed) page.row({.names = row.name, .meaning = row.meaning});
  page.section(says::man_options);
  page.rows(command.options, true);
  page.body(help.examples);
  page.section(says::man_see_also);
  if (!command.name.empty()) page.text += ".BR axisc (1)\n";
  for (auto const& row : listed) {
    page.text += ".BR axisc\\-" + row.name + " (1)" + (&row == &listed.back() ? "\n" : ",\n");
  }
  return page.text;
}

}  // namespace axisc::cli
