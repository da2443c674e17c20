// A 128-bit content hash.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::cli {

/// 128 bits (XXH3). Safe against accidental collisions, not against deliberate ones.
struct Digest {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
  // clang-tidy 14 takes the zero that comparisons are rewritten with for a pointer.
  friend auto operator<=>(Digest const&, Digest const&) = default;  // NOLINT(modernize-use-nullptr)
};

[[nodiscard]] Digest digest_of(std::string_view bytes);

/// 32 hexadecimal digits.
[[nodiscard]] std::string hexadecimal(Digest const& digest);

/// Computes the digest of bytes that come in pieces.
class Hasher {
 public:
  Hasher();
  Hasher(Hasher&&) noexcept;
  Hasher& operator=(Hasher&&) noexcept;
  Hasher(Hasher const&) = delete;
  Hasher& operator=(Hasher const&) = delete;
  ~Hasher();

  /// The digest does not depend on how the bytes are split.
  void bytes(std::string_view piece);

  // Hashes the length, too, so that successive parts cannot be confused.
  void text(std::string_view part);
  void number(std::uint64_t part);
  void digest(Digest const& part);

  [[nodiscard]] Digest finish() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace axisc::cli
