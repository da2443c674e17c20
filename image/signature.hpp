// Signatures of images: Ed25519 with libsodium, as a trailer after the image (docs/image-format.md, record
// trailer).
#pragma once

#include "axisrt.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::image {

/// First bytes of the SHA-256 of the public key: names a key, proves nothing.
using KeyId = std::array<std::uint8_t, 8>;
using PublicKey = std::array<std::uint8_t, 32>;

/// Wiped when it is not needed any more; never printed but into a key file.
class SecretKey {
 public:
  static constexpr std::size_t size = 64;  ///< seed and public key
  explicit SecretKey(std::span<std::uint8_t const, size> bytes);
  SecretKey(SecretKey&& other) noexcept;
  SecretKey(SecretKey const&) = delete;
  SecretKey& operator=(SecretKey const&) = delete;
  SecretKey& operator=(SecretKey&&) = delete;
  ~SecretKey();

  [[nodiscard]] std::uint8_t const* data() const { return bytes_.data(); }
  [[nodiscard]] PublicKey public_key() const;

 private:
  std::array<std::uint8_t, size> bytes_{};
};

/// From the system's random numbers.
[[nodiscard]] SecretKey make_secret_key();

[[nodiscard]] KeyId key_id(PublicKey const& key);

// Key files are one line: a word for its kind, and the key in hexadecimal digits.

/// To be wiped by the caller.
[[nodiscard]] std::string secret_key_text(SecretKey const& key);
[[nodiscard]] std::string public_key_text(PublicKey const& key);
/// Nothing for any other text, and for a secret key whose two halves do not belong together.
[[nodiscard]] std::optional<SecretKey> read_secret_key(std::string_view text);
[[nodiscard]] std::optional<PublicKey> read_public_key(std::string_view text);
/// Overwrites memory that held a secret.
void wipe(std::span<char> text);

// These expect an image that read_image() accepts, with or without a trailer.

/// The image with a trailer by this key; one it had before is replaced.
[[nodiscard]] std::vector<std::byte> sign(std::span<std::byte const> image, SecretKey const& key);
/// The key that the trailer names; nothing for an unsigned image.
[[nodiscard]] std::optional<KeyId> signer(std::span<std::byte const> image);

/// The answer of a controller that holds `key`: AXISRT_OK, AXISRT_UNSIGNED, AXISRT_WRONG_SIGNATURE, or the
/// status of axisrt_verify.
[[nodiscard]] axisrt_status check_signature(std::span<std::byte const> image, PublicKey const& key);

/// An axisrt_verify_signature; its context is a PublicKey.
[[nodiscard]] int verify_with_public_key(void* public_key, std::uint8_t const* named_key, void const* image,
                                         std::size_t image_size, std::uint8_t const* signature);

}  // namespace axisc::image
