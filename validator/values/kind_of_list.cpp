#include "validator/values/kind_of_list.hpp"

namespace axisc::validator {

std::optional<configuration::ListKind> kind_of_list(SourceText const& source, grammar::AxisList const& list,
                                                    LineValues const& line_values) {
  constexpr std::size_t most_asked = 100;
  configuration::KindVote vote;
  std::size_t asked = 0;
  for (std::uint32_t const number : line_values.doubtful()) {
    if (line_values.closer(number).row_known()) continue;
    grammar::Assignment const& line = list.assignments[number];
    vote.unknown(source.slice(line.name), source.slice(line.trailer));
    if (++asked == most_asked) break;
  }
  for (std::size_t i = 0; i < line_values.size(); ++i) {
    if (line_values.slot(i)) vote.known(source.slice(list.assignments[i].name));
    if (vote.is_undisputed() && !vote.is_open()) return configuration::ListKind::axis;
  }
  if (vote.is_open()) return std::nullopt;
  return vote.winner();
}

}  // namespace axisc::validator
