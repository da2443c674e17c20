#include "diagnostics/fix_preview.hpp"
#include "diagnostics/location.hpp"
#include "diagnostics/shown_line.hpp"
#include "diagnostics/terminal.hpp"
#include "diagnostics/writers.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {
namespace {

Style style_of(Severity severity) {
  switch (severity) {
    case Severity::error:
      return Style::error;
    case Severity::warning:
      return Style::warning;
    case Severity::note:
      break;
  }
  return Style::note;
}

Text word_of(Severity severity) {
  switch (severity) {
    case Severity::error:
      return Text::word_error;
    case Severity::warning:
      return Text::word_warning;
    case Severity::note:
      break;
  }
  return Text::word_note;
}

/// How a place is pointed at: the finding's own with carets in its colour, the others with dashes.
struct Pointer {
  std::string_view arrow;
  char mark;
  Style style;
};

constexpr Pointer related_pointer{.arrow = ":::", .mark = '-', .style = Style::gutter};

class TextWriter {
 public:
  TextWriter(Finding const& finding, SourceSet const& sources, WriteOptions const& options)
      : finding_(finding), sources_(sources), language_(options.language), paint_(options.color) {
    if (finding.place) location_ = locate(*finding.place, sources);
    if (finding.fix) blocks_ = preview(*finding.fix, sources);
    gutter_width_ = std::to_string(largest_line_number()).size();
  }

  std::string write() && {
    out_.reserve(usual_size);
    write_headline();
    if (finding_.place) {
      Pointer const pointer{.arrow = "-->", .mark = '^', .style = style_of(finding_.severity)};
      write_place(finding_.place->source, location_, pointer, finding_.label ? &*finding_.label : nullptr);
    } else if (!finding_.file.empty()) {
      begin_arrow("-->");
      append_printable(out_, finding_.file);
      out_ += '\n';
    }
    for (Related const& related : finding_.related) {
      write_empty_gutter();
      write_place(related.place.source, locate(related.place, sources_), related_pointer, &related.message);
    }
    write_below();
    return std::move(out_);
  }

 private:
  static constexpr std::size_t usual_size = 512;

  [[nodiscard]] std::uint32_t largest_line_number() const {
    std::uint32_t largest = location_.begin.line;
    for (Related const& related : finding_.related) {
      largest = std::max(largest, sources_[related.place.source].position(related.place.span.begin).line);
    }
    for (PreviewBlock const& block : blocks_) {
      for (PreviewLine const& line : block.lines) largest = std::max(largest, line.number);
    }
    return largest;
  }

  /// As a view that the next call makes invalid.
  [[nodiscard]] std::string_view sentence(Message const& message) {
    rendered_.clear();
    append_rendered(rendered_, message, language_);
    return printed(rendered_);
  }
  [[nodiscard]] std::string_view printed(std::string_view text) {
    printed_.clear();
    append_printable(printed_, text);
    return printed_;
  }
  [[nodiscard]] std::string_view word(Text text) const { return text_template(text, language_); }

  void paint(Style style, std::string_view text) { paint_.append(out_, style, text); }

  void write_headline() {
    std::string head(word(word_of(finding_.severity)));
    head.append("[").append(code_text(finding_.code)).append("]");
    paint(style_of(finding_.severity), head);
    paint(Style::strong, std::string(": ").append(sentence(finding_.message)));
    out_ += '\n';
  }

  void begin_arrow(std::string_view arrow) {
    out_.append(gutter_width_, ' ');
    paint(Style::gutter, arrow);
    out_ += ' ';
  }

  void write_arrow(std::string_view arrow, std::string_view file, Position position) {
    begin_arrow(arrow);
    append_printable(out_, file);
    (out_ += ':') += std::to_string(position.line);
    (out_ += ':') += std::to_string(position.column);
    out_ += '\n';
  }

  void begin_gutter(std::string_view mark) {
    out_.append(gutter_width_ + 1, ' ');
    paint(Style::gutter, mark);
  }

  void write_empty_gutter() {
    begin_gutter("|");
    out_ += '\n';
  }

  [[nodiscard]] std::string numbered(std::uint32_t line) const {
    std::string const number = std::to_string(line);
    return std::string(gutter_width_ - number.size(), ' ') + number + ' ';
  }

  /// `label` may be null.
  void write_place(SourceId id, Location const& location, Pointer const& pointer, Message const* label) {
    write_arrow(pointer.arrow, location.file, location.begin);
    write_empty_gutter();

    SourceText const& source = sources_[id];
    std::size_t const begin = location.begin.column - 1;
    std::size_t const end =
        location.end.line == location.begin.line ? location.end.column - 1 : std::string_view::npos;
    std::string const line = source.utf8(source.line_span(location.begin.line));
    ShownLine const shown = show_line(line, {.begin = begin, .end = end});
    paint(Style::gutter, numbered(location.begin.line) + '|');
    ((out_ += ' ') += shown.text) += '\n';

    std::string marks(shown.width, pointer.mark);
    std::string_view const words = label == nullptr ? std::string_view() : sentence(*label);
    if (!words.empty()) (marks += ' ') += words;
    begin_gutter("|");
    (out_ += ' ') += shown.indent;
    paint(pointer.style, marks);
    out_ += '\n';
  }

  void write_below() {
    std::string const control = control_text(finding_, language_);
    bool const is_empty = finding_.notes.empty() && finding_.help.empty() && !finding_.fix && control.empty();
    if (is_empty) return;
    if (finding_.place || !finding_.related.empty()) write_empty_gutter();
    for (Message const& note : finding_.notes) write_line_below({}, sentence(note));
    if (!control.empty()) write_line_below(word(Text::word_control), printed(control));
    for (Message const& help : finding_.help) write_line_below(word(Text::word_help), sentence(help));
    if (finding_.fix) write_fix();
  }

  /// A colon separates `head` from the rest, where there is a head.
  void write_line_below(std::string_view head, std::string_view text) {
    begin_gutter("=");
    out_ += ' ';
    if (!head.empty()) paint(Style::strong, std::string(head).append(": "));
    (out_ += text) += '\n';
  }

  void write_fix() {
    write_line_below(word(Text::word_fix), sentence(finding_.fix->title));
    for (PreviewBlock const& block : blocks_) {
      if (!finding_.place || finding_.place->source != block.source) {
        write_arrow(related_pointer.arrow, sources_[block.source].name(), block.begin);
      }
      bool const replaces = std::any_of(block.lines.begin(), block.lines.end(),
                                        [](PreviewLine const& line) { return line.added; });
      for (PreviewLine const& line : block.lines) {
        // The finding's own line stands above already.
        bool const is_shown_above = replaces && !line.added && is_own_line(block.source, line.number);
        if (!is_shown_above) write_preview_line(line);
      }
    }
  }

  [[nodiscard]] bool is_own_line(SourceId source, std::uint32_t line) const {
    return finding_.place && finding_.place->source == source && location_.begin.line == line;
  }

  void write_preview_line(PreviewLine const& line) {
    ShownLine const shown = show_line(line.text, {.begin = line.first_change, .end = line.first_change});
    Style const style = line.added ? Style::added : Style::removed;
    paint(Style::gutter, numbered(line.number));
    paint(style, line.added ? "+" : "-");
    if (!shown.text.empty()) {
      out_ += ' ';
      paint(style, shown.text);
    }
    out_ += '\n';
  }

  Finding const& finding_;
  SourceSet const& sources_;
  Language language_;
  Painter paint_;
  Location location_;  ///< of the finding's own place
  std::vector<PreviewBlock> blocks_;
  std::size_t gutter_width_ = 1;
  std::string out_;
  std::string rendered_;
  std::string printed_;
};

}  // namespace

std::string write_text(Finding const& finding, SourceSet const& sources, WriteOptions const& options) {
  return TextWriter(finding, sources, options).write();
}

}  // namespace axisc
