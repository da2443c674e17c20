// How rules report findings: with their text at once, or, if a list may have thousands of them, by place
// alone; the text is then made when the finding is output.
#pragma once

#include "diagnostics/finding.hpp"
#include "schema/catalogue.hpp"
#include "validator/values/effective_values.hpp"
#include "validator/views/filter_view.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace axisc::validator {

struct Rule;

/// The subject of a finding, for rules that silence each other on one filter or in one program.
// NOLINT below: clang-tidy 14 takes the zero that comparisons are rewritten with for a pointer.
struct Subject {
  std::size_t axis = 0;
  FilterPort port = FilterPort::setpoint;
  std::uint32_t filter = 0;
  std::optional<std::size_t>
      program;  ///< index into LoadedMachine::programs: it is about that, not about a filter
  friend auto operator<=>(Subject const&, Subject const&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Makes the text of a finding whose place, code, severity and axis are set. Objects that it refers to must
/// live until all findings are output: ListContext, AxisContext and what they lead to. Other contexts and
/// local variables of a check do not live that long. Captures of sixteen bytes are kept without an
/// allocation.
using Words = std::function<void(Finding&)>;

/// A finding as its rule reported it, with everything that decides whether it is kept.
struct Reported {
  Rule const* rule = nullptr;
  Place place;
  Severity severity = Severity::error;
  bool cycle_time_assumed = false;  ///< the rule needs T, which is not known
  Subject const* subject =
      nullptr;            ///< none for rules that check neither a single filter nor a single program
  std::string_view axis;  ///< name of the axis concerned; empty if there is none
  std::optional<std::size_t> said = {};  ///< the text exists already: index into ReportedFindings::said
  Words words;                           ///< otherwise makes the text
};

/// Findings as their rules reported them, before the engine decides.
struct ReportedFindings {
  std::vector<Reported> findings;
  std::vector<std::unique_ptr<Finding>> said;  ///< references to entries stay valid
};

/// Makes the text of a finding. Call once for each: text that exists already is moved out.
[[nodiscard]] Finding tell(ReportedFindings& reported, Reported const& finding);

/// Completes a finding of configuration or loading, which has code, place and sentences, with the rest from
/// its rule.
void adopt(ReportedFindings& reported, Rule const& rule, Finding const& found);

/// An otherwise empty finding of a rule.
[[nodiscard]] Finding new_finding(Rule const& rule);

/// Collects the findings of one rule.
class Report {
 public:
  Report(ReportedFindings& reported, Rule const& its_rule, std::string_view its_axis = {})
      : axis(its_axis), reported_(reported), rule_(its_rule) {}

  /// The caller fills and may change the finding; code, name, severity, control message number and axis are
  /// set already. At the value of `at` (or its name where it has no value); sets parameter and P-AXIS number
  /// from it.
  Finding& add(EffectiveValue const& at, Message message);
  Finding& add(Place place, Message message);
  /// At `place`, about the parameter of `row` in `slot`.
  Finding& add(Place place, schema::Parameter const& row, schema::Slot slot, Message message);

  /// A finding rendered lazily, for mistakes that every line of a list may contain: until it is output it
  /// takes a hundred bytes, and the text of a dropped finding is never made. The reference is valid until the
  /// next report.
  Reported& later(Place place, Words words);

  /// Set by the engine; rules about several axes set it before they report. Lives until all findings are
  /// output.
  std::string_view axis;

 private:
  ReportedFindings& reported_;
  Rule const& rule_;
};

}  // namespace axisc::validator
