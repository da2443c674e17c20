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

/// `text` is what stands between the brackets.
std::optional<std::uint32_t> parse_index(std::string_view text) {
  std::uint32_t index = 0;
  char const* const end = text.data() + text.size();
  auto const [stop, error] = std::from_chars(text.data(), end, index);
  if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc::result_out_of_range ? std::numeric_limits<std::uint32_t>::max() : index;
}

std::optional<NamePart> split_part(std::string_view text) {
  std::size_t const bracket = text.find('[');
  NamePart part{.name = text.substr(0, bracket), .index = std::nullopt};
  if (part.name.empty()) return std::nullopt;
  if (bracket == std::string_view::npos) return part;
  if (text.back() != ']') return std::nullopt;
  part.index = parse_index(text.substr(bracket + 1, text.size() - bracket - 2));
  if (!part.index) return std::nullopt;
  return part;
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
    auto const part = split_part(take_part(name));
    if (!part) return std::nullopt;
    result.parts.push_back(*part);
  }
  return result;
}

std::string bare_name(IndexedName const& name) {
  std::string bare;
  for (NamePart const& part : name.parts) {
    if (!bare.empty()) bare += '.';
    bare += part.name;
  }
  return bare;
}

std::string without_brackets(std::string_view pattern) {
  std::string bare(pattern);
  std::erase_if(bare, [](char byte) { return byte == '[' || byte == ']'; });
  return bare;
}

}  // namespace axisc::schema
