// What kind of list a file is. Nearly all lists of a controller are called *.lis; names and comments tell
// them apart.
#pragma once

#include "diagnostics/source_text.hpp"
#include "schema/list_kind.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::configuration {

using schema::list_kinds;
using schema::ListKind;

/// The beginning of its parameters' numbers: "P-CHAN".
[[nodiscard]] std::string number_prefix(ListKind kind);

/// The kind of list whose parameters a comment numbers, by the first number in it: channel for `(
/// P-CHAN-00035`.
[[nodiscard]] std::optional<ListKind> kind_numbered_in(std::string_view comment);

/// Each line votes for the kind that it belongs to: a list may contain a few names of another kind.
class KindVote {
 public:
  /// A name that the catalogue of axis parameters knows.
  void known(std::string_view name);
  /// Any other name, with the rest of its line.
  void unknown(std::string_view name, std::string_view comment);

  /// No line has voted for another kind than axis lists.
  [[nodiscard]] bool is_undisputed() const { return foreign_ == 0; }
  /// No line has voted at all.
  [[nodiscard]] bool is_open() const;
  /// The kind with the most votes; an axis list where no other has more votes than that.
  [[nodiscard]] ListKind winner() const;

 private:
  std::array<std::size_t, list_kinds> votes_{};
  std::size_t foreign_ = 0;
  std::size_t heads_ = 0;  ///< `kopf.*`: also in compensation lists
};

/// The kind of a list by all of its lines; none where nothing decides. Cost: one pass by the grammar.
[[nodiscard]] std::optional<ListKind> decided_kind(SourceText const& list);

}  // namespace axisc::configuration
