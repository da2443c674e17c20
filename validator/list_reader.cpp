#include "validator/judgement.hpp"
#include "validator/reading.hpp"
#include "validator/short_number.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::validator {
namespace {

/// See Readings::doubtful(). A character has a byte at least.
bool is_doubtful(grammar::Assignment const& assignment, Reading const& reading) {
  if (!reading.usable() || reading.name_folded || reading.symbol_folded || !reading.trouble.empty() ||
      assignment.trailer_kind == grammar::TrailerKind::text) {
    return true;
  }
  if (reading.status == ReadingStatus::reference) return false;
  std::size_t const most = reading.row->max_length;
  return is_outside(*reading.row, reading.value.number) || (most != 0 && reading.value.text.size() > most);
}

/// The number of an assignment as nearly all of them are: a few digits, where the parameter is a number of that kind. False for
/// every other one.
bool read_short_number(std::string_view bytes, grammar::Assignment const& assignment,
                       schema::Parameter const& parameter, double& number) {
  using grammar::ValueKind;
  bool const is_real = parameter.type == schema::DataType::real64;
  if (!schema::is_number(parameter.type) || parameter.is_enumeration() ||
      assignment.value.end < room_before_number_end) {
    return false;
  }
  char const* const begin = bytes.data() + assignment.value.begin;
  char const* const end = bytes.data() + assignment.value.end;
  if (assignment.kind == ValueKind::integer) return read_short_integer(begin, end, number);
  return assignment.kind == ValueKind::real && is_real && read_short_real(begin, end, number);
}

/// Exact for short numbers.
bool fits(schema::Parameter const& parameter, double number) {
  DataRange const range = data_range(parameter.type);
  return (range.lowest <= number) & (number <= range.highest);
}

}  // namespace

class ListReader {
 public:
  ListReader(SourceText const& source, grammar::AxisList const& list, schema::Catalogue const& catalogue)
      : source_(source), list_(list), catalogue_(catalogue), seen_(catalogue.slot_count()) {
    result_.readings_.reserve(list.assignments.size());
  }

  Readings read() && {
    std::array<std::string_view, schema::names_at_once> names;
    std::array<schema::ConcreteParameter, schema::names_at_once> parameters;
    std::span<grammar::Assignment const> rest = list_.assignments;
    while (!rest.empty()) {
      std::size_t const count = std::min(rest.size(), names.size());
      for (std::size_t i = 0; i < count; ++i) {
        names[i] = {source_.bytes().data() + rest[i].name.begin, rest[i].name.size()};
      }
      catalogue_.find_exact(std::span(names).first(count), parameters);
      for (std::size_t i = 0; i < count; ++i) read(rest[i], parameters[i]);
      rest = rest.subspan(count);
    }
    result_.has_repetitions_ = repetitions_ != 0;
    return std::move(result_);
  }

 private:
  /// `exact` has no row where the name is no parameter's as it stands.
  void read(grammar::Assignment const& assignment, schema::ConcreteParameter exact) {
    auto const number = static_cast<std::uint32_t>(result_.readings_.size());
    Reading& reading = result_.readings_.emplace_back();
    reading.text = assignment.value;
    if (exact) {
      reading.row = exact.row;
      reading.slot = exact.slot;
      reading.name_status = schema::NameLookup::Status::found;
      if (judge_short_number(assignment, reading)) return note_slot(exact.slot);
    } else {
      look_up(assignment, reading);
    }
    validator::judge(source_, assignment, reading, result_.transcoded_);
    if (!reading.row_known()) suggest(number);
    if (reading.usable()) note_slot(reading.slot);
    if (is_doubtful(assignment, reading)) result_.doubtful_.push_back(number);
  }

  /// False for what is judged otherwise: everything but a short number that is beyond doubt.
  bool judge_short_number(grammar::Assignment const& assignment, Reading& reading) const {
    schema::Parameter const& parameter = *reading.row;
    double number = 0;
    if (!read_short_number(source_.bytes(), assignment, parameter, number) || !fits(parameter, number) ||
        is_outside(parameter, number) || assignment.trailer_kind == grammar::TrailerKind::text) {
      return false;
    }
    reading.value.number = number;
    reading.status = ReadingStatus::value;
    return true;
  }

  void look_up(grammar::Assignment const& assignment, Reading& reading) {
    schema::NameLookup const lookup = catalogue_.find(source_.slice(assignment.name));
    reading.row = lookup.row;
    reading.slot = lookup.slot;
    reading.name_status = lookup.status;
    reading.name_folded = lookup.case_folded;
  }

  void note_slot(schema::Slot slot) {
    std::uint8_t& seen = seen_[static_cast<std::size_t>(slot)];
    repetitions_ |= seen;
    seen = 1;
  }

  void suggest(std::uint32_t number) {
    constexpr std::size_t most_suggestions = 1000;
    if (++unknown_names_ > most_suggestions) return;
    std::vector<std::string> names = catalogue_.suggest_names(source_.slice(list_.assignments[number].name));
    if (!names.empty()) result_.suggested_.push_back({.assignment = number, .names = std::move(names)});
  }

  SourceText const& source_;
  grammar::AxisList const& list_;
  schema::Catalogue const& catalogue_;
  Readings result_;
  std::vector<std::uint8_t> seen_;  ///< 1 for each slot that a line gives a value
  std::uint8_t repetitions_ = 0;    ///< the same for a slot that several lines give one
  std::size_t unknown_names_ = 0;
};

std::span<std::string const> Readings::suggestions(std::size_t assignment) const {
  auto const found = std::lower_bound(
      suggested_.begin(), suggested_.end(), assignment,
      [](Suggested const& suggested, std::size_t wanted) { return suggested.assignment < wanted; });
  if (found == suggested_.end() || found->assignment != assignment) return {};
  return found->names;
}

Readings read_assignments(SourceText const& source, grammar::AxisList const& list,
                          schema::Catalogue const& catalogue) {
  return ListReader(source, list, catalogue).read();
}

}  // namespace axisc::validator
