// A parameter name taken apart: `filter[2].order` is the parts filter with index 2, and order.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::schema {

struct NamePart {
  std::string_view name;
  std::optional<std::uint32_t> index;  ///< an index that does not fit is the largest number
};

struct IndexedName {
  std::vector<NamePart> parts;
};

/// Parts of `name`, as views into it; none when it is not identifiers joined by dots with one index each at
/// most.
[[nodiscard]] std::optional<IndexedName> split_name(std::string_view name);

/// A name without indices, also without the dot after its last part that split_name() lets pass:
/// `filter.order`.
[[nodiscard]] std::string bare_name(std::string_view name);

/// A pattern without brackets: `filter[].order` is `filter.order`.
[[nodiscard]] std::string without_brackets(std::string_view pattern);

/// Cuts the first part off a dotted name and returns it.
std::string_view take_part(std::string_view& name);

}  // namespace axisc::schema
