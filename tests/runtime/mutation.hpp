// Images with one fault each, whose checksums are right again.
#pragma once

#include "axisrt.h"
#include "runtime/aligned_memory.hpp"
#include "runtime/image_builder.hpp"
#include "support/catch.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace axisc::test {

inline axisrt_status verify(Bytes const& bytes) {
  AlignedMemory const image(bytes);
  return axisrt_verify(image.data(), image.size());
}

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline std::size_t record_offset(Bytes const& bytes, std::uint32_t kind, std::size_t record) {
  auto const stride = static_cast<std::size_t>(peek(bytes, entry_offset(bytes, kind) + 24, 4));
  return section_offset(bytes, kind) + record * stride;
}

/// One change of an image whose checksums are right again, and the status that answers it.
struct Mutation {
  std::string name;
  std::function<void(Bytes&)> apply;
  axisrt_status expected;
};

inline Mutation header_u32(std::string name, std::size_t offset, std::uint32_t value,
                           axisrt_status expected) {
  return {std::move(name), [=](Bytes& b) { poke(b, offset, value, 4); }, expected};
}

/// Offsets are those of docs/image-format.md, from the record's beginning.
inline Mutation entry(std::string name, std::uint32_t kind, std::size_t offset, std::uint64_t value, int size,
                      axisrt_status expected) {
  return {std::move(name), [=](Bytes& b) { poke(b, entry_offset(b, kind) + offset, value, size); }, expected};
}
inline Mutation u32(std::string name, std::uint32_t kind, std::size_t record, std::size_t offset,
                    std::uint32_t value, axisrt_status expected) {
  return {std::move(name), [=](Bytes& b) { poke(b, record_offset(b, kind, record) + offset, value, 4); },
          expected};
}
inline Mutation f64(std::string name, std::uint32_t kind, std::size_t record, std::size_t offset,
                    double value, axisrt_status expected) {
  return {std::move(name), [=](Bytes& b) { poke_f64(b, record_offset(b, kind, record) + offset, value); },
          expected};
}

inline void check_mutations(ImageRecord const& image, std::vector<Mutation> const& mutations) {
  for (Mutation const& mutation : mutations) {
    Bytes bytes = write_image(image);
    mutation.apply(bytes);
    repair_checksums(bytes);
    INFO(mutation.name << ": " << axisrt_status_name(mutation.expected));
    CHECK(std::string(axisrt_status_name(verify(bytes))) == axisrt_status_name(mutation.expected));
  }
}

}  // namespace axisc::test
