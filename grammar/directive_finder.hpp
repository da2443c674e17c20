// Finds the comments that speak to this program. Hardly any line has one, so the text is searched for the
// rare colon of "axisc:" and not line by line.
#pragma once

#include "diagnostics/span.hpp"
#include "grammar/directive.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace axisc::grammar {

class DirectiveFinder {
 public:
  explicit DirectiveFinder(std::string_view bytes) : bytes_(bytes) { advance(0); }

  /// Where "axisc:" stands next at or behind `from`, which grows from one question to the next; npos if nowhere.
  [[nodiscard]] std::size_t next(std::size_t from) {
    if (next_ < from) advance(from);
    return next_;
  }

  /// True if "axisc:" stands inside `comment`. Comments are asked for in the order of the text; all questions
  /// together cost one search through it.
  [[nodiscard]] bool within(Span comment) {
    std::size_t const begin = next(comment.begin);
    return begin != std::string_view::npos && begin + directive_introducer.size() <= comment.end;
  }

 private:
  void advance(std::size_t from) {
    std::size_t colon = from;
    while ((colon = bytes_.find(':', colon)) != std::string_view::npos) {
      ++colon;
      if (colon >= from + directive_introducer.size() &&
          bytes_.substr(0, colon).ends_with(directive_introducer)) {
        next_ = colon - directive_introducer.size();
        return;
      }
    }
    next_ = std::string_view::npos;
  }

  std::string_view bytes_;
  std::size_t next_ = 0;
};

}  // namespace axisc::grammar
