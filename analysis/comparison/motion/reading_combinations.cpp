#include "analysis/comparison/motion/reading_combinations.hpp"

#include "configuration/machine/motion_words.hpp"

namespace axisc::comparison {

std::array<MotionKeyWords, motion_key_count> motion_key_words() {
  std::array<MotionKeyWords, motion_key_count> all;
  std::size_t count = 0;
  machine::for_each_reading({}, [&](std::string_view key, auto const& words, std::size_t /*number*/) {
    all.at(count++) = {.key = key, .words = words};
  });
  return all;
}

Combination combination_of(machine::MotionReadings const& readings) {
  Combination numbers{};
  std::size_t count = 0;
  machine::for_each_reading(readings, [&](std::string_view, auto const&, std::size_t number) {
    numbers.at(count++) = static_cast<std::uint8_t>(number);
  });
  return numbers;
}

machine::MotionReadings readings_of(Combination const& combination) {
  auto const number = [&](MotionKey key) { return combination.at(index_of(key)); };
  return {.projection = static_cast<machine::ProjectionReading>(number(MotionKey::projection)),
          .borders = static_cast<machine::BorderReading>(number(MotionKey::borders)),
          .sine = static_cast<machine::SineReading>(number(MotionKey::sine)),
          .circle = static_cast<machine::CircleReading>(number(MotionKey::circle)),
          .corner = static_cast<machine::CornerReading>(number(MotionKey::corner)),
          .weights = static_cast<machine::TransitionReading>(number(MotionKey::weights)),
          .cycles = static_cast<machine::CycleReading>(number(MotionKey::cycles)),
          .hsc = static_cast<machine::HscReading>(number(MotionKey::hsc))};
}

std::vector<Combination> all_combinations() {
  std::vector<Combination> all{Combination{}};
  auto const keys = motion_key_words();
  for (std::size_t key = 0; key < keys.size(); ++key) {
    auto const before = all.size();
    for (std::size_t word = 1; word < keys.at(key).words.size(); ++word) {
      for (std::size_t i = 0; i < before; ++i) {
        all.push_back(all[i]);
        all.back().at(key) = static_cast<std::uint8_t>(word);
      }
    }
  }
  return all;
}

Combination only(Combination combination, MotionKeys const& keys) {
  for (std::size_t key = 0; key < combination.size(); ++key) {
    if (!keys.test(key)) combination.at(key) = 0;
  }
  return combination;
}

}  // namespace axisc::comparison
