#include "validator/views/gantry.hpp"

#include <algorithm>
#include <utility>

namespace axisc::validator {
namespace {

constexpr std::uint32_t master_bit = 0x10000;
constexpr std::uint32_t slave_bit = 0x20000;

template <typename Matches>
GantryClaim const* find_claim(LoadedMachine const& machine, Matches matches) {
  auto const claim = std::find_if(machine.gantry_claims.begin(), machine.gantry_claims.end(), matches);
  return claim == machine.gantry_claims.end() ? nullptr : &*claim;
}

std::uint32_t bits_of(EffectiveValue const& mode) {
  return mode.unusable ? 0 : static_cast<std::uint32_t>(mode.value.number);
}

}  // namespace

GantryView::GantryView(EffectiveValues const& values)
    : mode(values.at("kenngr.achs_mode")), master_number(values.at("kenngr.gantry_ax_nr")) {}

bool GantryView::open() const {
  if (!mode.set() || mode.unusable) return true;
  auto const standard = schema::default_value(*mode.row);
  return standard && standard->number == mode.value.number;
}

bool GantryView::is_master() const {
  return (bits_of(mode) & master_bit) != 0;
}

bool GantryView::is_slave() const {
  return (bits_of(mode) & slave_bit) != 0;
}

std::optional<std::uint32_t> GantryView::named_master() const {
  if (master_number.unusable || !(master_number.value.number > 0)) return std::nullopt;
  return static_cast<std::uint32_t>(master_number.value.number);
}

GantryClaim const* slave_claim(LoadedMachine const& machine, std::size_t axis) {
  return find_claim(machine, [axis](GantryClaim const& claim) { return claim.axis == axis && claim.master; });
}

GantryClaim const* master_claim(LoadedMachine const& machine, std::size_t axis) {
  return find_claim(machine,
                    [axis](GantryClaim const& claim) { return claim.axis == axis && !claim.master; });
}

std::optional<std::size_t> master_of(LoadedMachine const& machine, std::size_t axis) {
  GantryView const view(machine.axes[axis].merged.values);
  GantryClaim const* const claim = slave_claim(machine, axis);
  bool const slave = view.is_slave() || (view.open() && claim != nullptr);
  if (!slave) return std::nullopt;
  std::optional<std::size_t> master;
  if (auto const number = view.named_master()) {
    master = axis_numbered(machine, *number);
  } else if (claim != nullptr) {
    master = claim->master;
  }
  return master == axis ? std::nullopt : master;
}

std::vector<LoadedGantry> gantries_of(LoadedMachine const& machine) {
  std::vector<LoadedGantry> gantries;
  for (std::size_t axis = 0; axis < machine.axes.size(); ++axis) {
    std::optional<std::size_t> const master = master_of(machine, axis);
    if (!master) continue;
    auto gantry = std::find_if(gantries.begin(), gantries.end(),
                               [&](LoadedGantry const& known) { return known.master == *master; });
    if (gantry == gantries.end()) gantry = gantries.insert(gantry, {.master = *master, .slaves = {}});
    gantry->slaves.push_back(axis);
  }
  std::sort(gantries.begin(), gantries.end(),
            [](LoadedGantry const& a, LoadedGantry const& b) { return a.master < b.master; });
  return gantries;
}

}  // namespace axisc::validator
