// The identity of a finding, independent of its line and wording: file, axis, parameter path and code. It is
// the fingerprint in SARIF and GitLab reports and the key of a baseline.
#pragma once

#include "diagnostics/finding.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// Order and equality of identities are those of their members.
struct Identity {
  std::string file;       ///< as the finding names it, or its path in the repository
  std::string axis;       ///< its name; empty where no axis is concerned
  std::string parameter;  ///< `filter[0].order`; empty where no parameter is concerned
  Code code{};
  // clang-tidy 14 takes the zero that comparisons are rewritten with for a pointer.
  friend auto operator<=>(Identity const&, Identity const&) = default;  // NOLINT(modernize-use-nullptr)
};

/// With the file as the finding names it.
[[nodiscard]] Identity identity_of(Finding const& finding, SourceSet const& sources);
/// The identity, written into an existing object to reuse its memory.
void identify(Identity& identity, Finding const& finding, SourceSet const& sources);

/// 64 bits: equal identities have the same. A collision becomes likely only with billions of findings.
[[nodiscard]] std::uint64_t hash_of(Identity const& identity);

/// "39fa2ee980eb94b0:1": hash_of() the identity, and the occurrence. Must never change, because baselines
/// contain it.
[[nodiscard]] std::string fingerprint(Identity const& identity, std::uint32_t occurrence);
[[nodiscard]] std::string fingerprint(Finding const& finding, SourceSet const& sources);

}  // namespace axisc
