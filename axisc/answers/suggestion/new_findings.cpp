#include "axisc/answers/suggestion/new_findings.hpp"

#include "validator/check.hpp"

#include <set>

namespace axisc {

NewFindings::NewFindings(std::string const& path, Workspace& workspace)
    : path_(path), workspace_(workspace), before_(count({})) {}

NewFindings::Counts NewFindings::count(EditedBytes const& edited) const {
  EditedFiles files(edited, workspace_.disk());
  SourceSet sources;
  Counts counts;
  static_cast<void>(
      validator::check(files, path_, workspace_.options_of(path_), sources,
                       [&](Finding const& finding) { ++counts[identity_of(finding, sources)]; }));
  return counts;
}

std::vector<std::string> NewFindings::of(EditedBytes const& edited) const {
  std::set<std::string> codes;
  for (auto const& [identity, count] : count(edited)) {
    auto const known = before_.find(identity);
    if (known == before_.end() || known->second < count) codes.insert(code_text(identity.code));
  }
  return {codes.begin(), codes.end()};
}

}  // namespace axisc
