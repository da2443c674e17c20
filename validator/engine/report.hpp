// How rules say what they found: in words at once, or, where a list may have thousands of the same, by the place alone;
// the words are then made when the finding is told.
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

/// What a finding is about, for rules that silence each other on one filter or in one program.
// NOLINT below: clang-tidy 14 takes the zero that comparisons are rewritten with for a pointer.
struct Subject {
  std::size_t axis = 0;
  FilterPort port = FilterPort::setpoint;
  std::uint32_t filter = 0;
  std::optional<std::size_t>
      program;  ///< index into LoadedMachine::programs: it is about that, not about a filter
  friend auto operator<=>(Subject const&, Subject const&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Makes the words of a finding whose place, code, severity and axis are set. What it refers to lives until all findings
/// are told: ListContext, AxisContext and what they lead to. Other contexts, and what a check has on its own stack, are gone
/// by then. Captures of sixteen bytes are kept without an allocation.
using Words = std::function<void(Finding&)>;

/// A finding as its rule reported it: what decides whether it stands.
struct Reported {
  Rule const* rule = nullptr;
  Place place;
  Severity severity = Severity::error;
  bool cycle_time_assumed = false;   ///< the rule needs T, and nothing gives it
  Subject const* subject = nullptr;  ///< none for rules that look neither at one filter nor at one program
  std::string_view axis;             ///< its name, where one is concerned
  std::optional<std::size_t> said = {};  ///< in words already: which of ReportedFindings::said
  Words words;                           ///< else what makes them
};

/// Findings as their rules reported them, before the engine decides.
struct ReportedFindings {
  std::vector<Reported> findings;
  std::vector<std::unique_ptr<Finding>> said;  ///< a reference to one stays good
};

/// Puts a finding into words. Once for each: what was said already is moved out.
[[nodiscard]] Finding tell(ReportedFindings& reported, Reported const& finding);

/// Takes over what configuration and loading found: code, place and sentences; the rule adds the rest.
void adopt(ReportedFindings& reported, Rule const& rule, Finding const& found);

/// A finding of a rule about which nothing else is known.
[[nodiscard]] Finding new_finding(Rule const& rule);

/// Collects what one rule says.
class Report {
 public:
  Report(ReportedFindings& reported, Rule const& its_rule, std::string_view its_axis = {})
      : axis(its_axis), reported_(reported), rule_(its_rule) {}

  /// The caller fills and may change the finding; code, name, severity, control message number and axis are set already. At
  /// the value of `at` (or its name where it has no value); sets parameter and P-AXIS number from it.
  Finding& add(EffectiveValue const& at, Message message);
  Finding& add(Place place, Message message);
  /// At `place`, about the parameter of `row` in `slot`.
  Finding& add(Place place, schema::Parameter const& row, schema::Slot slot, Message message);

  /// A finding whose words are made when it is told, for whatever every line of a list may be guilty of: until then it
  /// takes a hundred bytes, and of what does not stand no words are made at all. The reference is good until the next
  /// report.
  Reported& later(Place place, Words words);

  /// Set by the engine; rules about several axes set it before they report. Lives until all findings are told.
  std::string_view axis;

 private:
  ReportedFindings& reported_;
  Rule const& rule_;
};

}  // namespace axisc::validator
