#include "axisc/answers/difference/diff_words.hpp"
#include "diagnostics/terminal.hpp"

namespace axisc::says {

constexpr Sentence what{"what", "was"};
constexpr Sentence parameter{"parameter", "Parameter"};
constexpr Sentence effect{"effect", "Wirkung"};
constexpr Sentence before{"before", "vorher"};
constexpr Sentence after{"after", "nachher"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// A cell of a Markdown table: one line, without markup, links and names of users.
std::string cell(std::string const& text) {
  constexpr std::string_view markup = "|\\`*<~";
  std::string escaped;
  for (char const character : printable(text)) {
    if (markup.find(character) != std::string_view::npos) escaped += '\\';
    escaped += character;
    if (character == '@') escaped += "<!-- -->";
    bool const begins_link = escaped.ends_with("](") || escaped.ends_with("://") || escaped.ends_with("www.");
    if (begins_link) escaped.insert(escaped.size() - 1, 1, '\\');
  }
  return escaped;
}

class Markdown {
 public:
  Markdown(ShownDifference const& shown, DiffWords const& words)
      : words_(words),
        before_(shown.difference.of_one_machine ? cell(shown.before) : words.say(says::before)),
        after_(shown.difference.of_one_machine ? cell(shown.after) : words.say(says::after)) {}

  [[nodiscard]] std::string table(std::vector<DiffLine> const& lines, SentenceRef first_column) const {
    if (lines.empty()) return {};
    auto text = head(first_column);
    for (auto const& line : lines) text += row(cell(line.what), line);
    return text;
  }

  [[nodiscard]] std::string section(DiffSection const& section) const {
    auto text = "\n### " + cell(section.title) + "\n" + table(section.facts, says::what);
    if (!section.parameters.empty()) text += head(says::parameter);
    for (auto const& parameter : section.parameters) {
      auto what = cell(parameter.line.what);
      for (auto const* const words : {&parameter.meaning, &parameter.restart}) {
        if (!words->empty()) what += "<br>" + cell(*words);
      }
      for (auto const& places : parameter.places) {
        what += "<br>" + cell(places.front()) + (places.size() == 1 ? "" : " → " + cell(places.back()));
      }
      text += row(what, parameter.line);
    }
    return text + table(section.effects, says::effect);
  }

 private:
  [[nodiscard]] std::string head(SentenceRef first_column) const {
    return "\n| " + words_.say(first_column) + " | " + before_ + " | " + after_ + " |\n|---|---|---|\n";
  }
  static std::string row(std::string const& what, DiffLine const& line) {
    return "| " + what + " | " + cell(line.before) + " | " + cell(line.after) + " |\n";
  }

  DiffWords const& words_;
  std::string before_, after_;
};

}  // namespace

std::string diff_markdown(ShownDifference const& shown, Language language) {
  DiffWords const words(shown, language);
  Markdown const markdown(shown, words);
  std::string text = shown.difference.empty() ? words.nothing(cell(shown.before), cell(shown.after)) + "\n"
                                              : "**" + cell(shown.heading()) + "**\n";
  text += markdown.table(words.machine(), says::what);
  for (auto const& section : words.channels()) text += markdown.section(section);
  for (auto const& section : words.axes()) text += markdown.section(section);
  for (auto const& remark : words.remarks()) text += "\n" + cell(remark) + "\n";
  return text;
}

}  // namespace axisc
