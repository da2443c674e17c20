// The catalogue with the rows of schema files: its own tables, made once when such files are read. Names of
// the built-in tables are still found there.
#pragma once

#include "schema/tables/own_tables.hpp"

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::schema {

class Extension final : public OwnTables {
 public:
  /// The built-in catalogue with `rows`: one of a name that is there already replaces it and keeps its slots,
  /// unless its array sizes differ.
  explicit Extension(std::vector<ParameterRow> rows);

  [[nodiscard]] ListKind kind() const override { return ListKind::axis; }
  [[nodiscard]] std::span<ParameterRow const> own_rows() const override { return own_; }
  [[nodiscard]] std::span<Parameter const> parameters() const override { return rows_; }
  [[nodiscard]] std::size_t slot_count() const override;
  [[nodiscard]] NameLookup find_as_written(std::string_view text) const override;
  [[nodiscard]] PlainParameter find_plain(std::string_view name) const override;
  [[nodiscard]] std::span<ParameterId const> find_number(std::uint16_t p_axis) const override;
  [[nodiscard]] std::span<Slot const> slots_limited_by_others() const override { return limited_; }
  [[nodiscard]] ParameterId parameter_of(Slot slot) const override;
  [[nodiscard]] bool knows_word(std::string_view word) const override { return words_.contains(word); }
  [[nodiscard]] Vocabulary vocabulary() const override;
  [[nodiscard]] std::string_view file_of(std::string_view name) const override;

 private:
  void add(ParameterRow const& row);

  std::vector<ParameterRow> own_;
  std::deque<std::vector<Symbol>> symbols_;  ///< the rows' spans refer to these
  std::vector<Parameter> rows_;
  std::vector<PlainValues> plain_;  ///< of each row
  std::vector<Slot> limited_;
  std::map<std::string, std::vector<ParameterId>, std::less<>> own_by_bare_name_;
  std::set<ParameterId> own_ids_;
  std::map<std::uint16_t, std::vector<ParameterId>> by_number_;
  std::vector<ParameterId> own_slots_;  ///< of the slots after the built-in ones
  std::set<std::string, std::less<>> words_;
  mutable std::once_flag taken_apart_;
  mutable std::unique_ptr<VocabularyTables> vocabulary_;  ///< made when the first name is mistyped
};

}  // namespace axisc::schema
