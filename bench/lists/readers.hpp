// The readers that are compared. Each takes one text and fills the table with what it finds there.
#pragma once

#include "lists/entry.hpp"

#include <memory>
#include <string>
#include <string_view>

namespace axisc::bench {

/// The scanner by hand that tests compare the grammar with, and a plain look at every value.
void read_by_hand(std::string_view list, EntryTable& table);

/// `ini` sections with inih, which gives no positions.
void read_with_inih(std::string const& ini, EntryTable& table);

/// JSON as a document of nlohmann-json.
void read_with_nlohmann(std::string const& json, EntryTable& table);

/// JSON with simdjson, whose parsers keep their memory.
class Simdjson {
 public:
  Simdjson();
  Simdjson(Simdjson const&) = delete;
  Simdjson& operator=(Simdjson const&) = delete;
  ~Simdjson();

  void read_document(std::string const& json, EntryTable& table);
  void read_on_demand(std::string const& json, EntryTable& table);

 private:
  struct Parsers;
  std::unique_ptr<Parsers> parsers_;
};

}  // namespace axisc::bench
