#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/sentences.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax2002::says {

constexpr Sentence headline{
    "index {index} is out of range: `{parameter}` has the entries 0 to {last}",
    "Index {index} liegt außerhalb des Bereichs: `{parameter}` hat die Einträge 0 bis {last}"};
constexpr Sentence missing{"`{parameter}` is an array and needs an index",
                           "`{parameter}` ist ein Feld und braucht einen Index"};
constexpr Sentence superfluous{"`{parameter}` is not an array and takes no index",
                               "`{parameter}` ist kein Feld und hat keinen Index"};
constexpr Sentence related{"here too", "hier ebenso"};
constexpr Sentence reaction{"the entry is lost, start-up continues",
                            "der Eintrag geht verloren, der Hochlauf geht weiter"};
constexpr Sentence help{"write its index: `{example}`", "seinen Index schreiben: `{example}`"};

}  // namespace axisc::validator::checks::ax2002::says

namespace axisc::validator::checks::ax2002 {
namespace {

bool is_wrong(Line const& line) {
  return line.line_value().row_known() && !line.line_value().known();
}

/// The text before the wrong index and the index itself: the same in all lines of one block. Empty for other
/// mistakes.
std::string_view block_of(Line const& line) {
  using Status = schema::NameLookup::Status;
  if (line.line_value().name_status != Status::index_out_of_range) return {};
  std::string_view const name = line.context.source.slice(line.assignment().name);
  return name.substr(0, name.find(']') + 1);
}

/// The further lines of a block are named, but have no findings of their own.
void relate_block(Finding& finding, Line const& first) {
  constexpr std::size_t most_named = 8;
  auto const& doubtful = first.context.list.line_values.doubtful();
  std::string_view const block = block_of(first);
  auto const* next = std::upper_bound(doubtful.data(), doubtful.data() + doubtful.size(), first.number);
  for (; next != doubtful.data() + doubtful.size() && finding.related.size() < most_named; ++next) {
    Line const line{first.context, *next};
    if (!is_wrong(line)) continue;
    if (block.empty() || block_of(line) != block) return;
    finding.related.push_back(
        {.place = line.place(line.assignment().name), .message = message(says::related)});
  }
}

/// The number in the brackets as it is written, however large.
std::string written_index(std::string_view name, std::size_t position) {
  std::size_t at = name.find('[');
  for (; position > 0 && at != std::string_view::npos; --position) at = name.find('[', at + 1);
  if (at == std::string_view::npos) return {};
  name.remove_prefix(at + 1);
  return std::string(name.substr(0, name.find(']')));
}

/// `filter[0].order` of `filter[].order`.
std::string with_first_entries(std::string_view pattern) {
  std::string name;
  for (char const character : pattern) {
    name += character;
    if (character == '[') name += '0';
  }
  return name;
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
    if (name.status == Status::index_missing) {
      finding.help.push_back(message(says::help, {{"example", with_first_entries(pattern)}}));
    }
  }
  set_reaction(finding, says::reaction);
  relate_block(finding, line);
  // For a scalar the name alone is the repair; if other indices are possible, the intended one is unknown.
  if (name.status != Status::index_superfluous || pattern.find('[') != std::string::npos) return;
  finding.fix = replace_by(line.place(written), pattern,
                           message(validator::says::parameter_fix, {{"replacement", pattern}}));
}

void index_out_of_range(ListContext const& context, Report& report) {
  std::string_view last;
  for_each_doubtful(context, [&](Line const& line) {
    if (!is_wrong(line)) return;
    std::string_view const block = block_of(line);
    bool const goes_on = !block.empty() && block == last;
    last = block;
    if (goes_on) return;
    Reported& reported = report_line<describe>(report, line, line.assignment().name);
    // Which of their parameters are arrays is less certain of other kinds of lists.
    bool const is_certain = context.list.kind == configuration::ListKind::axis ||
                            line.line_value().name_status == LineValue::NameStatus::index_out_of_range;
    if (!is_certain) reported.severity = Severity::note;
  });
}

}  // namespace

extern constinit Rule const rule{
    .control = "2009",
    .about = [](schema::Parameter const&) { return true; },
    .precedence = Precedence::before_family,
    .check = index_out_of_range,
};

}  // namespace axisc::validator::checks::ax2002
