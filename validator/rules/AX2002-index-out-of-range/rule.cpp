#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/sentences.hpp"

namespace axisc::validator::says {

constexpr Sentence headline{
    "index {index} is out of range: `{parameter}` has the entries 0 to {last}",
    "Index {index} liegt außerhalb des Bereichs: `{parameter}` hat die Einträge 0 bis {last}"};
constexpr Sentence missing{"`{parameter}` is an array and needs an index",
                           "`{parameter}` ist ein Feld und braucht einen Index"};
constexpr Sentence superfluous{"`{parameter}` is not an array and takes no index",
                               "`{parameter}` ist kein Feld und hat keinen Index"};
constexpr Sentence reaction{"the entry is lost, start-up continues",
                            "der Eintrag geht verloren, der Hochlauf geht weiter"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

/// The number in the brackets as it is written, however large.
std::string written_index(std::string_view name, std::size_t position) {
  std::size_t at = name.find('[');
  for (; position > 0 && at != std::string_view::npos; --position) at = name.find('[', at + 1);
  if (at == std::string_view::npos) return {};
  name.remove_prefix(at + 1);
  return std::string(name.substr(0, name.find(']')));
}

void describe(Finding& finding, Line const& line) {
  using Status = schema::NameLookup::Status;
  Span const written = line.assignment().name;
  schema::NameLookup const name = line.context.list.catalogue.find(line.context.source.slice(written));
  std::string const pattern(name.row->name);
  if (name.status == Status::index_out_of_range) {
    finding.message = message(
        says::headline, {{"index", written_index(line.context.source.slice(written), name.index_position)},
                         {"parameter", pattern},
                         {"last", std::to_string(name.array_size - 1)}});
  } else {
    finding.message = message(name.status == Status::index_missing ? says::missing : says::superfluous,
                              {{"parameter", pattern}});
  }
  set_reaction(finding, says::reaction);
  // For a scalar the name alone is the repair; if other indices are possible, the intended one is unknown.
  if (name.status != Status::index_superfluous || pattern.find('[') != std::string::npos) return;
  finding.fix =
      replace_by(line.place(written), pattern, message(says::parameter_fix, {{"replacement", pattern}}));
}

void index_out_of_range(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    if (!line.reading().row_known() || line.reading().known()) return;
    report_line<describe>(report, line, line.assignment().name);
  });
}

}  // namespace

extern constinit Rule const ax2002{
    .code = Code{2002},
    .name = "index-out-of-range",
    .control = "2009",
    .precedence = Precedence::before_family,
    .check = index_out_of_range,
};

}  // namespace axisc::validator::checks
