// The lines that a fix would change, before and after.
#pragma once

#include "diagnostics/finding.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace axisc {

struct PreviewLine {
  std::uint32_t number = 1;  ///< of a removed line in the source, of an added line after the fix
  bool added = false;
  std::string text;  ///< UTF-8, whole
  std::size_t first_change =
      0;  ///< code point at which it begins to differ from the line it replaces or is replaced by
};

/// Lines that neighbouring edits change together.
struct PreviewBlock {
  SourceId source{};
  Position begin;  ///< of the first edit
  std::vector<PreviewLine>
      lines;  ///< the removed ones, then the added ones; unchanged neighbours are left out
};

/// Blocks in the order of the sources and lines. Edits must not overlap.
[[nodiscard]] std::vector<PreviewBlock> preview(Fix const& fix, SourceSet const& sources);

}  // namespace axisc
