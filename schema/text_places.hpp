// The index of a text in a list of texts, found by its hash.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace axisc::schema {

/// A hash table with linear probing, which can also be made at run time: if the place of its hash is taken, a
/// text has the next free one. Each entry is a place in the list + 1, or 0; there are at least twice as many
/// as texts, and a power of two.
using TextPlaces = std::span<std::uint32_t const>;

/// `texts` are distinct.
[[nodiscard]] std::vector<std::uint32_t> make_text_places(std::span<std::string_view const> texts);

/// None where `text` is not in the list. Cost: one hash and, nearly always, one comparison.
[[nodiscard]] std::optional<std::size_t> find_text(std::string_view text,
                                                   std::span<std::string_view const> texts,
                                                   TextPlaces places);

}  // namespace axisc::schema
