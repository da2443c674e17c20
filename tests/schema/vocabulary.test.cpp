#include "schema/vocabulary.hpp"

#include "schema/name_candidates.hpp"
#include "support/catch.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace {

using namespace axisc::schema;

// Letters are compared in blocks, and the last names may leave one half empty.
TEST_CASE("a slip in any name of a vocabulary of any size is found") {
  for (std::size_t const count : {0U, 1U, 15U, 16U, 17U, 33U}) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) {
      names.push_back("family.quantity_" + std::string(1 + i / 3, static_cast<char>('a' + i % 3)));
    }
    VocabularyTables const tables(names);
    Vocabulary const vocabulary = tables.view({});
    for (std::size_t i = 0; i < count; ++i) {
      std::string mistyped = names[i];
      mistyped[3] = 'x';
      std::vector<std::size_t> found;
      for_each_of_like_letters(vocabulary, mistyped, 1, [&](std::size_t name) { found.push_back(name); });
      INFO(i << " of " << count);
      CHECK_THAT(found, Catch::Matchers::VectorContains(i));
    }
    bool any = false;
    for_each_of_like_letters(vocabulary, "0123456789", 3, [&any](std::size_t) { any = true; });
    CHECK_FALSE(any);
  }
}

}  // namespace
