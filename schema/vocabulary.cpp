#include "schema/vocabulary.hpp"

#include "schema/indexed_name.hpp"

#include <functional>
#include <map>

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
  Vocabulary vocabulary{.rows = rows,
                        .parts = {},
                        .names = {},
                        .parts_of = {},
                        .last_parts = {},
                        .names_with = {},
                        .names_of_size = {}};
  std::map<std::string, std::size_t, std::less<>> places;
  for (Parameter const& parameter : rows) {
    std::string bare(parameter.name);
    std::erase_if(bare, [](char byte) { return byte == '[' || byte == ']'; });
    vocabulary.names.add(bare);
    std::vector<std::size_t>& parts = vocabulary.parts_of.emplace_back();
    for (std::string_view rest = bare; !rest.empty();) {
      std::string_view const part = take_part(rest);
      auto const [place, is_new] = places.try_emplace(std::string(part), vocabulary.parts.size());
      if (is_new) vocabulary.parts.add(part);
      parts.push_back(place->second);
    }
    std::size_t const number = vocabulary.names.size() - 1;
    vocabulary.names_with.resize(vocabulary.parts.size());
    std::vector<std::size_t>& with_part = vocabulary.names_with[parts.back()];
    if (with_part.empty()) vocabulary.last_parts.push_back(parts.back());
    with_part.push_back(number);
    if (vocabulary.names_of_size.size() <= bare.size()) vocabulary.names_of_size.resize(bare.size() + 1);
    vocabulary.names_of_size[bare.size()].push_back(number);
  }
  return vocabulary;
}

}  // namespace axisc::schema
