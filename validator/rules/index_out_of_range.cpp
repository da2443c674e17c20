#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator {

void checks::index_out_of_range(ListContext const& context, Report& report) {
  using Status = schema::NameLookup::Status;
  for_each_doubtful(context.list, [&](grammar::Assignment const& assignment, Reading const& reading) {
    if (!reading.row_known() || reading.known()) return;
    schema::NameLookup const name = context.list.catalogue.find(context.source.slice(assignment.name));
    std::string const pattern(name.row->name);
    Message text =
        message(name.status == Status::index_missing ? Text::ax2002_missing : Text::ax2002_superfluous,
                {{"parameter", pattern}});
    if (name.status == Status::index_out_of_range) {
      text = message(Text::ax2002, {{"index", std::to_string(name.index.at(name.index_position))},
                                    {"parameter", pattern},
                                    {"last", std::to_string(name.array_size - 1)}});
    }
    Finding& finding = add_at(context, report, assignment, reading, assignment.name, std::move(text));
    set_reaction(finding, Text::ax2002_reaction);
    // A scalar's name is the whole repair; where other indices remain, nobody knows which one was meant.
    if (name.status != Status::index_superfluous || pattern.find('[') != std::string::npos) return;
    finding.fix = replace_by(place_of(context, assignment.name), pattern,
                             message(Text::parameter_fix, {{"replacement", pattern}}));
  });
}

}  // namespace axisc::validator
