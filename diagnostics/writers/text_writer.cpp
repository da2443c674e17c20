#include "diagnostics/location.hpp"
#include "diagnostics/sentences.hpp"
#include "diagnostics/terminal.hpp"
#include "diagnostics/writers/fix_preview.hpp"
#include "diagnostics/writers/shown_line.hpp"
#include "diagnostics/writers/writers.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/compile.h>
#include <fmt/format.h>

namespace axisc {
namespace {

Style style_of(Severity severity) {
  switch (severity) {
    case Severity::error: return Style::error;
    case Severity::warning: return Style::warning;
    case Severity::note: break;
  }
  return Style::note;
}

SentenceRef word_of(Severity severity) {
  switch (severity) {
    case Severity::error: return says::word_error;
    case Severity::warning: return says::word_warning;
    case Severity::note: break;
  }
  return says::word_note;
}

/// How a place is marked: the finding's own with carets in its colour, others with dashes.
struct Pointer {
  std::string_view arrow;
  char mark;
  Style style;
};

/// Gutters of lines without a number: blanks, a sign, and the text after it.
constexpr std::size_t widest_gutter = 12;
constexpr std::string_view empty_line = "            |\n";
constexpr std::string_view line_below = "            | ";
constexpr std::string_view remark = "            = ";

constexpr Pointer related_pointer{.arrow = ":::", .mark = '-', .style = Style::gutter};

class TextWriter {
 public:
  TextWriter(std::string& out, Finding const& finding, SourceSet const& sources, WriteOptions const& options)
      : out_(out),
        finding_(finding),
        sources_(sources),
        language_(options.language),
        paint_(options.color),
        width_(options.width) {
    if (finding.place) location_ = locate(*finding.place, sources);
    if (finding.fix) blocks_ = preview(*finding.fix, sources);
    gutter_width_ = digits_of(largest_line_number());
  }

  void write() && {
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
  }

 private:
  [[nodiscard]] static std::size_t digits_of(std::uint32_t number) {
    std::size_t digits = 1;
    for (; number >= 10; number /= 10) ++digits;
    return digits;
  }

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

  /// The width left for a line of a source.
  [[nodiscard]] std::size_t room_beside_gutter() const {
    constexpr std::size_t narrowest = 24;
    constexpr std::size_t sign_and_blanks = 3;
    return std::max(width_, gutter_width_ + sign_and_blanks + narrowest) - gutter_width_ - sign_and_blanks;
  }

  void write_sentence(Message const& message) {
    append_rendered(out_, message, language_, Values::printable);
  }
  [[nodiscard]] std::string_view word(SentenceRef text) const { return text.in(language_); }

  void write_headline() {
    paint_.begin(out_, style_of(finding_.severity));
    (((out_ += word(word_of(finding_.severity))) += '[') += code_text(finding_.code)) += ']';
    paint_.end(out_);
    paint_.begin(out_, Style::strong);
    out_ += ": ";
    write_sentence(finding_.message);
    paint_.end(out_);
    out_ += '\n';
  }

  void begin_arrow(std::string_view arrow) {
    out_.append(gutter_width_, ' ');
    paint_.append(out_, Style::gutter, arrow);
    out_ += ' ';
  }

  void write_arrow(std::string_view arrow, std::string_view file, Position position) {
    begin_arrow(arrow);
    append_printable(out_, file);
    fmt::memory_buffer place;
    fmt::format_to(fmt::appender(place), FMT_COMPILE(":{}:{}\n"), position.line, position.column);
    out_.append(place.data(), place.size());
  }

  /// The gutter of a line without a number. `wide` is that of a number of any length.
  void write_gutter(std::string_view wide) {
    std::size_t const width = gutter_width_ + 1;
    std::string_view const behind = wide.substr(widest_gutter);
    if (!paint_.colors()) {
      out_ += wide.substr(widest_gutter - width);
      return;
    }
    out_.append(width, ' ');
    paint_.append(out_, Style::gutter, behind.substr(0, 1));
    out_ += behind.substr(1);
  }
  void write_empty_gutter() { write_gutter(empty_line); }

  /// The number of a line, as wide as the gutter, and the text after it.
  void write_line_number(std::uint32_t line, std::string_view behind) {
    fmt::format_int const number(line);
    out_.append(gutter_width_ - number.size(), ' ');
    (out_.append(number.data(), number.size()) += ' ') += behind;
  }

  /// `label` may be null.
  void write_place(SourceId id, Location const& location, Pointer const& pointer, Message const* label) {
    write_arrow(pointer.arrow, location.file, location.begin);
    write_empty_gutter();

    SourceText const& source = sources_[id];
    std::size_t const begin = location.begin.column - 1;
    std::size_t const end =
        location.end.line == location.begin.line ? location.end.column - 1 : std::string_view::npos;
    std::string room;
    std::string_view const line = source.utf8(source.shown_line(location.begin.line), room);
    ShownLine const shown(line, {.begin = begin, .end = end}, room_beside_gutter());
    paint_.begin(out_, Style::gutter);
    write_line_number(location.begin.line, "|");
    paint_.end(out_);
    out_ += ' ';
    shown.append_text(out_);
    out_ += '\n';
    write_gutter(line_below);
    shown.append_indent(out_);
    paint_.begin(out_, pointer.style);
    out_.append(shown.width(), pointer.mark);
    if (label != nullptr) {
      out_ += ' ';
      write_sentence(*label);
    }
    paint_.end(out_);
    out_ += '\n';
  }

  void write_below() {
    bool const says_reaction = has_control_text(finding_);
    if (finding_.notes.empty() && finding_.help.empty() && !finding_.fix && !says_reaction) return;
    if (finding_.place || !finding_.related.empty()) write_empty_gutter();
    for (Message const& note : finding_.notes) {
      begin_line_below({});
      write_sentence(note);
      out_ += '\n';
    }
    if (says_reaction) {
      begin_line_below(word(says::word_control));
      append_control_text(out_, finding_, language_, Values::printable);
      out_ += '\n';
    }
    for (Message const& help : finding_.help) {
      begin_line_below(word(says::word_help));
      write_sentence(help);
      out_ += '\n';
    }
    if (finding_.fix) write_fix();
  }

  /// A colon separates `head` from the rest, if there is a head.
  void begin_line_below(std::string_view head) {
    write_gutter(remark);
    if (head.empty()) return;
    paint_.begin(out_, Style::strong);
    (out_ += head) += ": ";
    paint_.end(out_);
  }

  void write_fix() {
    begin_line_below(word(says::word_fix));
    write_sentence(finding_.fix->title);
    out_ += '\n';
    for (PreviewBlock const& block : blocks_) {
      if (!finding_.place || finding_.place->source != block.source) {
        write_arrow(related_pointer.arrow, sources_[block.source].name(), block.begin);
      }
      bool const replaces = std::any_of(block.lines.begin(), block.lines.end(),
                                        [](PreviewLine const& line) { return line.added; });
      for (PreviewLine const& line : block.lines) {
        // The finding's own line has been printed above already.
        bool const is_shown_above = replaces && !line.added && is_own_line(block.source, line.number);
        if (!is_shown_above) write_preview_line(line);
      }
    }
  }

  [[nodiscard]] bool is_own_line(SourceId source, std::uint32_t line) const {
    return finding_.place && finding_.place->source == source && location_.begin.line == line;
  }

  void write_preview_line(PreviewLine const& line) {
    ShownLine const shown(line.text, {.begin = line.first_change, .end = line.first_change},
                          room_beside_gutter());
    Style const style = line.added ? Style::added : Style::removed;
    paint_.begin(out_, Style::gutter);
    write_line_number(line.number, "");
    paint_.end(out_);
    paint_.append(out_, style, line.added ? "+" : "-");
    if (!line.text.empty()) {
      out_ += ' ';
      paint_.begin(out_, style);
      shown.append_text(out_);
      paint_.end(out_);
    }
    out_ += '\n';
  }

  std::string& out_;
  Finding const& finding_;
  SourceSet const& sources_;
  Language language_;
  Painter paint_;
  std::size_t width_;
  Location location_;  ///< of the finding's own place
  std::vector<PreviewBlock> blocks_;
  std::size_t gutter_width_ = 1;
};

}  // namespace

std::string write_text(Finding const& finding, SourceSet const& sources, WriteOptions const& options) {
  std::string text;
  TextWriter(text, finding, sources, options).write();
  return text;
}

}  // namespace axisc
