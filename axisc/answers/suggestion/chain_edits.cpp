#include "axisc/answers/suggestion/chain_edits.hpp"

#include "axisc/asked/quantities.hpp"
#include "diagnostics/fix_batch.hpp"
#include "diagnostics/format_number.hpp"
#include "validator/views/filter_view.hpp"
#include "validator/views/fir_view.hpp"
#include "validator/views/guard_view.hpp"
#include "validator/views/hsc_view.hpp"

#include <algorithm>
#include <deque>
#include <set>
#include <string_view>

namespace axisc {

namespace {

using tuning::ListLine;
using validator::EffectiveValue;
using validator::EffectiveValues;

EffectiveValue const& value_of(EffectiveValues const& values, std::string const& name) {
  return values[values.catalogue().find_exact(name).slot];
}

bool sets(std::vector<ListLine> const& lines, std::string_view name) {
  return std::any_of(lines.begin(), lines.end(), [&](ListLine const& line) { return line.name == name; });
}

/// Resets a parameter that the new filter does not use, where a list sets it to something else.
void reset(std::vector<ListLine>& lines, EffectiveValue const& value) {
  auto const name = parameter_name(value);
  if (sets(lines, name) || !configured(value)) return;
  auto const usual = schema::default_value(*value.row);
  if (usual) lines.push_back({.name = name, .value = format_exact(usual->number)});
}

/// The value that applies is this one already.
bool is_set_so(EffectiveValue const& value, std::string const& text) {
  if (value.unusable) return false;
  if (auto const number = parse_finite(text)) return value.value.number == *number;
  return value.value.text == text;
}

std::string_view family_of(std::string_view name) {
  return name.substr(0, name.rfind('.') + 1);
}

/// How a line of a list goes on after its value: "( P-AXIS-00573 : ...".
struct Comment {
  std::size_t column = 0;  ///< counted from the name; 0: there is none with a parameter's number
  std::string_view opener = {};
};

Comment comment_of(SourceText const& source, grammar::Assignment const& assignment) {
  auto const end = source.line_span(assignment.line).end;
  auto const rest = source.slice({.begin = assignment.value.end, .end = end});
  auto const begin = rest.find_first_of("(#");
  auto const number = rest.find("P-AXIS-");
  bool const is_numbered = number != std::string_view::npos && begin < number &&
                           rest.find_first_not_of(" \t") == begin &&
                           rest.find_first_not_of(" \t", begin + 1) == number;
  if (!is_numbered) return {};
  return {.column = assignment.value.end + begin - assignment.name.begin,
          .opener = rest.substr(begin, number - begin)};
}

/// Where a line is added to a list, and the columns in which value and comment begin there.
struct Gap {
  std::uint32_t at = 0;
  std::size_t value_column = 0;
  bool needs_line_end = false;  ///< before the new line
  Comment comment = {};         ///< none where less than half of the list's lines have one
};

Gap gap_for(validator::LoadedList const& list, SourceText const& source, std::string_view family) {
  auto const bytes = source.bytes();
  grammar::Assignment const* last = nullptr;
  std::size_t column = 0;
  std::size_t commented = 0;
  Comment comment;
  for (auto const& assignment : list.tree.assignments) {
    column = assignment.value.begin - assignment.name.begin;
    if (source.slice(assignment.name).starts_with(family)) last = &assignment;
    auto const own = comment_of(source, assignment);
    if (own.column == 0) continue;
    ++commented;
    comment = own;
  }
  if (2 * commented < list.tree.assignments.size()) comment = {};
  auto const end = static_cast<std::uint32_t>(bytes.size());
  if (last == nullptr) {
    auto const at = list.tree.end_marker ? list.tree.end_marker->begin : end;
    return {.at = at,
            .value_column = column,
            .needs_line_end = !list.tree.end_marker && !bytes.empty() && bytes.back() != '\n',
            .comment = comment};
  }
  if (auto const own = comment_of(source, *last); own.column != 0 && comment.column != 0) comment = own;
  auto const line_end = bytes.find('\n', last->value.end);
  bool const is_open = line_end == std::string_view::npos;
  return {.at = is_open ? end : static_cast<std::uint32_t>(line_end + 1),
          .value_column = last->value.begin - last->name.begin,
          .needs_line_end = is_open,
          .comment = comment};
}

/// In the columns of its neighbours, with the parameter's number where they have theirs.
std::string line_of(std::string const& name, std::string const& text, EffectiveValue const& value,
                    Gap const& gap) {
  auto line = name;
  auto const pad = [&line](std::size_t column) {
    line.append(column > line.size() ? column - line.size() : 1, ' ');
  };
  pad(gap.value_column);
  line += text;
  auto const number = schema::p_axis_text(value.row->p_axis);
  // Nothing but `(` ends a string.
  bool const is_ended = gap.comment.opener.starts_with('(') || value.row->is_enumeration() ||
                        value.row->type != schema::DataType::string;
  if (gap.comment.column == 0 || number.empty() || !is_ended) return line + "\n";
  pad(gap.comment.column);
  return line.append(gap.comment.opener).append(number).append("\n");
}

Fix fix_of(validator::LoadedMachine const& machine, std::size_t axis, SourceSet const& sources,
           std::vector<ListLine> const& lines, Defaults defaults) {
  auto const& loaded = machine.axes[axis];
  auto const& list = machine.lists[loaded.list].list;
  auto const& source = sources[list.source];
  Fix fix;
  for (auto const& [name, text] : lines) {
    auto const& value = value_of(loaded.merged.values, name);
    bool const is_said = value.set() || defaults == Defaults::left_out;
    if (is_said && is_set_so(value, text)) continue;
    if (value.origin == validator::Origin::axis_list && value.value_place()) {
      fix.edits.push_back({*value.value_place(), text});
      continue;
    }
    auto const gap = gap_for(list, source, family_of(name));
    auto const line = line_of(name, text, value, gap);
    Place const place{.source = list.source, .span = {.begin = gap.at, .end = gap.at}};
    auto const same = std::find_if(fix.edits.begin(), fix.edits.end(),
                                   [&](Edit const& edit) { return edit.place.span == place.span; });
    if (same != fix.edits.end()) {
      same->text += line;
    } else {
      fix.edits.push_back({place, gap.needs_line_end ? "\n" + line : line});
    }
  }
  return fix;
}

/// What switches off a filter that the chain does not have.
void switch_off(std::vector<ListLine>& lines, EffectiveValues const& values) {
  for (auto const& filter : validator::touched_filters(values)) {
    if (filter.port != validator::FilterPort::setpoint) continue;
    bool const is_used = sets(lines, parameter_name(filter.prototype));
    if (is_used) {
      reset(lines, filter.quality);
      reset(lines, filter.time_constant);
      continue;
    }
    if (is_configured_hsc(filter)) {
      lines.push_back({.name = parameter_name(filter.prototype), .value = "CRIT_DAMPING"});
      lines.push_back({.name = parameter_name(filter.type), .value = "LOWPASS"});
    }
    if (filter.enable.value.flag()) {
      lines.push_back({.name = parameter_name(filter.enable), .value = "0"});
    }
  }
  validator::GuardView const guard(values);
  if (guard.is_active() && !sets(lines, parameter_name(guard.active))) {
    lines.push_back({.name = parameter_name(guard.active), .value = "0"});
  }
  validator::FirView const fir(values);
  if (sets(lines, parameter_name(fir.type))) {
    for (auto const* const value : {&fir.order_time, &fir.frequency, &fir.quality}) reset(lines, *value);
  } else if (fir.configured()) {
    lines.push_back({.name = parameter_name(fir.enable), .value = "0"});
    lines.push_back({.name = parameter_name(fir.type), .value = "0"});
  }
}

}  // namespace

AxisLines lines_of(validator::LoadedMachine const& machine, std::size_t axis, tuning::Chain const& chain,
                   machine::KernelFamily family) {
  auto const& loaded = machine.axes[axis];
  AxisLines found{.axis = loaded.name,
                  .list = machine.lists[loaded.list].name,
                  .lines = tuning::list_lines(chain, family)};
  switch_off(found.lines, loaded.merged.values);
  return found;
}

ListEdits edit_lists(validator::LoadedMachine const& machine, LinesByAxis const& lines,
                     SourceSet const& sources, Defaults defaults) {
  ListEdits edits;
  FixBatch batch(sources);
  std::deque<Fix> fixes;
  std::set<std::size_t> written;
  for (auto const& [axis, wanted] : lines) {
    auto const list = machine.axes[axis].list;
    if (!written.insert(list).second) continue;
    auto const& source = sources[machine.lists[list].list.source];
    fixes.push_back(fix_of(machine, axis, sources, wanted, defaults));
    if (fixes.back().edits.empty()) continue;
    if (source.is_translation() || !batch.add(fixes.back())) {
      return {.original = {}, .edited = {}, .refused = source.name()};
    }
    edits.original.insert_or_assign(source.name(), *source.file());
  }
  for (auto& source : batch.apply()) {
    edits.edited.insert_or_assign(sources[source.source].name(), std::move(source.bytes));
  }
  return edits;
}

ListEdits edit_lists(validator::LoadedMachine const& machine, std::vector<std::size_t> const& axes,
                     SourceSet const& sources, tuning::Chain const& chain, machine::KernelFamily family) {
  LinesByAxis lines;
  for (auto const axis : axes) lines.emplace_back(axis, lines_of(machine, axis, chain, family).lines);
  return edit_lists(machine, lines, sources);
}

}  // namespace axisc
