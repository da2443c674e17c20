#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

bool is_undocumented(int type) {
  return type == 7 || type == 9 || type == 13;
}

bool is_hsc_type(int type) {
  return type == 8 || type == 12;
}

void undocumented_type(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (filter.type_unusable()) return;
  int const type = filter.type_number();
  bool const misplaced = filter.port == FilterPort::additional_interface && is_hsc_type(type);
  if (!is_undocumented(type) && !misplaced) return;
  Finding& finding = report.add(filter.type, {misplaced ? Text::ax3012_interface : Text::ax3012,
                                              {{"type", std::string(filter.type_word())}}});
  finding.label = Message{Text::ax3012_label, {}};
  finding.notes.push_back({misplaced ? Text::ax3012_limit_interface : Text::ax3012_limit,
                           {{"p_axis", parameter_number(filter.type)}}});
}

}  // namespace

extern constinit Rule const ax3012{
    .code = Code{3012},
    .name = "undocumented-type",
    .check = undocumented_type,
};

}  // namespace axisc::validator::checks
