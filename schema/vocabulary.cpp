#include "schema/vocabulary.hpp"

#include "schema/indexed_name.hpp"

#include <functional>
#include <map>
#include <utility>

namespace axisc::schema {

Letters letters_of(std::string_view text) {
  constexpr unsigned letters = 32;
  Letters once = 0;
  Letters twice = 0;
  for (char const byte : text) {
    Letters const letter = Letters{1} << (static_cast<unsigned char>(byte) % letters);
    twice |= once & letter;
    once |= letter;
  }
  return once | twice << letters;
}

Vocabulary take_apart(std::span<Parameter const> rows) {
  Vocabulary vocabulary{.rows = rows, .parts = {}, .names = {}};
  std::map<std::string, std::size_t, std::less<>> places;
  for (Parameter const& parameter : rows) {
    std::string bare(parameter.name);
    std::erase_if(bare, [](char byte) { return byte == '[' || byte == ']'; });
    KnownName name{.bare = Word(bare), .parts = {}};
    for (std::string_view rest = bare; !rest.empty();) {
      std::string_view const part = take_part(rest);
      auto const [place, is_new] = places.try_emplace(std::string(part), vocabulary.parts.size());
      if (is_new) vocabulary.parts.emplace_back(part);
      name.parts.push_back(place->second);
      name.last_part = place->second;
    }
    vocabulary.names.push_back(std::move(name));
  }
  return vocabulary;
}

}  // namespace axisc::schema
