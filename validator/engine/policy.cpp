#include "validator/engine/policy.hpp"

#include "validator/engine/rule.hpp"

#include <algorithm>
#include <cstddef>

namespace axisc::validator {
namespace {

bool contains(std::vector<Code> const& codes, Code code) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

}  // namespace

Policy::Policy(CheckOptions const& options, SourceSet const& sources)
    : options_(options), sources_(sources), enabled_(rules().size()) {
  for (Rule const& rule : rules()) {
    bool const only_notes = rule.severity == Severity::note && !rule.always &&
                            severity(rule.code, rule.severity) == Severity::note;
    enabled_[number_of(rule)] = static_cast<char>(options.pedantic || !only_notes);
  }
  for (Code const code : options.disabled) {
    Rule const* const rule = find_rule(code);
    if (rule != nullptr) enabled_[number_of(*rule)] = 0;
  }
}

bool Policy::enabled(Rule const& rule) const {
  return enabled_[number_of(rule)] != 0;
}

bool Policy::enabled(Rule const& rule, SourceId source) {
  if (!enabled(rule)) return false;
  if (options_.paths.empty()) return true;
  auto const number = static_cast<std::size_t>(source);
  if (disabled_.size() <= number) disabled_.resize(number + 1);
  std::optional<Codes>& disabled = disabled_[number];
  if (!disabled) disabled = disabled_in(sources_[source].name());
  return !contains(*disabled, rule.code);
}

bool Policy::shows(Rule const& rule, Severity severity) const {
  bool const only_note = severity == Severity::note && rule.severity != Severity::note;
  return !only_note || options_.pedantic || options_.severities.contains(rule.code);
}

bool Policy::disables(Code code, std::string const& file) const {
  return contains(options_.disabled, code) || contains(disabled_in(file), code);
}

Severity Policy::severity(Code code, Severity natural) const {
  if (options_.severities.empty()) return natural;
  auto const wanted = options_.severities.find(code);
  return wanted == options_.severities.end() ? natural : wanted->second;
}

Policy::Codes Policy::disabled_in(std::string const& file) const {
  Codes codes;
  for (PathRule const& rule : options_.paths) {
    if (rule.covers(file)) codes.insert(codes.end(), rule.disabled.begin(), rule.disabled.end());
  }
  return codes;
}

}  // namespace axisc::validator
