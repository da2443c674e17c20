#include "validator/views/uncomputed.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace axisc::validator {
namespace {

machine::UncomputedParameter parameter_at(Place place, std::string number, SourceSet const& sources) {
  SourceText const& source = sources[place.source];
  std::string_view const bytes = source.bytes();
  std::size_t const break_before =
      place.span.begin == 0 ? std::string_view::npos : bytes.find_last_of("\r\n", place.span.begin - 1);
  std::size_t const begin = break_before == std::string_view::npos ? 0 : break_before + 1;
  std::size_t const end = std::min(bytes.find_first_of("\r\n", place.span.end), bytes.size());
  Span const line{.begin = static_cast<std::uint32_t>(begin), .end = static_cast<std::uint32_t>(end)};
  return {.number = std::move(number),
          .name = source.utf8(place.span),
          .file = source.name(),
          .line = source.position(place.span.begin).line,
          .line_text = source.utf8(line)};
}

}  // namespace

std::vector<machine::UncomputedParameter> uncomputed_parameters(EffectiveValues const& values,
                                                                SourceSet const& sources) {
  constexpr std::array<std::string_view, 5> patterns = {
      "dynamic_weighting.enable", "getriebe[].beschl_kennlinie.typ", "getriebe[].slope_profil.j_accel",
      "getriebe[].slope_profil.j_decel", "getriebe[].slope_profil.j_ptp"};
  std::vector<machine::UncomputedParameter> found;
  for (std::string_view const pattern : patterns) {
    EffectiveValue const& value = values.at(pattern);
    auto const place = value.name_place();
    if (!place || value.unusable || value.value.number == 0) continue;
    found.push_back(parameter_at(*place, parameter_number(value), sources));
  }
  return found;
}

std::vector<machine::UncomputedParameter> uncomputed_parameters(LoadedGroup const& group,
                                                                SourceSet const& sources) {
  std::vector<machine::UncomputedParameter> found;
  for (configuration::UncomputedValue const& value : group.uncomputed) {
    found.push_back(parameter_at(value.name_place, std::string(value.number), sources));
  }
  return found;
}

}  // namespace axisc::validator
