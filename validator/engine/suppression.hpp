// Comments that silence findings: `axisc: allow AX3005, decimal-comma` and, for the whole file, `axisc:
// allow-file AX3005`.
#pragma once

#include "diagnostics/finding.hpp"
#include "grammar/directive.hpp"
#include "validator/engine/report.hpp"

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace axisc::validator {

/// One code of one comment.
struct Allowance {
  Code code{};
  bool known = false;        ///< there is such a rule
  bool is_directive = true;  ///< false for a word other than `allow`, which silences nothing
  bool whole_file = false;   ///< `axisc: allow-file`; its line is 0
  bool next_line = false;    ///< the comment is alone on its line and applies to the line below
  std::uint32_t line = 0;    ///< the line that it silences
  Place place;               ///< of the code within the comment
  Place removed;  ///< the part that a fix removes: the code with its comma; the last code with `axisc: allow`
  bool used = false;
  bool is_too_much = false;  ///< not a code: the rest of a comment that names too many
};

/// All allowances of the lists and programs of a run.
class Suppressions {
 public:
  void add(SourceSet const& sources, SourceId source, std::vector<grammar::Directive> const& directives);

  /// True where an allowance silences the finding; it counts as used then.
  bool silences(Code code, Place place, SourceSet const& sources);

  /// AX1013 for everything that silenced nothing. Codes for which `counts(code, source)` is false are not
  /// judged: findings that cannot be reported there cannot be silenced either.
  template <typename Counts>
  void report_unused(SourceSet const& sources, Counts counts, ReportedFindings& reported) {
    for (auto& [source, allowances] : allowances_) {
      for (Allowance& allowance : allowances) {
        if (allowance.used || (allowance.known && !counts(allowance.code, source))) continue;
        if (!silences(unused_allowance, allowance.place, sources)) report(allowance, sources, reported);
      }
    }
  }

 private:
  static constexpr Code unused_allowance{1013};

  static void report(Allowance const& allowance, SourceSet const& sources, ReportedFindings& reported);

  std::map<SourceId, std::vector<Allowance>> allowances_;
};

}  // namespace axisc::validator
