// Ed25519 behind an image, judged by the runtime.
#include "image/signature.hpp"

#include "codegen/image_writer.hpp"
#include "support/catch.hpp"
#include "tests/codegen/machines.hpp"

#include <sodium/crypto_sign.h>

using namespace axisc;
using namespace axisc::codegen;
using axisc::test::sample_machine;

namespace {

std::vector<std::byte> image_bytes() {
  return write_image(sample_machine(), {.strip = true});
}

}  // namespace

TEST_CASE("the signature is Ed25519 of the image's bytes", "[signature]") {
  auto const key = image::make_secret_key();
  auto const image = image_bytes();
  auto const bytes = image::sign(image, key);
  REQUIRE(bytes.size() == image.size() + 80);
  CHECK(std::equal(image.begin(), image.end(), bytes.begin()));
  auto const* const octets = reinterpret_cast<unsigned char const*>(bytes.data());
  CHECK(crypto_sign_verify_detached(octets + image.size() + 16, octets, image.size(),
                                    key.public_key().data()) == 0);
  CHECK(image::signer(bytes) == image::key_id(key.public_key()));
  CHECK_FALSE(image::signer(image).has_value());
}

TEST_CASE("a controller with the key accepts this image and no other", "[signature]") {
  auto const key = image::make_secret_key();
  auto const image = image_bytes();
  auto bytes = image::sign(image, key);
  CHECK(image::check_signature(bytes, key.public_key()) == AXISRT_OK);
  CHECK(image::check_signature(image, key.public_key()) == AXISRT_UNSIGNED);
  CHECK(image::check_signature(bytes, image::make_secret_key().public_key()) == AXISRT_WRONG_SIGNATURE);
  for (std::size_t at = 0; at < bytes.size(); at += at < image.size() ? 17 : 1) {
    INFO("byte " << at);
    for (unsigned const bit : {0U, 7U}) {
      bytes[at] ^= std::byte{1} << bit;
      REQUIRE(image::check_signature(bytes, key.public_key()) != AXISRT_OK);
      bytes[at] ^= std::byte{1} << bit;
    }
  }
}

TEST_CASE("an image that was cut at any length is refused by a controller with the key", "[signature]") {
  auto const key = image::make_secret_key();
  auto const bytes = image::sign(image_bytes(), key);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    INFO(size);
    REQUIRE(image::check_signature(std::span(bytes).first(size), key.public_key()) != AXISRT_OK);
  }
}

TEST_CASE("keys survive their text, and nothing else is a key", "[signature]") {
  auto const key = image::make_secret_key();
  auto const secret = image::secret_key_text(key);
  auto const open = image::public_key_text(key.public_key());
  auto const again = image::read_secret_key(secret);
  REQUIRE(again.has_value());
  CHECK(again->public_key() == key.public_key());
  CHECK(image::read_public_key(open) == key.public_key());
  CHECK(image::read_public_key(open.substr(0, open.size() - 1) + "\r\n") == key.public_key());
  CHECK_FALSE(image::read_public_key(secret).has_value());
  CHECK_FALSE(image::read_secret_key(open).has_value());
  CHECK_FALSE(image::read_public_key("").has_value());
  CHECK_FALSE(image::read_public_key(open.substr(0, open.size() - 3)).has_value());
  CHECK_FALSE(image::read_public_key(open.substr(0, open.size() - 2) + "g\n").has_value());
  std::string changed = secret;
  changed[secret.size() - 2] = secret[secret.size() - 2] == '0' ? '1' : '0';
  CHECK_FALSE(image::read_secret_key(changed).has_value());
}
