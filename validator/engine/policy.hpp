// Decisions that the options of a check make about findings: which rules report nothing, everywhere or in
// some files, and how severe the others are. The engine applies them before it decides which findings are
// kept.
#pragma once

#include "diagnostics/finding.hpp"
#include "validator/options.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc::validator {

struct Rule;

/// Options and sources must outlive it.
class Policy {
 public:
  Policy(CheckOptions const& options, SourceSet const& sources);

  /// False for a rule that reports nothing in this check: it is disabled, or it has only notes, without
  /// `pedantic` and without a higher severity in the options.
  [[nodiscard]] bool enabled(Rule const& rule) const;
  /// False if the rule is disabled everywhere, or in this source. Cost: patterns are compared once per
  /// source.
  [[nodiscard]] bool enabled(Rule const& rule, SourceId source);
  /// False for a note of a rule whose findings are usually more than that, without `pedantic`.
  [[nodiscard]] bool shows(Rule const& rule, Severity severity) const;
  /// The options disable the code everywhere or in the file of that name. Independent of `pedantic`.
  [[nodiscard]] bool disables(Code code, std::string const& file) const;

  /// The severity that the options give the code; `natural` if they give none.
  [[nodiscard]] Severity severity(Code code, Severity natural) const;

 private:
  using Codes = std::vector<Code>;

  [[nodiscard]] Codes disabled_in(std::string const& file) const;

  CheckOptions const& options_;
  SourceSet const& sources_;
  std::vector<char> enabled_;                   ///< of each rule of the table, as bools
  std::vector<std::optional<Codes>> disabled_;  ///< by source; none until first used
};

}  // namespace axisc::validator
