#include "codegen/source_digest.hpp"

#include "codegen/record.hpp"

#include <sodium/crypto_hash_sha256.h>

namespace axisc::codegen {
namespace {

static_assert(std::tuple_size_v<Sha256> == crypto_hash_sha256_BYTES);

class Hash {
 public:
  Hash() { crypto_hash_sha256_init(&state_); }
  void add(std::string_view text) { add(std::as_bytes(std::span(text.data(), text.size()))); }
  void add(std::span<std::byte const> bytes) {
    crypto_hash_sha256_update(&state_, reinterpret_cast<unsigned char const*>(bytes.data()), bytes.size());
  }
  void add_content(machine::MachineList const& list) {
    if (!list.stored) return add(list.content);
    list.stored->read([this](std::string_view piece) { add(piece); });
  }
  Sha256 finish() {
    Sha256 digest{};
    crypto_hash_sha256_final(&state_, digest.data());
    return digest;
  }

 private:
  crypto_hash_sha256_state state_{};
};

}  // namespace

Sha256 sha256(std::string_view bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.finish();
}

Sha256 sha256(machine::MachineList const& list) {
  Hash hash;
  hash.add_content(list);
  return hash.finish();
}

Sha256 source_digest(std::span<machine::MachineList const> lists) {
  Hash hash;
  for (machine::MachineList const& list : lists) {
    std::array<std::byte, 1 + sizeof(std::uint64_t)> separator{};
    std::uint64_t const size = list.stored ? list.stored->size : list.content.size();
    store_little_endian(std::span(separator).subspan(1), size);
    hash.add(list.name);
    hash.add(separator);
    hash.add_content(list);
  }
  return hash.finish();
}

std::string hexadecimal(std::span<std::uint8_t const> bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (auto const byte : bytes) {
    text += digits[byte >> 4U];
    text += digits[byte & 0xFU];
  }
  return text;
}

}  // namespace axisc::codegen
