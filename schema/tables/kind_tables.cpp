#include "schema/tables/kind_tables.hpp"

#include "schema/indexed_name.hpp"
#include "schema/name_matching.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace axisc::schema {
namespace {

struct Beginning {
  std::string_view text;
  ListKind kind{};
};

#include "kind_tables.inc"

static_assert(std::size(kind_table) == list_kinds);

class KindTables final : public OwnTables {
 public:
  explicit KindTables(ListKind kind) : kind_(kind), rows_(kind_table[static_cast<std::size_t>(kind)]) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      auto const id = static_cast<ParameterId>(i);
      by_bare_name_.emplace(without_brackets(rows_[i].name), id);
      by_number_[rows_[i].p_axis].push_back(id);
      plain_.push_back(plain_values_of(rows_[i]));
      for (Symbol const& symbol : rows_[i].symbols) words_.insert(symbol.word);
    }
  }

  [[nodiscard]] ListKind kind() const override { return kind_; }
  [[nodiscard]] std::span<ParameterRow const> own_rows() const override { return {}; }
  [[nodiscard]] std::span<Parameter const> parameters() const override { return rows_; }
  [[nodiscard]] std::size_t slot_count() const override {
    return static_cast<std::size_t>(rows_.back().first_slot) + rows_.back().slots;
  }

  [[nodiscard]] NameLookup find_as_written(std::string_view text) const override {
    auto const named = by_bare_name_.find(bare_name(text));
    auto const name = split_name(text);
    if (named == by_bare_name_.end() || !name) return {};
    return match_name(*name, std::span(&named->second, 1), rows_).lookup;
  }

  [[nodiscard]] PlainParameter find_plain(std::string_view name) const override {
    NameLookup const lookup = find_as_written(name);
    bool const is_exact =
        lookup.status == NameLookup::Status::found && slot_name(*lookup.row, lookup.slot) == name;
    if (!is_exact) return {};
    return {.values = &plain_[static_cast<std::size_t>(lookup.parameter)], .slot = lookup.slot};
  }

  [[nodiscard]] std::span<ParameterId const> find_number(std::uint16_t number) const override {
    auto const found = by_number_.find(number);
    return found == by_number_.end() ? std::span<ParameterId const>{} : found->second;
  }

  /// Limits that others give are looked at where both are in one list.
  [[nodiscard]] std::span<Slot const> slots_limited_by_others() const override { return {}; }

  [[nodiscard]] ParameterId parameter_of(Slot slot) const override {
    auto const after =
        std::upper_bound(rows_.begin(), rows_.end(), slot,
                         [](Slot wanted, Parameter const& row) { return wanted < row.first_slot; });
    return static_cast<ParameterId>(after - rows_.begin() - 1);
  }

  [[nodiscard]] bool knows_word(std::string_view word) const override { return words_.contains(word); }

  [[nodiscard]] Vocabulary vocabulary() const override {
    std::call_once(taken_apart_, [this] {
      std::vector<std::string> names;
      names.reserve(rows_.size());
      for (Parameter const& row : rows_) names.emplace_back(row.name);
      vocabulary_ = std::make_unique<VocabularyTables>(names);
    });
    return vocabulary_->view(rows_);
  }

  [[nodiscard]] std::string_view file_of(std::string_view /*name*/) const override { return {}; }

 private:
  ListKind kind_;
  std::span<Parameter const> rows_;
  std::map<std::string, ParameterId, std::less<>> by_bare_name_;  ///< no two rows share one
  std::map<std::uint16_t, std::vector<ParameterId>> by_number_;
  std::vector<PlainValues> plain_;  ///< of each row
  std::set<std::string_view> words_;
  mutable std::once_flag taken_apart_;
  mutable std::unique_ptr<VocabularyTables> vocabulary_;  ///< made when the first name is mistyped
};

}  // namespace

std::shared_ptr<OwnTables const> kind_tables(ListKind kind) {
  static std::array<std::once_flag, list_kinds> made;
  static std::array<std::shared_ptr<OwnTables const>, list_kinds> tables;
  auto const number = static_cast<std::size_t>(kind);
  std::call_once(made.at(number), [kind, number] { tables.at(number) = std::make_shared<KindTables>(kind); });
  return tables.at(number);
}

std::optional<ListKind> kind_named_by(std::string_view name) {
  std::string_view const text = name.substr(0, name.find_first_of(".["));
  auto const* const found =
      std::lower_bound(std::begin(beginning_table), std::end(beginning_table), text,
                       [](Beginning const& each, std::string_view wanted) { return each.text < wanted; });
  if (found == std::end(beginning_table) || found->text != text) return std::nullopt;
  return found->kind;
}

}  // namespace axisc::schema
