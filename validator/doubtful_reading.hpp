// Which readings a check of single lines may object to.
#pragma once

#include "validator/reading.hpp"

namespace axisc::validator {

[[nodiscard]] inline bool may_violate(schema::Limit const& limit, double value, double sign) {
  if (limit.kind != schema::Limit::Kind::number) return false;
  return limit.open ? sign * value <= sign * limit.number : sign * value < sign * limit.number;
}

/// Also where the value is allowed nevertheless, as the default is.
[[nodiscard]] inline bool may_be_out_of_range(schema::Parameter const& parameter, Value const& value) {
  return may_violate(parameter.minimum, value.number, 1) || may_violate(parameter.maximum, value.number, -1);
}

/// A character has a byte at least.
[[nodiscard]] inline bool may_be_too_long(schema::Parameter const& parameter, Value const& value) {
  return parameter.max_length != 0 && value.text.size() > parameter.max_length;
}

/// See Readings::doubtful().
[[nodiscard]] inline bool is_doubtful(grammar::Assignment const& assignment, Reading const& reading) {
  if (!reading.usable() || reading.name_folded || reading.symbol_folded || !reading.trouble.empty() ||
      assignment.trailer_kind == grammar::TrailerKind::text) {
    return true;
  }
  if (reading.status == ReadingStatus::reference) return false;
  return may_be_out_of_range(*reading.row, reading.value) || may_be_too_long(*reading.row, reading.value);
}

}  // namespace axisc::validator
