#include "validator/reading.hpp"

#include <cstddef>

namespace axisc::validator {
namespace {

using schema::Limit;

bool violates_limit(Limit const& limit, double value, double sign) {
  if (limit.kind != Limit::Kind::number) return false;
  return limit.open ? sign * value <= sign * limit.number : sign * value < sign * limit.number;
}

/// Also where the value is allowed nevertheless, as the default is.
bool may_be_out_of_range(schema::Parameter const& parameter, Value const& value) {
  return violates_limit(parameter.minimum, value.number, 1) ||
         violates_limit(parameter.maximum, value.number, -1);
}

/// A character has a byte at least.
bool may_be_too_long(schema::Parameter const& parameter, Value const& value) {
  return parameter.max_length != 0 && value.text.size() > parameter.max_length;
}

bool is_doubtful(grammar::Assignment const& assignment, Reading const& reading) {
  if (!reading.usable() || reading.name.case_folded || reading.symbol_folded || !reading.trouble.empty() ||
      assignment.trailer_kind == grammar::TrailerKind::text) {
    return true;
  }
  if (reading.status == ReadingStatus::reference) return false;
  schema::Parameter const& parameter = *reading.name.row;
  return may_be_out_of_range(parameter, reading.value) || may_be_too_long(parameter, reading.value);
}

}  // namespace

std::vector<std::uint32_t> doubtful_readings(grammar::AxisList const& list,
                                             std::vector<Reading> const& readings) {
  std::vector<std::uint32_t> doubtful;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (is_doubtful(list.assignments[i], readings[i])) doubtful.push_back(static_cast<std::uint32_t>(i));
  }
  return doubtful;
}

}  // namespace axisc::validator
