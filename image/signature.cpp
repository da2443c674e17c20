#include "image/signature.hpp"

#include "codegen/aligned_bytes.hpp"
#include "codegen/record.hpp"

#include <algorithm>
#include <sodium/crypto_sign.h>

namespace axisc::image {

namespace {

constexpr std::array<std::uint8_t, 4> trailer_magic{'A', 'X', 'S', 'G'};
constexpr std::uint32_t trailer_version = 1;

std::size_t image_size(std::span<std::byte const> image) {
  return static_cast<std::size_t>(
      codegen::ConstRecord<codegen::records::header>(image).get(codegen::fields::header::total_size));
}

}  // namespace

std::vector<std::byte> sign(std::span<std::byte const> image, SecretKey const& key) {
  auto const content = image.first(image_size(image));
  std::array<std::uint8_t, crypto_sign_BYTES> signature{};
  crypto_sign_detached(signature.data(), nullptr, reinterpret_cast<unsigned char const*>(content.data()),
                       content.size(), key.data());
  std::vector<std::byte> bytes(content.begin(), content.end());
  bytes.resize(content.size() + codegen::records::trailer::bytes);
  codegen::Record<codegen::records::trailer> trailer{std::span<std::byte>(bytes).subspan(content.size())};
  trailer.set(codegen::fields::trailer::magic, trailer_magic);
  trailer.set(codegen::fields::trailer::version, trailer_version);
  trailer.set(codegen::fields::trailer::key_id, key_id(key.public_key()));
  trailer.set(codegen::fields::trailer::signature, signature);
  return bytes;
}

std::optional<KeyId> signer(std::span<std::byte const> image) {
  auto const trailer = image.subspan(image_size(image));
  if (trailer.empty()) return std::nullopt;
  return codegen::ConstRecord<codegen::records::trailer>(trailer).get(codegen::fields::trailer::key_id);
}

axisrt_status check_signature(std::span<std::byte const> image, PublicKey const& key) {
  codegen::AlignedBytes const bytes(image);
  PublicKey context = key;
  axisrt_config config{};
  config.size = sizeof config;
  config.image = bytes.data();
  config.image_size = bytes.size();
  config.level = AXISRT_LEVEL_PORTABLE;
  config.verify_signature = verify_with_public_key;
  config.verify_context = context.data();
  std::size_t memory_size = 0;
  std::size_t alignment = 0;
  return axisrt_memory_size(&config, &memory_size, &alignment);
}

int verify_with_public_key(void* public_key, std::uint8_t const* named_key, void const* image,
                           std::size_t image_size, std::uint8_t const* signature) {
  PublicKey key{};
  std::copy_n(static_cast<std::uint8_t const*>(public_key), key.size(), key.begin());
  KeyId const id = key_id(key);
  if (!std::equal(id.begin(), id.end(), named_key)) return -1;
  return crypto_sign_verify_detached(signature, static_cast<unsigned char const*>(image), image_size,
                                     key.data());
}

}  // namespace axisc::image
