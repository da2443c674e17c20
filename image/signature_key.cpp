#include "codegen/source_digest.hpp"
#include "image/signature.hpp"

#include <algorithm>
#include <new>
#include <sodium/core.h>
#include <sodium/crypto_sign.h>
#include <sodium/utils.h>

namespace axisc::image {

namespace {

static_assert(SecretKey::size == crypto_sign_SECRETKEYBYTES);
static_assert(std::tuple_size_v<PublicKey> == crypto_sign_PUBLICKEYBYTES);

constexpr std::string_view secret_word = "axisc-secret-key-1 ";
constexpr std::string_view public_word = "axisc-public-key-1 ";

std::string key_text(std::string_view word, std::span<std::uint8_t const> bytes) {
  // Allocated once: a buffer that has to grow would leave a part of the secret in its old memory.
  std::string text(word.size() + 2 * bytes.size() + 1, '\n');
  std::copy(word.begin(), word.end(), text.begin());
  // Writes a zero after the digits, where the line end goes afterwards.
  sodium_bin2hex(text.data() + word.size(), 2 * bytes.size() + 1, bytes.data(), bytes.size());
  text.back() = '\n';
  return text;
}

template <std::size_t Size>
bool read_key(std::string_view text, std::string_view word, std::array<std::uint8_t, Size>& bytes) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  if (text.substr(0, word.size()) != word) return false;
  text.remove_prefix(word.size());
  std::size_t read = 0;
  return text.size() == 2 * Size &&
         sodium_hex2bin(bytes.data(), bytes.size(), text.data(), text.size(), nullptr, &read, nullptr) == 0 &&
         read == Size;
}

}  // namespace

SecretKey::SecretKey(std::span<std::uint8_t const, size> bytes) {
  std::copy(bytes.begin(), bytes.end(), bytes_.begin());
}

SecretKey::SecretKey(SecretKey&& other) noexcept : bytes_(other.bytes_) {
  sodium_memzero(other.bytes_.data(), size);
}

SecretKey::~SecretKey() {
  sodium_memzero(bytes_.data(), size);
}

PublicKey SecretKey::public_key() const {
  PublicKey key{};
  crypto_sign_ed25519_sk_to_pk(key.data(), bytes_.data());
  return key;
}

SecretKey make_secret_key() {
  if (sodium_init() < 0) throw std::bad_alloc();  // it reserves memory and opens the system's random numbers
  PublicKey open{};
  std::array<std::uint8_t, SecretKey::size> secret{};
  crypto_sign_keypair(open.data(), secret.data());
  SecretKey key(secret);
  sodium_memzero(secret.data(), secret.size());
  return key;
}

KeyId key_id(PublicKey const& key) {
  codegen::Sha256 const digest = codegen::sha256({reinterpret_cast<char const*>(key.data()), key.size()});
  KeyId id{};
  std::copy_n(digest.begin(), id.size(), id.begin());
  return id;
}

std::string secret_key_text(SecretKey const& key) {
  return key_text(secret_word, {key.data(), SecretKey::size});
}

std::string public_key_text(PublicKey const& key) {
  return key_text(public_word, key);
}

std::optional<SecretKey> read_secret_key(std::string_view text) {
  std::array<std::uint8_t, SecretKey::size> bytes{};
  std::array<std::uint8_t, SecretKey::size> again{};
  PublicKey open{};
  std::optional<SecretKey> key;
  if (read_key(text, secret_word, bytes)) {
    crypto_sign_seed_keypair(open.data(), again.data(), bytes.data());  // the seed is the first half
    if (sodium_memcmp(again.data(), bytes.data(), bytes.size()) == 0) key.emplace(bytes);
  }
  sodium_memzero(bytes.data(), bytes.size());
  sodium_memzero(again.data(), again.size());
  return key;
}

std::optional<PublicKey> read_public_key(std::string_view text) {
  PublicKey key{};
  if (!read_key(text, public_word, key)) return std::nullopt;
  return key;
}

void wipe(std::span<char> text) {
  sodium_memzero(text.data(), text.size());
}

}  // namespace axisc::image
