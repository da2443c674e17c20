#include "lists/entry.hpp"

#include "schema/value.hpp"

namespace axisc::bench {
namespace {

using schema::DataType;
using schema::Limit;

bool violates(Limit const& limit, double value, bool is_minimum) {
  if (limit.kind != Limit::Kind::number) return false;
  if (limit.open && value == limit.number) return true;
  return is_minimum ? value < limit.number : value > limit.number;
}

}  // namespace

schema::Parameter const* EntryTable::open(std::string_view name, std::uint32_t position) {
  schema::NameLookup const lookup = schema::find(name);
  CheckedEntry& entry = entries_.emplace_back();
  entry.position = position;
  if (lookup.status != schema::NameLookup::Status::found) {
    entry.verdict = Verdict::unknown;
    return nullptr;
  }
  entry.slot = lookup.slot;
  std::uint32_t& seen = seen_[static_cast<std::size_t>(lookup.slot)];
  if (seen == file_) entry.verdict = Verdict::duplicate;
  seen = file_;
  return lookup.row;
}

void EntryTable::number(schema::Parameter const& parameter, double value) {
  CheckedEntry& entry = entries_.back();
  entry.number = value;
  if (parameter.type == DataType::boolean) {
    if (value != 0 && value != 1) wrong_type();
    return;
  }
  if (parameter.is_enumeration()) {
    if (schema::symbol_of_number(parameter, value) == nullptr) wrong_type();
    return;
  }
  if (parameter.type == DataType::string) return wrong_type();
  bool const outside = violates(parameter.minimum, value, true) || violates(parameter.maximum, value, false);
  if (!outside) return;
  auto const standard = schema::default_value(parameter);
  if (!standard || standard->number != value) entry.verdict = Verdict::out_of_range;
}

void EntryTable::truth(schema::Parameter const& parameter, bool value) {
  if (parameter.type != DataType::boolean) return wrong_type();
  entries_.back().number = value ? 1 : 0;
}

void EntryTable::word(schema::Parameter const& parameter, std::string_view word) {
  if (!parameter.symbols.empty()) {
    schema::Symbol const* const symbol = schema::read_symbol(parameter, word).symbol;
    if (symbol == nullptr) return wrong_type();
    entries_.back().number = symbol->number.value_or(0);
  } else if (parameter.type != DataType::string) {
    wrong_type();
  }
}

}  // namespace axisc::bench
