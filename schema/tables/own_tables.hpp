// The look-ups of a catalogue other than the built-in one of axis parameters.
#pragma once

#include "schema/parameter_row.hpp"
#include "schema/plain_values.hpp"
#include "schema/vocabulary.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace axisc::schema {

/// Each function answers like the one of that name in Catalogue.
class OwnTables {
 public:
  OwnTables() = default;
  OwnTables(OwnTables const&) = delete;
  OwnTables& operator=(OwnTables const&) = delete;
  virtual ~OwnTables() = default;

  [[nodiscard]] virtual ListKind kind() const = 0;
  /// The rows of schema files.
  [[nodiscard]] virtual std::span<ParameterRow const> own_rows() const = 0;
  [[nodiscard]] virtual std::span<Parameter const> parameters() const = 0;
  [[nodiscard]] virtual std::size_t slot_count() const = 0;
  [[nodiscard]] virtual NameLookup find_as_written(std::string_view text) const = 0;
  /// The parameter of a name exactly as the catalogue spells it; the name may have any form.
  [[nodiscard]] virtual PlainParameter find_plain(std::string_view name) const = 0;
  [[nodiscard]] virtual std::span<ParameterId const> find_number(std::uint16_t number) const = 0;
  [[nodiscard]] virtual std::span<Slot const> slots_limited_by_others() const = 0;
  [[nodiscard]] virtual ParameterId parameter_of(Slot slot) const = 0;
  [[nodiscard]] virtual bool knows_word(std::string_view word) const = 0;
  [[nodiscard]] virtual Vocabulary vocabulary() const = 0;
  /// The file of a row; empty for one that was built in.
  [[nodiscard]] virtual std::string_view file_of(std::string_view name) const = 0;
};

}  // namespace axisc::schema
