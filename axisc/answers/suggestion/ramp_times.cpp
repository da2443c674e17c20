#include "axisc/answers/suggestion/ramp_times.hpp"

#include "axisc/answers/suggestion/new_findings.hpp"

#include <string_view>

namespace axisc {

std::optional<RampAnswer> ramp_times_for(SuggestionSubject const& subject, tuning::Task const& task) {
  auto found = tuning::ramp_candidates(task, tuning::Excitation(task));
  if (!found) return std::nullopt;
  RampAnswer answer{.found = *std::move(found)};
  auto const* const quickest = answer.quickest();
  if (quickest == nullptr) return answer;
  std::vector<tuning::ListLine> lines;
  for (std::string_view const name : {"tr_beschl_zu", "tr_beschl_ab", "tr_brems_zu", "tr_brems_ab"}) {
    lines.push_back({.name = "getriebe[0].slope_profil." + std::string(name),
                     .value = std::to_string(quickest->ramp_time)});
  }
  std::size_t const index = subject.machine.axes[subject.axis].gantry_master.value_or(subject.axis);
  auto const& listed = subject.loaded.axes[index];
  answer.axes = {{.axis = listed.name, .list = subject.loaded.lists[listed.list].name, .lines = lines}};
  answer.edits = edit_lists(subject.loaded, LinesByAxis{{index, std::move(lines)}}, subject.sources);
  if (!answer.edits.refused) {
    answer.findings = NewFindings(subject.path, subject.workspace).of(answer.edits.edited);
  }
  return answer;
}

}  // namespace axisc
