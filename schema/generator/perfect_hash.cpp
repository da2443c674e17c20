#include "schema/generator/perfect_hash.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace axisc::schema::generator {
namespace {

constexpr std::uint32_t largest_displacement = 65535;

/// The places of all names of one bucket, if they are free and distinct.
std::optional<std::vector<std::uint32_t>> places_for(std::vector<std::uint64_t> const& hashes,
                                                     std::uint32_t displacement, PerfectHash const& table,
                                                     std::vector<bool> const& is_taken) {
  std::vector<std::uint32_t> places;
  for (std::uint64_t const hash : hashes) {
    std::uint32_t const place = place_of(hash, displacement, table.geometry);
    bool const is_free = !is_taken[place] && std::find(places.begin(), places.end(), place) == places.end();
    if (!is_free) return std::nullopt;
    places.push_back(place);
  }
  return places;
}

}  // namespace

PerfectHash make_perfect_hash(std::vector<std::string> const& names) {
  auto const count = static_cast<std::uint32_t>(names.size());
  PerfectHash table;
  // Three names to a bucket and at most two thirds of the places taken: small tables, and the search ends at
  // once.
  table.geometry = {.buckets = std::bit_ceil(count / 3 + 1), .places = std::bit_ceil(count + count / 2)};
  table.displacements.resize(table.geometry.buckets);
  table.entries.resize(table.geometry.places);
  std::vector<bool> is_taken(table.geometry.places);

  std::vector<std::vector<std::size_t>> buckets(table.geometry.buckets);
  for (std::size_t i = 0; i < names.size(); ++i) {
    buckets[bucket_of(hash_name(names[i]), table.geometry)].push_back(i);
  }
  std::vector<std::size_t> order(buckets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return buckets[a].size() > buckets[b].size(); });

  for (std::size_t const bucket : order) {
    std::vector<std::uint64_t> hashes;
    for (std::size_t const name : buckets[bucket]) hashes.push_back(hash_name(names[name]));
    std::optional<std::vector<std::uint32_t>> places;
    std::uint32_t displacement = 0;
    while (!(places = places_for(hashes, displacement, table, is_taken))) {
      if (++displacement > largest_displacement) throw std::runtime_error("no perfect hash found");
    }
    table.displacements[bucket] = static_cast<std::uint16_t>(displacement);
    for (std::size_t i = 0; i < hashes.size(); ++i) {
      table.entries[(*places)[i]] = static_cast<std::uint16_t>(buckets[bucket][i]);
      is_taken[(*places)[i]] = true;
    }
  }
  return table;
}

}  // namespace axisc::schema::generator
