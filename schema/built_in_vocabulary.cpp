#include "schema/vocabulary.hpp"

namespace axisc::schema {
namespace {

#include "vocabulary_tables.inc"

}  // namespace

Vocabulary const& built_in_vocabulary() {
  static Vocabulary const vocabulary{
      .rows = parameters(),
      .names = names,
      .names_of_size = {.starts = names_of_size_starts, .numbers = names_of_size_numbers},
      .letters_by_size = letters_by_size,
      .odd_letters_by_size = odd_letters_by_size,
      .parts = parts,
      .places_of_parts = places_of_parts,
      .parts_of = {.starts = parts_of_starts, .numbers = parts_of_numbers},
      .names_ending_in = {.starts = names_ending_in_starts, .numbers = names_ending_in_numbers},
      .families = families,
      .places_of_families = places_of_families,
      .names_of_family = {.starts = names_of_family_starts, .numbers = names_of_family_numbers},
      .letters_by_family = letters_by_family};
  return vocabulary;
}

}  // namespace axisc::schema
