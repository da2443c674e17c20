#include "diagnostics/fingerprint.hpp"

#include "diagnostics/location.hpp"
#include "diagnostics/utf8.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {
namespace {

/// FNV-1a with 64 bits: baselines need no protection against attacks, and a collision becomes likely only
/// with billions of findings.
class Hash {
 public:
  void add(std::string_view text) {
    for (char const character : text) mix(static_cast<unsigned char>(character));
    // A separator, so that two parts cannot be confused.
    mix(0);
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  void mix(unsigned char byte) { state_ = (state_ ^ byte) * 0x100000001B3ULL; }

  std::uint64_t state_ = 0xCBF29CE484222325ULL;
};

std::string hexadecimal(std::uint64_t value) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) {
    text += digits[(value >> static_cast<unsigned>(shift)) & 0xFU];
  }
  return text;
}

}  // namespace

void identify(Identity& identity, Finding const& finding, SourceSet const& sources) {
  identity.code = finding.code;
  identity.file.clear();
  identity.axis.clear();
  identity.parameter.clear();
  // Well-formed, because a baseline is JSON.
  append_repaired(identity.file, file_of(finding, sources));
  append_repaired(identity.axis, finding.axis);
  append_repaired(identity.parameter, finding.parameter);
}

Identity identity_of(Finding const& finding, SourceSet const& sources) {
  Identity identity;
  identify(identity, finding, sources);
  return identity;
}

std::uint64_t hash_of(Identity const& identity) {
  Hash hash;
  hash.add(code_text(identity.code));
  hash.add(identity.file);
  hash.add(identity.axis);
  hash.add(identity.parameter);
  return hash.value();
}

std::string fingerprint(Identity const& identity, std::uint32_t occurrence) {
  return hexadecimal(hash_of(identity)) + ':' + std::to_string(occurrence);
}

std::string fingerprint(Finding const& finding, SourceSet const& sources) {
  return fingerprint(identity_of(finding, sources), finding.occurrence);
}

}  // namespace axisc
