#include "axisc/answers/identify/force_unit.hpp"

#include <algorithm>
#include <array>

namespace axisc {

namespace {

struct KnownUnit {
  std::string_view name;
  ForceKind kind;
  double factor;
};
constexpr double kilo = 1e3, centi = 1e-2, milli = 1e-3;
constexpr std::array known_units{KnownUnit{"N", ForceKind::newton, 1},
                                 KnownUnit{"kN", ForceKind::newton, kilo},
                                 KnownUnit{"mN", ForceKind::newton, milli},
                                 KnownUnit{"Nm", ForceKind::newton_metre, 1},
                                 KnownUnit{"N m", ForceKind::newton_metre, 1},
                                 KnownUnit{"N·m", ForceKind::newton_metre, 1},
                                 KnownUnit{"kNm", ForceKind::newton_metre, kilo},
                                 KnownUnit{"Ncm", ForceKind::newton_metre, centi},
                                 KnownUnit{"mNm", ForceKind::newton_metre, milli}};

}  // namespace

ForceUnit force_unit_of(std::string_view named) {
  auto const* const found = std::find_if(known_units.begin(), known_units.end(),
                                         [named](KnownUnit const& one) { return one.name == named; });
  if (found == known_units.end()) {
    return {.kind = ForceKind::other, .factor = 1, .symbol = std::string(named)};
  }
  return {
      .kind = found->kind, .factor = found->factor, .symbol = found->kind == ForceKind::newton ? "N" : "Nm"};
}

ModelUnits model_units(ForceUnit const& force, bool is_rotary, std::string_view unknown) {
  std::string const symbol = force.symbol.empty() ? std::string(unknown) : force.symbol;
  std::string const distance = is_rotary ? "rad" : "m";
  bool const is_kilogram = force.kind == ForceKind::newton && !is_rotary;
  bool const is_inertia = force.kind == ForceKind::newton_metre && is_rotary;
  return {.force = symbol,
          .mass = is_kilogram  ? "kg"
                  : is_inertia ? "kg m²"
                               : symbol + "/(" + distance + "/s²)",
          .viscous = symbol + "/(" + distance + "/s)"};
}

}  // namespace axisc
