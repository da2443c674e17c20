// Images with the section `bounds`, and the records of those without.
#pragma once

#include "runtime/aligned_memory.hpp"
#include "runtime/bounds/bound_record.hpp"
#include "runtime/image_builder.hpp"
#include "support/catch.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace axisc::test {

inline constexpr std::uint32_t bounds_kind = 20;
inline constexpr std::uint32_t bound_size = 128;

inline std::vector<runtime::bounds::BoundRecord> bounds_of(Bytes const& image) {
  AlignedMemory const memory(image);
  runtime::ImageView view;
  REQUIRE(runtime::open_image(memory.data(), memory.size(), view) == AXISRT_OK);
  runtime::bounds::BoundKeys keys(view);
  runtime::bounds::BoundComputation computation(view);
  std::vector<runtime::bounds::BoundRecord> records;
  for (runtime::bounds::BoundKey key{}; keys.next(key);) {
    computation.compute(key, records.emplace_back());
  }
  return records;
}

/// The records in the order of docs/image-format.md.
inline Bytes content_of(std::vector<runtime::bounds::BoundRecord> const& records) {
  ByteWriter writer;
  for (auto const& record : records) {
    for (std::uint32_t const number :
         {record.axis, record.port, record.kernel, record.flags, record.cycles, record.stage}) {
      writer.u32(number);
    }
    for (double const number : {record.gain_low, record.gain_high, record.overshoot_high,
                                record.distance_high, record.radius_high, record.rounding_increment,
                                record.rounding_position, record.state_increment, record.state_position}) {
      writer.f64(number);
    }
    writer.u64(record.rest_cycles);
    writer.f64(record.limit_error);
    writer.zeros(16);
  }
  return writer.bytes;
}

/// The section `bounds`.
inline ForeignSection section_of(std::vector<runtime::bounds::BoundRecord> const& records) {
  return {.kind = bounds_kind, .flags = 1, .content = content_of(records), .element_size = bound_size};
}

/// The image with its own bounds.
inline Bytes with_bounds(ImageRecord image) {
  image.foreign = section_of(bounds_of(write_image(image)));
  return write_image(image);
}

/// An image of one axis with these filters.
inline ImageRecord image_of(std::vector<FilterRecord> filters) {
  ImageRecord image;
  image.axes.emplace_back();
  for (std::uint32_t i = 0; i < filters.size(); ++i) filters[i].index = i;
  image.axes[0].filters = std::move(filters);
  return image;
}

inline runtime::bounds::BoundRecord bound_of(std::vector<FilterRecord> filters) {
  return bounds_of(write_image(image_of(std::move(filters)))).at(0);
}

}  // namespace axisc::test
