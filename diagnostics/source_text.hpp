// One source file: its bytes never change, everything else is a view.
#pragma once

#include "diagnostics/span.hpp"

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc {

/// UTF-8 where the bytes are valid UTF-8, else windows-1252: real lists carry umlauts in single-byte
/// encodings.
enum class Encoding : std::uint8_t { utf8, utf8_with_mark, windows_1252 };

/// Some lines of a long text: those that findings point at.
struct Excerpt {
  std::string bytes;                   ///< the lines, each followed by LF; no byte order mark
  std::vector<std::uint32_t> numbers;  ///< which lines of the whole text these are, from 1, ascending
  Encoding encoding = Encoding::utf8;  ///< of the whole text
};

class SourceText;

/// A list inside another file: the text of a CDATA section.
struct Window {
  SourceText const& file;
  Span span;                           ///< the list in it
  Encoding encoding = Encoding::utf8;  ///< of the file
};

/// A piece of a list, a name or a value, and the bytes of its file that it stems from.
struct TranslatedPiece {
  Span list;
  Span file;
};

/// A list that its file has in another notation: XML.
struct Translation {
  std::string file;                     ///< all of its bytes
  std::string list;                     ///< the same as lines `name value`, in the file's encoding
  std::vector<TranslatedPiece> pieces;  ///< in the order of the list, without overlaps
  Encoding encoding = Encoding::utf8;   ///< of both
};

/// The text of one source. Offsets count bytes from the start of the file, the byte order mark included.
/// Facts about the text are determined on first use, so a SourceText must not be used by several threads at
/// once.
class SourceText {
 public:
  /// `name` is the path that findings show, as written by the user or in the machine file. `bytes` are at
  /// most 4 GiB - 1 long (offsets have 32 bits; the file reader has a much lower limit).
  SourceText(std::string name, std::string bytes);
  /// Offsets count bytes of the excerpt; lines count lines of the whole text.
  SourceText(std::string name, Excerpt excerpt);
  /// Offsets count bytes from the beginning of the line in which the window begins; lines and columns are
  /// those of the file. The file is not copied, and its lines are counted once for all of its windows.
  SourceText(std::string name, Window const& window);
  /// bytes() are those of the file, a line end, and the list, where text_begin() is. Places in the list are
  /// shown as the lines and columns in the file that they stem from; such a text is not edited.
  SourceText(std::string name, Translation translation);

  [[nodiscard]] std::string const& name() const { return name_; }
  [[nodiscard]] std::string_view bytes() const { return bytes_; }
  /// The text is part of a file, which contains more than this list.
  [[nodiscard]] bool is_window() const { return is_window_; }
  [[nodiscard]] bool is_translation() const { return is_translation_; }
  /// The list alone, for a window without the text before it on its first line.
  [[nodiscard]] std::string_view list_bytes() const {
    return bytes_.substr(is_window_ || is_translation_ ? text_begin_ : 0);
  }
  /// All bytes of the file, and where bytes() begin in it.
  [[nodiscard]] std::shared_ptr<std::string const> const& file() const { return file_; }
  [[nodiscard]] std::uint32_t file_offset() const {
    return static_cast<std::uint32_t>(bytes_.data() - file_->data());
  }
  /// The lines of the file before bytes(): 0 unless this is a window.
  [[nodiscard]] std::uint32_t lines_before() const { return lines_before_; }
  /// True if bytes() are only some lines: such a text can be shown, not edited.
  [[nodiscard]] bool is_excerpt() const { return !numbers_.empty(); }
  /// Cost: one pass on first use, here or in a function that depends on it.
  [[nodiscard]] Encoding encoding() const { return characters().encoding; }
  /// Offset of the first byte after a byte order mark; for a window and a translated list, the offset where
  /// the list begins. A marked file whose bytes are not all UTF-8 is windows-1252, but its mark is not text
  /// either.
  [[nodiscard]] std::uint32_t text_begin() const { return text_begin_; }

  /// Line and column of a byte; inside a character those of the character, after the last byte those of the
  /// end. Cost: some hundred bytes, unless the line is that of the previous call, and the code points of one
  /// line. Lines are counted on the first call (one pass).
  [[nodiscard]] Position position(std::uint32_t offset) const;
  /// Bytes of line `line` (from 1) without its line end (LF or CRLF) and without a byte order mark; empty, at
  /// the end of the file, for a line that does not exist or is not in the excerpt.
  [[nodiscard]] Span line_span(std::uint32_t line) const;
  /// line_span(), and on the first line of a window the text before the list: columns count from here.
  [[nodiscard]] Span shown_line(std::uint32_t line) const;
  /// At least 1: the empty line after a final line end counts, so that every offset has a line. For an
  /// excerpt, the number of lines in it.
  [[nodiscard]] std::uint32_t line_count() const;

  [[nodiscard]] std::string_view slice(Span span) const { return bytes_.substr(span.begin, span.size()); }
  /// The bytes of `span` as well-formed UTF-8; bytes that cannot be decoded become U+FFFD.
  [[nodiscard]] std::string utf8(Span span) const;
  /// A view of the bytes of `span` as well-formed UTF-8: into the text itself if possible, otherwise into
  /// `room`.
  [[nodiscard]] std::string_view utf8(Span span, std::string& room) const;
  /// `text` (UTF-8) in this source's encoding; a character that windows-1252 lacks becomes '?'.
  [[nodiscard]] std::string encode(std::string_view text) const;

 private:
  /// A line of bytes(), counted from 1 also in an excerpt: its begin, and the offset of its LF or the end of
  /// the bytes.
  struct Line {
    std::uint32_t number = 0;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };

  struct Characters {
    bool are_ascii = false;
    Encoding encoding = Encoding::utf8;
  };

  Characters const& characters() const;
  void count_lines() const;
  /// The line of a byte, and the line of a number between 1 and the number of all lines. Both cache the line
  /// in last_line_.
  Line const& line_at(std::uint32_t offset) const;
  Line const& line_numbered(std::uint32_t number) const;
  Line const& keep_line(std::uint32_t number, std::size_t begin) const;
  /// Where columns of a line count from.
  [[nodiscard]] std::uint32_t column_begin(Line const& line) const;
  /// The place in the file that a byte of a translated list stems from.
  [[nodiscard]] std::uint32_t in_file(std::uint32_t offset) const;
  [[nodiscard]] bool is_utf8(Span span) const;

  std::string name_;
  std::shared_ptr<std::string const> file_;
  std::string_view bytes_;  ///< looks into `file_`
  std::uint32_t text_begin_ = 0;
  std::uint32_t lines_before_ = 0;
  std::uint32_t first_column_ = 0;  ///< where the columns of the first line count from
  bool is_window_ = false;
  bool is_translation_ = false;
  std::vector<TranslatedPiece> pieces_;  ///< offsets of both count bytes of bytes()
  std::vector<std::uint32_t> numbers_;   ///< of an excerpt's lines, the empty one at its end included
  mutable std::optional<Characters> characters_;
  /// Number of LF before each block of the bytes, and at the end their total; empty until first used.
  mutable std::vector<std::uint32_t> line_ends_before_;
  mutable Line last_line_;  ///< that was asked for, number 0 where none was
};

enum class SourceId : std::uint32_t {};

/// All sources of one check; ids and references are valid as long as the set.
class SourceSet {
 public:
  SourceId add(SourceText text) {
    texts_.push_back(std::move(text));
    return static_cast<SourceId>(texts_.size() - 1);
  }
  [[nodiscard]] SourceText const& operator[](SourceId id) const {
    return texts_[static_cast<std::size_t>(id)];
  }
  [[nodiscard]] std::size_t size() const { return texts_.size(); }

 private:
  std::deque<SourceText> texts_;
};

/// A span in one source of a set.
struct Place {
  SourceId source{};
  Span span;
  friend constexpr auto operator<=>(Place const&, Place const&) = default;  // NOLINT(modernize-use-nullptr)
};

}  // namespace axisc
