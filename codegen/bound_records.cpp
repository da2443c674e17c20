#include "codegen/bound_records.hpp"

#include "codegen/aligned_bytes.hpp"
#include "runtime/bounds/bound_record.hpp"

#include <array>
#include <bit>
#include <map>
#include <stdexcept>
#include <vector>

namespace axisc::codegen {
namespace {

namespace bounds = runtime::bounds;
namespace stored = runtime::field::filter;

/// Everything that the bounds of a chain depend on; equal sets of sections are stored once.
using ChainIdentity = std::vector<std::uint64_t>;

ChainIdentity identity(runtime::ImageView const& view, bounds::BoundKey const& key) {
  bounds::FilterRange const filters = bounds::filters_of(view, key);
  ChainIdentity identity{key.kernel, bounds::has_kernel_before(view, key.axis) ? 1U : 0U};
  for (std::uint32_t i = 0; i < filters.count; ++i) {
    auto const filter = view.filters[filters.first + i];
    identity.insert(identity.end(),
                    {filter[stored::realisation], filter[stored::blocks_constant],
                     filter[stored::first_section], filter[stored::section_count],
                     filter[stored::delay_cycles], std::bit_cast<std::uint64_t>(filter[stored::share]),
                     std::bit_cast<std::uint64_t>(filter[stored::direct])});
  }
  return identity;
}

void append(bounds::BoundRecord const& bound, SectionTable<records::bound>& table) {
  Record<records::bound> record = table.append();
  record.set(fields::bound::axis, bound.axis);
  record.set(fields::bound::port, bound.port);
  record.set(fields::bound::kernel, bound.kernel);
  record.set(fields::bound::flags, bound.flags);
  record.set(fields::bound::cycles, bound.cycles);
  record.set(fields::bound::stage, bound.stage);
  record.set(fields::bound::gain_low, bound.gain_low);
  record.set(fields::bound::gain_high, bound.gain_high);
  record.set(fields::bound::overshoot_high, bound.overshoot_high);
  record.set(fields::bound::distance_high, bound.distance_high);
  record.set(fields::bound::radius_high, bound.radius_high);
  record.set(fields::bound::rounding_increment, bound.rounding_increment);
  record.set(fields::bound::rounding_position, bound.rounding_position);
  record.set(fields::bound::state_increment, bound.state_increment);
  record.set(fields::bound::state_position, bound.state_position);
  record.set(fields::bound::rest_cycles, bound.rest_cycles);
  record.set(fields::bound::limit_error, bound.limit_error);
}

}  // namespace

void add_bound_records(std::span<std::byte const> image, ImageTables& tables) {
  AlignedBytes const bytes(image);
  runtime::ImageView view;
  if (runtime::open_image(bytes.data(), bytes.size(), view) != AXISRT_OK) {
    throw std::logic_error("the image writer wrote sections that cannot be read");
  }
  std::map<ChainIdentity, bounds::BoundRecord> known;
  bounds::BoundComputation computation(view);
  bounds::BoundKeys keys(view);
  for (bounds::BoundKey key{}; keys.next(key);) {
    auto const [entry, is_new] = known.try_emplace(identity(view, key));
    if (is_new) computation.compute(key, entry->second);
    bounds::set_place(view, key, entry->second);
    append(entry->second, tables.bounds);
  }
}

}  // namespace axisc::codegen
