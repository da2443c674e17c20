#include "diagnostics/fingerprint.hpp"

#include "diagnostics/fnv.hpp"
#include "diagnostics/location.hpp"
#include "diagnostics/utf8.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {
namespace {

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
  // With a separator, so that two parts cannot be confused.
  auto const with = [](std::uint64_t hash, std::string_view part) {
    return fnv1a(std::string_view("\0", 1), fnv1a(part, hash));
  };
  auto hash = with(fnv_basis, code_text(identity.code));
  for (auto const* const part : {&identity.file, &identity.axis, &identity.parameter}) {
    hash = with(hash, *part);
  }
  return hash;
}

std::string fingerprint(Identity const& identity, std::uint32_t occurrence) {
  return hexadecimal(hash_of(identity)) + ':' + std::to_string(occurrence);
}

std::string fingerprint(Finding const& finding, SourceSet const& sources) {
  return fingerprint(identity_of(finding, sources), finding.occurrence);
}

}  // namespace axisc
