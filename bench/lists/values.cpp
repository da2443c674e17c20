#include "lists/values.hpp"

#include "schema/value.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <string_view>

namespace axisc::bench {
namespace {

using schema::DataType;
using schema::Limit;
using schema::Parameter;

constexpr double largest_integer = 2e6;
constexpr double largest_real = 1e4;
constexpr unsigned hexadecimal_percent = 12;

/// What parameters of other families look at.
constexpr std::array<std::string_view, 6> tied = {
    "filter", "vib_guard", "lr_param.add_interface", "lr_param.improved", "kopf.", "kenngr."};

bool is_limit_of_another(Parameter const& parameter) {
  static std::set<std::uint16_t> const limits = [] {
    std::set<std::uint16_t> numbers;
    for (Parameter const& row : schema::parameters()) {
      for (Limit const& limit : {row.minimum, row.maximum}) {
        if (limit.kind == Limit::Kind::parameter) numbers.insert(limit.p_axis);
      }
    }
    return numbers;
  }();
  return parameter.p_axis != 0 && limits.contains(parameter.p_axis);
}

/// Two limits drawn inwards, so that a real with few digits stays inside.
double between(Parameter const& parameter, double largest, double lowest, Random& random) {
  bool const is_integer = schema::is_integer(parameter.type);
  schema::DataRange const all = schema::data_range(parameter.type);
  double low = parameter.minimum.kind == Limit::Kind::number ? parameter.minimum.number : lowest;
  double high =
      parameter.maximum.kind == Limit::Kind::number ? parameter.maximum.number : std::max(largest, low + 10);
  if (is_integer) low = std::max(low + (parameter.minimum.open ? 1 : 0), all.lowest);
  if (is_integer) high = std::min(high - (parameter.maximum.open ? 1 : 0), all.highest);
  double const top = std::min(high, std::max(largest, low + 10));
  double const bottom = std::max(low, std::min(-largest, top - 10));
  return bottom + (top - bottom) * (0.01 + 0.98 * random.fraction());
}

template <class... Values>
std::string printed(char const* format, Values... values) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, values...);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  return text.data();
}

std::string integer(Parameter const& parameter, Random& random) {
  double const value =
      std::nearbyint(between(parameter, random.chance(50) ? 100.0 : largest_integer, 0, random));
  bool const is_unsigned = parameter.type >= DataType::uns08 && parameter.type <= DataType::uns64;
  auto const whole = static_cast<long long>(is_unsigned ? std::max(value, 0.0) : value);
  if (is_unsigned && whole > 15 && random.chance(hexadecimal_percent)) return printed("0x%llX", whole);
  return printed("%lld", whole);
}

std::string real(Parameter const& parameter, Random& random) {
  double const value = between(parameter, largest_real, 0, random);
  if (random.chance(25)) return printed("%.6e", value);
  std::string text = printed("%.3f", value);
  while (text.back() == '0' && text[text.size() - 2] != '.') text.pop_back();
  return text;
}

std::string boolean(Random& random) {
  constexpr std::array<std::string_view, 6> words = {"0", "1", "0", "1", "TRUE", "FALSE"};
  return std::string(words[random.below(words.size())]);
}

std::string text(Parameter const& parameter, Random& random) {
  constexpr std::array<std::string_view, 8> words = {"X_Achse", "S_0_0047", "ISTWERT",  "Antrieb",
                                                     "Geber_1", "P_0_0434", "Referenz", "NC"};
  std::string word(words[random.below(words.size())]);
  if (parameter.max_length != 0) word = word.substr(0, parameter.max_length);
  return word;
}

}  // namespace

bool is_free(Parameter const& parameter) {
  bool const is_tied = std::any_of(tied.begin(), tied.end(), [&](std::string_view prefix) {
    return parameter.name.substr(0, prefix.size()) == prefix;
  });
  bool const is_limited =
      parameter.minimum.kind == Limit::Kind::parameter || parameter.maximum.kind == Limit::Kind::parameter;
  return !is_tied && !is_limited && !is_limit_of_another(parameter) && parameter.axis_types.empty();
}

Entry random_entry(Parameter const& parameter, schema::Slot slot, Random& random) {
  Entry entry{.name = schema::slot_name(parameter, slot), .value = {}, .kind = EntryKind::integer};
  if (parameter.type == DataType::boolean) {
    entry.kind = EntryKind::boolean;
    entry.value = boolean(random);
  } else if (parameter.is_enumeration()) {
    entry.kind = EntryKind::text;
    entry.value = std::string(parameter.symbols[random.below(parameter.symbols.size())].word);
  } else if (parameter.type == DataType::string) {
    entry.kind = EntryKind::text;
    entry.value = text(parameter, random);
  } else if (parameter.type == DataType::real64) {
    entry.kind = EntryKind::real;
    entry.value = real(parameter, random);
  } else {
    entry.value = integer(parameter, random);
  }
  return entry;
}

}  // namespace axisc::bench
