#include "analysis/comparison/settings.hpp"

#include <algorithm>
#include <array>

namespace axisc::comparison {

namespace {

using design::CycleReading;
using design::FilterReading;
using design::GuardReading;
using design::KernelReading;

enum class Key : std::uint8_t { filters, kernels, guard, cycle_time };
constexpr std::array<std::string_view, 4> keys{"filters", "kernels", "vibration_guard", "cycle_time"};
constexpr std::string_view in_force{};

Key key_of(std::string_view id) {
  if (id == documented_kernels || id.starts_with("filter-")) return Key::kernels;
  if (auto const reading = design::reading_of<KernelReading>(design::kernel_reading_words, id)) {
    return design::guard_reading(*reading) == GuardReading::documented ? Key::kernels : Key::guard;
  }
  if (id == documented_cycle_time || id.starts_with("cycle-time-")) return Key::cycle_time;
  return Key::filters;
}

/// The departure that one explanation contains for each key.
using Said = std::array<std::string_view, keys.size()>;

Said said_by(std::vector<Departure> const& departures) {
  Said said{};
  for (auto const& departure : departures) {
    said.at(static_cast<std::size_t>(key_of(departure.id))) = departure.id;
  }
  return said;
}

bool agrees(Comparison const& comparison) {
  return comparison.verdict == Verdict::same || comparison.verdict == Verdict::delayed;
}

std::vector<Said> explanations(Comparison const& comparison) {
  std::vector<Said> all;
  if (agrees(comparison)) all.push_back({});
  for (auto const& one : comparison.fitting) {
    all.push_back(said_by(one.reading.departures));
    for (auto const& other : one.reading.equals) all.push_back(said_by(other));
  }
  return all;
}

/// False where settings cannot express it.
bool set(design::Readings& settings, std::string_view id) {
  if (auto const filters = design::reading_of<FilterReading>(design::filter_reading_words, id)) {
    settings.filters = *filters;
  } else if (auto const kernels = design::reading_of<KernelReading>(design::kernel_reading_words, id)) {
    auto const guard = design::guard_reading(*kernels);
    if (guard == GuardReading::documented) {
      settings.kernels = *kernels;
    } else {
      settings.guard = guard;
    }
  } else if (id == documented_filters) {
    settings.filters = FilterReading::documented;
  } else if (id == documented_kernels) {  // an axis has one kernel
    settings.kernels = KernelReading::documented;
    settings.guard = GuardReading::documented;
  } else if (id == documented_cycle_time) {
    settings.cycle_time = CycleReading::documented;
  } else if (id == cycle_time_double) {
    settings.cycle_time = CycleReading::twice;
  } else if (id == cycle_time_half) {
    settings.cycle_time = CycleReading::half;
  } else if (id == cycle_time_fourfold) {
    settings.cycle_time = CycleReading::fourfold;
  } else if (id == cycle_time_quarter) {
    settings.cycle_time = CycleReading::quarter;
  } else {
    return false;
  }
  return true;
}

void reset(design::Readings& settings, std::size_t key) {
  switch (static_cast<Key>(key)) {
    case Key::filters: settings.filters = FilterReading::documented; break;
    case Key::kernels: settings.kernels = KernelReading::documented; break;
    case Key::guard: settings.guard = GuardReading::documented; break;
    case Key::cycle_time: settings.cycle_time = CycleReading::documented; break;
  }
}

}  // namespace

std::vector<OpenSetting> open_settings(Comparison const& comparison) {
  auto const all = explanations(comparison);
  std::vector<OpenSetting> open;
  for (std::size_t key = 0; key < keys.size(); ++key) {
    OpenSetting one{.key = keys.at(key)};
    for (auto const& said : all) {
      auto const known = std::find(one.possible.begin(), one.possible.end(), said.at(key));
      if (known == one.possible.end()) one.possible.push_back(said.at(key));
    }
    if (one.possible.size() > 1) open.push_back(std::move(one));
  }
  return open;
}

std::optional<DeterminedSettings> settings_of(Comparison const& comparison, design::Readings const& current) {
  DeterminedSettings found{.readings = current, .open = open_settings(comparison)};
  if (agrees(comparison)) return found;
  if (comparison.verdict != Verdict::different || comparison.fitting.empty()) return std::nullopt;
  auto const said = said_by(comparison.fitting.front().reading.departures);
  bool is_determined = false;
  for (std::size_t key = 0; key < keys.size(); ++key) {
    auto const open = std::find_if(found.open.begin(), found.open.end(),
                                   [&](OpenSetting const& one) { return one.key == keys.at(key); });
    if (open != found.open.end()) {
      auto const& possible = open->possible;
      // A value in force that cannot be right is not written again.
      if (std::find(possible.begin(), possible.end(), in_force) == possible.end()) reset(found.readings, key);
    } else if (said.at(key) != in_force) {
      if (!set(found.readings, said.at(key))) return std::nullopt;
      is_determined = true;
    }
  }
  return is_determined ? std::optional(std::move(found)) : std::nullopt;
}

}  // namespace axisc::comparison
