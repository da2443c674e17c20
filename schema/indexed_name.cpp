#include "schema/indexed_name.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace axisc::schema {
namespace {

/// Cuts `[12]` off the beginning of a name; none where there is no number in brackets.
std::optional<std::uint32_t> take_index(std::string_view& name) {
  std::uint32_t index = 0;
  char const* const end = name.data() + name.size();
  auto const [stop, error] = std::from_chars(name.data() + 1, end, index);
  if (error == std::errc::invalid_argument || stop == end || *stop != ']') return std::nullopt;
  name.remove_prefix(static_cast<std::size_t>(stop + 1 - name.data()));
  return error == std::errc::result_out_of_range ? std::numeric_limits<std::uint32_t>::max() : index;
}

}  // namespace

std::string_view take_part(std::string_view& name) {
  std::size_t const dot = std::min(name.find('.'), name.size());
  std::string_view const part = name.substr(0, dot);
  name.remove_prefix(std::min(dot + 1, name.size()));
  return part;
}

std::optional<IndexedName> split_name(std::string_view name) {
  IndexedName result;
  constexpr std::size_t usual_parts = 4;
  result.parts.reserve(usual_parts);
  while (!name.empty()) {
    auto const* const end =
        std::find_if(name.begin(), name.end(), [](char byte) { return byte == '.' || byte == '['; });
    NamePart part{.name = name.substr(0, static_cast<std::size_t>(end - name.begin())),
                  .index = std::nullopt};
    if (part.name.empty()) return std::nullopt;
    name.remove_prefix(part.name.size());
    if (name.starts_with('[')) {
      part.index = take_index(name);
      if (!part.index) return std::nullopt;
    }
    if (!name.empty() && name.front() != '.') return std::nullopt;
    name.remove_prefix(std::min<std::size_t>(name.size(), 1));
    result.parts.push_back(part);
  }
  return result;
}

std::string bare_name(std::string_view name) {
  if (name.ends_with('.')) name.remove_suffix(1);
  std::string bare;
  bare.reserve(name.size());
  while (true) {
    std::size_t const bracket = name.find('[');
    bare += name.substr(0, bracket);
    std::size_t const end = bracket == std::string_view::npos ? bracket : name.find(']', bracket);
    if (end == std::string_view::npos) return bare;
    name.remove_prefix(end + 1);
  }
}

std::string without_brackets(std::string_view pattern) {
  std::string bare(pattern);
  std::erase_if(bare, [](char byte) { return byte == '[' || byte == ']'; });
  return bare;
}

}  // namespace axisc::schema
