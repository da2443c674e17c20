#include "analysis/comparison/signal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axisc::comparison {

namespace {

/// Small, because a value that does not fit into two bytes makes its block large.
constexpr std::size_t block_size = 128;
constexpr double finest = 1e6;
/// Whole numbers up to here, divided by a power of ten, are the doubles that reading their text gives.
constexpr double largest_exact = 1e15;

template <class Offset>
std::vector<Offset> narrowed(std::vector<std::int64_t> const& units, std::int64_t base) {
  std::vector<Offset> offsets;
  offsets.reserve(units.size());
  for (auto const unit : units) offsets.push_back(static_cast<Offset>(unit - base));
  return offsets;
}

}  // namespace

Signal::Signal(std::vector<double> const& values) {
  for (double const value : values) push(value);
}

void Signal::push(double value) {
  if (size_ == 0) front_ = value;
  back_ = value;
  ++size_;
  open_.push_back(value);
  if (open_.size() == block_size) close();
}

bool Signal::pack(double per_unit, Block& block) const {
  std::vector<std::int64_t> units;
  units.reserve(open_.size());
  for (double const value : open_) {
    double const unit = std::nearbyint(value * per_unit);
    bool const is_exact = std::abs(unit) < largest_exact && unit / per_unit == value;
    if (!is_exact || (unit == 0 && std::signbit(value))) return false;
    units.push_back(static_cast<std::int64_t>(unit));
  }
  auto const [low, high] = std::minmax_element(units.begin(), units.end());
  std::int64_t const base = *low + (*high - *low) / 2;
  auto const reach = std::max(*high - base, base - *low);
  block.base = base;
  block.per_unit = per_unit;
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
  if (!is_packed) block.stored = open_;
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
      for (std::size_t i = 0; i < count; ++i) {
        if constexpr (std::is_same_v<std::decay_t<decltype(stored)>, std::vector<double>>) {
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

std::vector<double> Signal::values() const {
  std::vector<double> all(size_);
  read(0, all);
  return all;
}

}  // namespace axisc::comparison
