#include "axisc/answers/execution/recorded_units.hpp"

#include "analysis/comparison/residual.hpp"
#include "axisc/environment/failure.hpp"
#include "configuration/machine/machine.hpp"

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

namespace axisc::says {

constexpr Sentence no_increments{
    "the image does not hold the values of the lists, so the length of an increment is not known; give the "
    "lists instead, or --unit 0.1um, um or mm",
    "das Abbild enthält die Werte der Listen nicht, daher ist die Länge eines Inkrements nicht bekannt; "
    "stattdessen die Listen angeben, oder --unit 0.1um, um oder mm"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// As the lists set it last; none where they do not, or where it is no number.
std::optional<std::int64_t> whole_number(image::ImageAxis const& axis, std::string_view name) {
  auto const found = std::find_if(axis.values.rbegin(), axis.values.rend(),
                                  [name](image::ImageValue const& value) { return value.name == name; });
  if (found == axis.values.rend()) return std::nullopt;
  std::string_view digits = found->value;
  bool const is_hexadecimal = digits.starts_with("0x") || digits.starts_with("0X");
  if (is_hexadecimal) digits.remove_prefix(2);
  std::int64_t number = 0;
  auto const [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), number, is_hexadecimal ? 16 : 10);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return number;
}

/// Of the gear step that is active after the start.
std::optional<std::int64_t> of_gear(image::ImageAxis const& axis, std::string_view name) {
  auto const step = std::max<std::int64_t>(whole_number(axis, "kenngr.getriebe_stufe").value_or(1), 1);
  return whole_number(axis, "getriebe[" + std::to_string(step - 1) + "]." + std::string(name));
}

double increment(image::ImageAxis const& axis) {
  if (axis.name.empty()) throw Failure({says::no_increments});
  auto const path = of_gear(axis, "wegaufn").value_or(1);
  auto const increments = of_gear(axis, "wegaufz").value_or(1);
  if (path < 1 || increments < 1) return thousandths_per_tenth;
  return thousandths_per_tenth * static_cast<double>(path) / static_cast<double>(increments);
}

}  // namespace

bool is_whole(recordings::Signal const& signal, std::vector<std::size_t> const& gaps) {
  return comparison::resolution(signal, gaps) == 1;
}

double thousandths_of(RecordedUnit unit, image::ImageAxis const& axis, bool is_whole) {
  constexpr double per_mm = 1000;
  switch (unit) {
    case RecordedUnit::tenths: return thousandths_per_tenth;
    case RecordedUnit::um: return 1;
    case RecordedUnit::mm: return per_mm;
    case RecordedUnit::increments: return increment(axis);
    case RecordedUnit::recognised: break;
  }
  return is_whole ? thousandths_per_tenth : per_mm;
}

std::optional<double> modulo_range(image::ImageAxis const& axis) {
  constexpr std::int64_t modulo_axis = 0x4;  // P-AXIS-00015
  constexpr std::int64_t full_turn = 3'600'000;
  bool const is_translatory = axis.type == static_cast<std::uint32_t>(machine::AxisType::translatory);
  bool const is_modulo = (whole_number(axis, "kenngr.achs_mode").value_or(0) & modulo_axis) != 0;
  if (is_translatory && !is_modulo) return std::nullopt;
  auto const range = of_gear(axis, "moduloo").value_or(full_turn) - of_gear(axis, "modulou").value_or(0);
  return thousandths_per_tenth * static_cast<double>(range > 0 ? range : full_turn);
}

}  // namespace axisc
