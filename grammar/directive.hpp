// Comments that speak to this program.
#pragma once

#include "diagnostics/span.hpp"

#include <cstdint>
#include <string_view>

namespace axisc::grammar {

/// The text that every such comment contains.
inline constexpr std::string_view directive_introducer = "axisc:";

/// A comment that may carry `axisc: allow CODE[,CODE]`: only those that contain "axisc:" are kept. Lines with
/// a problem may have one too; comments after the `Ende` of a list are not read.
struct Directive {
  Span comment;
  bool whole_line = false;  ///< the line holds nothing else, so it applies to the next line
  std::uint32_t line = 0;

  friend bool operator==(Directive const&, Directive const&) = default;
};

}  // namespace axisc::grammar
