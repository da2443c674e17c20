// A batch of fixes that do not touch one another.
#pragma once

#include "diagnostics/finding.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

struct EditedSource {
  SourceId source{};
  std::string bytes;  ///< of the whole file; parts that no edit replaces are unchanged, columns included
};

/// The encoding of the source has all characters of a text in UTF-8.
[[nodiscard]] bool can_be_written(SourceText const& source, std::string_view text);

class FixBatch {
 public:
  /// `sources` and the fixes must live as long as the batch.
  explicit FixBatch(SourceSet const& sources) : sources_(sources) {}

  /// Returns false and changes nothing if an edit overlaps or touches one of the batch, needs a character
  /// that the encoding of its source lacks, would end the CDATA section that holds the list, or if only an
  /// excerpt of its source is available.
  bool add(Fix const& fix);

  /// The changed files, in their encoding and with their line ends; windows of one file follow one another in
  /// the set, in the order of the file. Text after at least two blanks keeps its column if possible: the
  /// blanks compensate for a longer or shorter text before them.
  [[nodiscard]] std::vector<EditedSource> apply() const;

 private:
  [[nodiscard]] bool fits(Edit const& edit) const;

  SourceSet const& sources_;
  std::map<Place, std::string_view> edits_;
};

}  // namespace axisc
