#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/hsc_words.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/hsc_view.hpp"

#include <algorithm>
#include <tuple>

namespace axisc::validator::checks::ax4002::says {

constexpr Sentence headline{"{count} HSC filters in one axis; only one is possible",
                            "{count} HSC-Filter in einer Achse; nur einer ist möglich"};
constexpr Sentence label{"one too many", "einer zu viel"};
constexpr Sentence help{"keep one of them, as `filter[0]`", "einen davon behalten, als `filter[0]`"};

}  // namespace axisc::validator::checks::ax4002::says

namespace axisc::validator::checks::ax4002 {
namespace {

/// The prototype that makes it an HSC filter is always set by a list.
bool stands_before(FilterView const& left, FilterView const& right) {
  return std::tuple(left.prototype.origin, left.prototype.line) <
         std::tuple(right.prototype.origin, right.prototype.line);
}

void hsc_more_than_one(FilterContext const& context, Report& report) {
  if (!is_configured_hsc(context.filter)) return;
  std::vector<FilterView> const filters = configured_hsc(context.axis.filters);
  auto const last = std::max_element(filters.begin(), filters.end(), stands_before);
  if (filters.size() < 2 || last->index != context.filter.index) return;
  Finding& finding =
      report.add(last->prototype, {says::headline, {{"count", number(static_cast<double>(filters.size()))}}});
  finding.label = Message{says::label, {}};
  for (FilterView const& filter : filters) {
    if (filter.index != last->index) relate_hsc_filter(finding, filter);
  }
  finding.help.push_back({says::help, {}});
  react(finding, {validator::says::filter_reaction_off, {}});
}

}  // namespace

extern constinit Rule const rule{
    .control = "110500",
    .parameters = "filter[].prototype filter[].type filter[].order",
    .check = hsc_more_than_one,
};

}  // namespace axisc::validator::checks::ax4002
