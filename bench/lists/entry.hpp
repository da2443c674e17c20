// What every reader of the comparison makes of one parameter: found in the catalogue, converted, compared
// with its range.
#pragma once

#include "schema/catalogue.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace axisc::bench {

enum class Verdict : std::uint8_t { good, unknown, wrong_type, out_of_range, duplicate };

struct CheckedEntry {
  double number = 0;
  std::uint32_t position = 0;  ///< in the text, where the reader knows it
  schema::Slot slot{};
  Verdict verdict = Verdict::good;
};

/// The entries of one file, and which parameters have been set.
class EntryTable {
 public:
  EntryTable() : seen_(schema::slot_count(), 0) {}

  void clear() {
    entries_.clear();
    ++file_;
  }
  /// Looks the name up and notes a repetition; null for a name that nobody knows.
  schema::Parameter const* open(std::string_view name, std::uint32_t position);
  /// The value of the entry that was opened last.
  void number(schema::Parameter const& parameter, double value);
  void truth(schema::Parameter const& parameter, bool value);
  void word(schema::Parameter const& parameter, std::string_view word);
  void wrong_type() { entries_.back().verdict = Verdict::wrong_type; }

  [[nodiscard]] std::vector<CheckedEntry> const& entries() const { return entries_; }

 private:
  std::vector<CheckedEntry> entries_;
  std::vector<std::uint32_t> seen_;  ///< the file that set a slot last
  std::uint32_t file_ = 1;
};

}  // namespace axisc::bench
