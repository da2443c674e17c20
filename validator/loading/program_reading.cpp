#include "validator/loading/program_reading.hpp"

#include "diagnostics/utf8.hpp"
#include "grammar/axis_list.hpp"
#include "grammar/program_excerpt.hpp"
#include "schema/motion_words.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

namespace axisc::validator {
namespace {

/// Words that say how a path is driven have rules of their own.
bool drives_path(int function) {
  return schema::find_motion_word(function) != nullptr;
}

/// Cuts pieces of any size into lines.
class LineAssembler {
 public:
  /// Calls `found` with each line without its line end; false when one is too long.
  template <typename Found>
  bool add(std::string_view piece, Found found) {
    for (std::size_t end = piece.find('\n'); end != std::string_view::npos; end = piece.find('\n')) {
      std::string_view line = piece.substr(0, end);
      if (!begun_.empty()) line = begun_.append(line);
      if (!say(line, found)) return false;
      begun_.clear();
      piece.remove_prefix(end + 1);
    }
    begun_ += piece;
    return begun_.size() <= grammar::longest_line + 1;
  }

  template <typename Found>
  bool finish(Found found) {
    return begun_.empty() || say(begun_, found);
  }

 private:
  template <typename Found>
  static bool say(std::string_view line, Found found) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.size() > grammar::longest_line) return false;
    found(line);
    return true;
  }

  std::string begun_;  ///< the line that the next piece continues
};

class MarkedContent {
 public:
  void add(std::string_view piece) { mark_.bytes += piece.size(); }
  void add_line(std::string_view line) {
    constexpr std::uint64_t odd = 0x9E3779B97F4A7C15ULL;
    mark_.hash = (mark_.hash ^ std::hash<std::string_view>{}(line)) * odd;
  }
  [[nodiscard]] ContentMark const& mark() const { return mark_; }

 private:
  ContentMark mark_;
};

class ProgramReading {
 public:
  explicit ProgramReading(ProgramText kept) : kept_(kept) {}

  bool piece(std::string_view bytes) {
    content_.add(bytes);
    if (kept_ == ProgramText::whole) whole_ += bytes;
    if (content_.mark().bytes > configuration::largest_file) {
      return refuse(configuration::FileError::too_large);
    }
    if (beginning_is_judged_) return lines(bytes);
    beginning_ += bytes;
    return beginning_.size() < configuration::judged_beginning || judge_beginning();
  }

  std::variant<ReadProgram, configuration::FileError> finish(std::string const& name) {
    if (!problem_ && !beginning_is_judged_) judge_beginning();
    if (!problem_ && !lines_.finish([this](std::string_view line) { add_line(line); })) {
      problem_ = configuration::FileError::line_too_long;
    }
    if (problem_) return *problem_;
    if (kept_ == ProgramText::whole) {
      SourceText text(name, std::move(whole_));
      auto tree = grammar::parse_nc_program(text.bytes(), text.text_begin(), drives_path);
      return ReadProgram{.text = std::move(text), .tree = std::move(tree), .mark = content_.mark()};
    }
    reader_.finish();
    Excerpt excerpt{.bytes = std::move(reader_.bytes()), .numbers = std::move(reader_.numbers())};
    if (!is_utf8_) excerpt.encoding = Encoding::windows_1252;
    if (is_utf8_ && has_mark_) excerpt.encoding = Encoding::utf8_with_mark;
    return ReadProgram{.text = SourceText(name, std::move(excerpt)),
                       .tree = std::move(reader_.program()),
                       .mark = content_.mark()};
  }

 private:
  bool refuse(configuration::FileError error) {
    problem_ = error;
    return false;
  }

  bool judge_beginning() {
    beginning_is_judged_ = true;
    std::string const beginning = std::exchange(beginning_, {});
    if (auto const error = configuration::check_beginning(beginning)) return refuse(*error);
    return lines(beginning);
  }

  bool lines(std::string_view bytes) {
    return lines_.add(bytes, [this](std::string_view line) { add_line(line); }) ||
           refuse(configuration::FileError::line_too_long);
  }

  void add_line(std::string_view line) {
    content_.add_line(line);
    // No character crosses a line end, so each line can be checked on its own.
    is_utf8_ = is_utf8_ && valid_utf8_prefix(line) == line.size();
    if (reader_.program().lines == 0 && line.starts_with(byte_order_mark)) {
      has_mark_ = true;
      line.remove_prefix(byte_order_mark.size());
    }
    reader_.line(line);
  }

  ProgramText kept_;
  std::string whole_;
  MarkedContent content_;
  std::string beginning_;
  bool beginning_is_judged_ = false;
  LineAssembler lines_;
  bool is_utf8_ = true;
  bool has_mark_ = false;
  grammar::ProgramExcerptReader reader_{drives_path};
  std::optional<configuration::FileError> problem_;
};

}  // namespace

std::variant<ReadProgram, configuration::FileError> read_program(configuration::Files& files,
                                                                 std::string const& path, ProgramText kept) {
  ProgramReading reading(kept);
  auto const error = files.read_pieces(path, [&](std::string_view piece) { return reading.piece(piece); });
  if (error) return *error;
  return reading.finish(path);
}

void read_program_again(configuration::Files& files, std::string const& path, ContentMark const& mark,
                        configuration::PieceReceiver const& receive) {
  MarkedContent content;
  LineAssembler lines;
  auto const add_line = [&](std::string_view line) { content.add_line(line); };
  auto const error = files.read_pieces(path, [&](std::string_view piece) {
    content.add(piece);
    return lines.add(piece, add_line) && receive(piece);
  });
  bool const is_same = !error && lines.finish(add_line) && content.mark() == mark;
  if (!is_same) throw configuration::SourceChanged(path);
}

}  // namespace axisc::validator
