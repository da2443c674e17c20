// Fixes that are written together because they do not touch one another.
#pragma once

#include "diagnostics/finding.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

struct EditedSource {
  SourceId source{};
  std::string bytes;  ///< of the whole source; what no edit replaces is as it was, columns included
};

class FixBatch {
 public:
  /// `sources` and the fixes must live as long as the batch.
  explicit FixBatch(SourceSet const& sources) : sources_(sources) {}

  /// False, and nothing happens, where an edit overlaps or touches one of the batch, needs a character that the
  /// encoding of its source lacks, or where only an excerpt of its source is there.
  bool add(Fix const& fix);

  /// The sources as they become, in the encoding and with the line ends they have. What stands behind at least two
  /// blanks keeps its column where the blanks allow it: they make up for a longer or shorter text before them.
  [[nodiscard]] std::vector<EditedSource> apply() const;

 private:
  [[nodiscard]] bool fits(Edit const& edit) const;

  SourceSet const& sources_;
  std::map<Place, std::string_view> edits_;
};

}  // namespace axisc
