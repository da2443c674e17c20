#include "analysis/recordings/signal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace axisc::recordings {

namespace {

/// Small, because a value that does not fit into two bytes makes its block large.
constexpr std::size_t block_size = 128;
constexpr double finest = 1e6;
/// Whole numbers up to here, divided by a power of ten, are the doubles that reading their text gives.
constexpr double largest_whole = 1e15;

using Units = std::array<std::int64_t, block_size>;

template <class Offset>
std::vector<Offset> narrowed(Units const& units, std::int64_t base) {
  std::vector<Offset> offsets(block_size);
  for (std::size_t i = 0; i < block_size; ++i) offsets[i] = static_cast<Offset>(units.at(i) - base);
  return offsets;
}

bool has_equal_steps(Units const& units) {
  for (std::size_t i = 2; i < block_size; ++i) {
    if (units[i] - units[i - 1] != units[1] - units[0]) return false;
  }
  return true;
}

bool is_same_with_sign(double a, double b) {
  return a == b && std::signbit(a) == std::signbit(b);
}

}  // namespace

Signal::Signal(std::vector<double> const& values) {
  for (double const value : values) push(value);
}

void Signal::push(double value) {
  if (size_ == 0) front_ = value;
  back_ = value;
  ++size_;
  if (open_.capacity() == 0) open_.reserve(block_size);
  open_.push_back(value);
  if (open_.size() == block_size) close();
}

bool Signal::pack(double per_unit, Block& block) const {
  Units units{};
  for (std::size_t i = 0; i < block_size; ++i) {
    double const value = open_[i];
    double const unit = std::nearbyint(value * per_unit);
    bool const is_exact = std::abs(unit) < largest_whole && unit / per_unit == value;
    if (!is_exact || (unit == 0 && std::signbit(value))) return false;
    units[i] = static_cast<std::int64_t>(unit);
  }
  block.per_unit = per_unit;
  if (has_equal_steps(units)) {
    block.base = units[0];
    block.stored = units[1] - units[0];
    return true;
  }
  auto const [low, high] = std::minmax_element(units.begin(), units.end());
  std::int64_t const base = *low + (*high - *low) / 2;
  auto const reach = std::max(*high - base, base - *low);
  block.base = base;
  if (reach <= std::numeric_limits<std::int16_t>::max()) {
    block.stored = narrowed<std::int16_t>(units, base);
  } else if (reach <= std::numeric_limits<std::int32_t>::max()) {
    block.stored = narrowed<std::int32_t>(units, base);
  } else {
    return false;
  }
  return true;
}

void Signal::close() {
  Block block;
  bool is_packed = pack(per_unit_, block);
  for (double per_unit = 1; !is_packed && per_unit <= finest; per_unit *= 10) {
    is_packed = pack(per_unit, block);
    if (is_packed) per_unit_ = per_unit;
  }
  if (!is_packed) {
    constexpr double largest_float = std::numeric_limits<float>::max();
    bool const is_single = std::all_of(open_.begin(), open_.end(), [](double value) {
      return std::abs(value) <= largest_float && is_same_with_sign(static_cast<float>(value), value);
    });
    if (is_single) {
      std::vector<float> singles(block_size);
      std::transform(open_.begin(), open_.end(), singles.begin(),
                     [](double value) { return static_cast<float>(value); });
      block.stored = std::move(singles);
    } else {
      block.stored = open_;
    }
  }
  blocks_.push_back(std::move(block));
  open_.clear();
}

void Signal::read(std::size_t first, std::span<double> into) const {
  for (std::size_t done = 0; done < into.size();) {
    std::size_t const at = first + done;
    std::size_t const index = at / block_size;
    std::size_t const offset = at % block_size;
    std::size_t const count = std::min(block_size - offset, into.size() - done);
    auto const copy = [&](auto const& stored) {
      using Stored = std::decay_t<decltype(stored)>;
      for (std::size_t i = 0; i < count; ++i) {
        if constexpr (std::is_same_v<Stored, std::int64_t>) {
          auto const steps = static_cast<std::int64_t>(offset + i);
          into[done + i] =
              static_cast<double>(blocks_[index].base + steps * stored) / blocks_[index].per_unit;
        } else if constexpr (std::is_floating_point_v<typename Stored::value_type>) {
          into[done + i] = stored[offset + i];
        } else {
          into[done + i] =
              static_cast<double>(blocks_[index].base + stored[offset + i]) / blocks_[index].per_unit;
        }
      }
    };
    if (index < blocks_.size()) {
      std::visit(copy, blocks_[index].stored);
    } else {
      copy(open_);
    }
    done += count;
  }
}

double Signal::at(std::size_t index) const {
  double value = 0;
  read(index, {&value, 1});
  return value;
}

std::vector<double> Signal::values() const {
  std::vector<double> all(size_);
  read(0, all);
  return all;
}

}  // namespace axisc::recordings
