#include "cli/fleet/digest.hpp"

#include <new>
#include <xxhash.h>

namespace axisc::cli {

namespace {

Digest as_digest(XXH128_hash_t hash) {
  return {.high = hash.high64, .low = hash.low64};
}

void append_hexadecimal(std::string& text, std::uint64_t number) {
  constexpr std::string_view digits = "0123456789abcdef";
  for (int shift = 60; shift >= 0; shift -= 4) {
    text += digits[(number >> static_cast<unsigned>(shift)) & 0xFU];
  }
}

}  // namespace

/// Freed with the library's own function: the state is aligned more strictly than `new` promises.
struct Hasher::State {
  State() : hash(XXH3_createState()) {
    if (hash == nullptr) throw std::bad_alloc();
    XXH3_128bits_reset(hash);
  }
  State(State const&) = delete;
  State& operator=(State const&) = delete;
  ~State() { XXH3_freeState(hash); }

  XXH3_state_t* hash;
};

Digest digest_of(std::string_view bytes) {
  return as_digest(XXH3_128bits(bytes.data(), bytes.size()));
}

std::string hexadecimal(Digest const& digest) {
  std::string text;
  append_hexadecimal(text, digest.high);
  append_hexadecimal(text, digest.low);
  return text;
}

Hasher::Hasher() : state_(std::make_unique<State>()) {}
Hasher::Hasher(Hasher&&) noexcept = default;
Hasher& Hasher::operator=(Hasher&&) noexcept = default;
Hasher::~Hasher() = default;

void Hasher::bytes(std::string_view piece) {
  XXH3_128bits_update(state_->hash, piece.data(), piece.size());
}

void Hasher::text(std::string_view part) {
  number(part.size());
  bytes(part);
}

void Hasher::number(std::uint64_t part) {
  // Independent of the processor's byte order.
  char eight[sizeof(part)];
  for (char& byte : eight) {
    byte = static_cast<char>(part & 0xFFU);
    part >>= 8U;
  }
  bytes({eight, sizeof(eight)});
}

void Hasher::digest(Digest const& part) {
  number(part.high);
  number(part.low);
}

Digest Hasher::finish() const {
  return as_digest(XXH3_128bits_digest(state_->hash));
}

}  // namespace axisc::cli
