// The trailer behind an image, and the caller's function that judges it. The seal of these tests is no
// cryptography: what counts here is which bytes are handed over and what becomes of the answer.
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

namespace signature_test {

using namespace axisc::test;

namespace {

constexpr std::size_t trailer_size = 80;
constexpr std::uint64_t key = 0x1122334455667788;

struct Judge {
  std::uint64_t key = signature_test::key;
  unsigned calls = 0;
  std::size_t image_size = 0;
};

std::uint64_t seal(std::uint64_t with, std::uint8_t const* bytes, std::size_t size) {
  return with * 0x9E3779B97F4A7C15 + naive_crc32c(bytes, size);
}

int judge(void* context, std::uint8_t const* key_id, void const* image, std::size_t size,
          std::uint8_t const* signature) {
  auto& judge = *static_cast<Judge*>(context);
  ++judge.calls;
  judge.image_size = size;
  ByteWriter id;
  id.u64(judge.key);
  ByteWriter expected;
  for (int i = 0; i < 8; ++i) expected.u64(seal(judge.key, static_cast<std::uint8_t const*>(image), size));
  bool const right = std::equal(id.bytes.begin(), id.bytes.end(), key_id) &&
                     std::equal(expected.bytes.begin(), expected.bytes.end(), signature);
  return right ? 0 : -1;
}

Bytes with_trailer(Bytes const& image, std::uint32_t version = 1) {
  ByteWriter writer;
  writer.bytes = image;
  writer.text("AXSG");
  writer.u32(version);
  writer.u64(key);
  std::uint64_t const value = seal(key, image.data(), image.size());
  for (int i = 0; i < 8; ++i) writer.u64(value);
  return writer.bytes;
}

/// Creates a runtime; `judge_context` null: no key is set.
axisrt_status create(Bytes const& bytes, Judge* judge_context) {
  AlignedMemory const image(bytes);
  AlignedMemory memory(1 << 16);
  axisrt_config config{};
  config.size = sizeof config;
  config.cycle_time_ns = 1'000'000;
  config.image = image.data();
  config.image_size = image.size();
  config.memory = memory.data();
  config.memory_size = memory.size();
  if (judge_context != nullptr) {
    config.verify_signature = judge;
    config.verify_context = judge_context;
  }
  std::size_t size = 0;
  std::size_t alignment = 0;
  axisrt* runtime = nullptr;
  axisrt_status const planned = axisrt_memory_size(&config, &size, &alignment);
  axisrt_status const created = axisrt_create(&config, &runtime);
  CHECK(planned == created);
  CHECK((runtime != nullptr) == (created == AXISRT_OK));
  return created;
}

Bytes image_bytes() {
  return write_image(channel_image());
}

}  // namespace

TEST_CASE("a right signature is accepted, over exactly the image's bytes") {
  Judge judge;
  Bytes const image = image_bytes();
  CHECK(create(with_trailer(image), &judge) == AXISRT_OK);
  CHECK(judge.calls == 2);
  CHECK(judge.image_size == image.size());
}

TEST_CASE("an image without a signature is refused where a key is set") {
  Judge judge;
  CHECK(create(image_bytes(), &judge) == AXISRT_UNSIGNED);
  CHECK(judge.calls == 0);
}

TEST_CASE("another key is refused") {
  Judge judge;
  judge.key = 1;
  CHECK(create(with_trailer(image_bytes()), &judge) == AXISRT_WRONG_SIGNATURE);
}

TEST_CASE("without a key a trailer is accepted and ignored, whatever it signs") {
  Bytes bytes = with_trailer(image_bytes());
  CHECK(create(bytes, nullptr) == AXISRT_OK);
  bytes.back() ^= 1;
  CHECK(create(bytes, nullptr) == AXISRT_OK);
  CHECK(axisrt_verify(AlignedMemory(bytes).data(), bytes.size()) == AXISRT_OK);
}

TEST_CASE("a signed image that was cut at any length is refused, with a key and without") {
  Bytes const image = image_bytes();
  Bytes const bytes = with_trailer(image);
  REQUIRE(bytes.size() == image.size() + trailer_size);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    INFO(size << " of " << bytes.size() << " bytes");
    Bytes const cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    Judge judge;
    axisrt_status const with_key = create(cut, &judge);
    axisrt_status const without_key = create(cut, nullptr);
    REQUIRE(judge.calls == 0);
    if (size < image.size()) {
      REQUIRE(with_key == AXISRT_TOO_SHORT);
      REQUIRE(without_key == AXISRT_TOO_SHORT);
    } else if (size == image.size()) {
      REQUIRE(with_key == AXISRT_UNSIGNED);
      REQUIRE(without_key == AXISRT_OK);
    } else {
      REQUIRE(with_key == AXISRT_WRONG_SIZE);
      REQUIRE(without_key == AXISRT_WRONG_SIZE);
    }
  }
}

TEST_CASE("every flipped bit of a signed image is refused where a key is set") {
  Bytes bytes = with_trailer(image_bytes());
  bool every_bit = true;
  // All bits of the header and the trailer, one of every seventh byte between them.
  constexpr std::size_t stride = sanitized ? 70 : 7;
  for (std::size_t at = 0; at < bytes.size(); at += every_bit ? 1 : stride) {
    every_bit = at < 128 || at + stride >= bytes.size() - trailer_size;
    for (unsigned bit = every_bit ? 0 : at % 8; bit < (every_bit ? 8 : at % 8 + 1); ++bit) {
      INFO("bit " << bit << " of byte " << at);
      bytes[at] ^= static_cast<std::uint8_t>(1U << bit);
      Judge judge;
      REQUIRE(create(bytes, &judge) != AXISRT_OK);
      bytes[at] ^= static_cast<std::uint8_t>(1U << bit);
    }
  }
}

TEST_CASE("a flipped bit of the content is a wrong signature, not a wrong checksum") {
  Bytes bytes = with_trailer(image_bytes());
  bytes[bytes.size() / 2] ^= 1;
  Judge judge;
  CHECK(create(bytes, &judge) == AXISRT_WRONG_SIGNATURE);
  CHECK(create(bytes, nullptr) == AXISRT_WRONG_CHECKSUM);
}

TEST_CASE("a signed image with right checksums and a wrong content is refused all the same") {
  Bytes image = image_bytes();
  poke_f64(image, section_offset(image, coefficients_kind) + 16, -1);
  repair_checksums(image);
  Judge judge;
  CHECK(create(with_trailer(image), &judge) == AXISRT_UNSTABLE);
}

TEST_CASE("what is no trailer, or one of another version, is refused behind an image") {
  Bytes const image = image_bytes();
  Bytes longer = with_trailer(image);
  longer.push_back(0);
  Bytes zeros = image;
  zeros.resize(image.size() + trailer_size);
  for (bool const with_key : {false, true}) {
    Judge judge;
    Judge* const used = with_key ? &judge : nullptr;
    CHECK(create(longer, used) == AXISRT_WRONG_SIZE);
    CHECK(create(zeros, used) == AXISRT_WRONG_SIZE);
    CHECK(create(with_trailer(image, 2), used) == AXISRT_WRONG_VERSION);
  }
}

}  // namespace signature_test
