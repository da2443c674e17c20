#include "schema/closest_word.hpp"

#include "diagnostics/ascii.hpp"
#include "schema/edit_distance.hpp"

#include <cstddef>
#include <string>

namespace axisc::schema {

std::string_view closest_word(std::string_view written, std::span<std::string_view const> words) {
  std::string const folded = ascii::lower_case(written);
  std::string_view best;
  std::size_t most = tolerable_distance(written.size());
  for (std::string_view const word : words) {
    std::size_t const distance = edit_distance(folded, ascii::lower_case(word), most);
    if (distance > most || distance >= word.size()) continue;
    best = word;
    if (distance == 0) break;
    most = distance - 1;
  }
  return best;
}

}  // namespace axisc::schema
