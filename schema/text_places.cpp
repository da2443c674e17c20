#include "schema/text_places.hpp"

#include "schema/name_hash.hpp"
#include "schema/words.hpp"

#include <bit>

namespace axisc::schema {
namespace {

std::size_t next(std::size_t place, std::size_t size) {
  return (place + 1) & (size - 1);
}

std::size_t first(std::string_view text, std::size_t size) {
  return static_cast<std::size_t>(hash_name(text)) & (size - 1);
}

}  // namespace

std::vector<std::uint32_t> make_text_places(std::span<std::string_view const> texts) {
  std::vector<std::uint32_t> places(std::bit_ceil(2 * texts.size() + 1));
  for (std::size_t i = 0; i < texts.size(); ++i) {
    std::size_t place = first(texts[i], places.size());
    while (places[place] != 0) place = next(place, places.size());
    places[place] = static_cast<std::uint32_t>(i + 1);
  }
  return places;
}

std::optional<std::size_t> find_text(std::string_view text, std::span<std::string_view const> texts,
                                     TextPlaces places) {
  for (std::size_t place = first(text, places.size()); places[place] != 0;
       place = next(place, places.size())) {
    std::size_t const found = places[place] - 1;
    if (same_bytes(texts[found], text)) return found;
  }
  return std::nullopt;
}

}  // namespace axisc::schema
