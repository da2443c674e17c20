#include "validator/judgement.hpp"
#include "validator/reading.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::validator {
namespace {

/// See Readings::doubtful(). A character has a byte at least.
bool is_doubtful(grammar::Assignment const& assignment, Reading const& reading) {
  if (!reading.usable() || reading.name_folded || reading.symbol_folded || !reading.trouble.empty() ||
      assignment.trailer_kind == grammar::TrailerKind::text) {
    return true;
  }
  if (reading.status == ReadingStatus::reference) return false;
  std::size_t const most = reading.row->max_length;
  return is_outside(*reading.row, reading.value.number) || (most != 0 && reading.value.text.size() > most);
}

}  // namespace

class ListReader {
 public:
  ListReader(SourceText const& source, grammar::AxisList const& list, schema::Catalogue const& catalogue)
      : source_(source), list_(list), catalogue_(catalogue) {
    result_.readings_.reserve(list.assignments.size());
  }

  /// Names first: a processor works at several look-ups at once when nothing stands between them.
  Readings read() && {
    for (grammar::Assignment const& assignment : list_.assignments) look_up(assignment);
    for (std::uint32_t i = 0; i < list_.assignments.size(); ++i) judge(i);
    return std::move(result_);
  }

 private:
  void judge(std::uint32_t number) {
    grammar::Assignment const& assignment = list_.assignments[number];
    Reading& reading = result_.readings_[number];
    validator::judge(source_, assignment, reading, result_.transcoded_);
    if (!reading.row_known()) suggest(number);
    if (is_doubtful(assignment, reading)) result_.doubtful_.push_back(number);
  }

  void look_up(grammar::Assignment const& assignment) {
    std::string_view const name = source_.slice(assignment.name);
    Reading& reading = result_.readings_.emplace_back();
    if (auto const exact = catalogue_.find_exact(name)) {
      reading.row = exact.row;
      reading.slot = exact.slot;
      reading.name_status = schema::NameLookup::Status::found;
      return;
    }
    schema::NameLookup const lookup = catalogue_.find(name);
    reading.row = lookup.row;
    reading.slot = lookup.slot;
    reading.name_status = lookup.status;
    reading.name_folded = lookup.case_folded;
  }

  void suggest(std::uint32_t number) {
    constexpr std::size_t most_suggestions = 1000;
    if (++unknown_names_ > most_suggestions) return;
    std::vector<std::string> names = catalogue_.suggest_names(source_.slice(list_.assignments[number].name));
    if (!names.empty()) result_.suggested_.push_back({.assignment = number, .names = std::move(names)});
  }

  SourceText const& source_;
  grammar::AxisList const& list_;
  schema::Catalogue const& catalogue_;
  Readings result_;
  std::size_t unknown_names_ = 0;
};

std::span<std::string const> Readings::suggestions(std::size_t assignment) const {
  auto const found = std::lower_bound(
      suggested_.begin(), suggested_.end(), assignment,
      [](Suggested const& suggested, std::size_t wanted) { return suggested.assignment < wanted; });
  if (found == suggested_.end() || found->assignment != assignment) return {};
  return found->names;
}

Readings read_assignments(SourceText const& source, grammar::AxisList const& list,
                          schema::Catalogue const& catalogue) {
  return ListReader(source, list, catalogue).read();
}

}  // namespace axisc::validator
