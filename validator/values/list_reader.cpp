#include "validator/values/list_reader.hpp"

#include "diagnostics/utf8.hpp"
#include "grammar/axis_list_reader.hpp"
#include "grammar/lexical.hpp"
#include "grammar/line_splitter.hpp"
#include "grammar/plain_lines.hpp"
#include "validator/values/line_value.hpp"
#include "validator/values/plain_value.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::validator {
namespace {

/// See LineValues::doubtful(). A character has a byte at least.
bool is_doubtful(grammar::Assignment const& assignment, LineValue const& line_value) {
  if (!line_value.usable() || line_value.name_folded || line_value.symbol_folded ||
      !line_value.trouble.empty() || assignment.trailer_kind == grammar::TrailerKind::text) {
    return true;
  }
  if (line_value.status == ReadingStatus::reference) return false;
  std::size_t const most = line_value.row->max_length;
  return schema::is_outside(*line_value.row, line_value.value.number) ||
         (most != 0 && line_value.value.text.size() > most);
}

bool may_name_numbers(std::string_view text) {
  return text.find(grammar::lexical::parameter_number_prefix) != std::string_view::npos;
}

}  // namespace

class ListReader {
 public:
  ListReader(SourceText const& source, schema::Catalogue const& catalogue)
      : source_(source), bytes_(source.bytes()), catalogue_(catalogue), lines_(source.bytes()) {
    result_.bytes_ = bytes_;
    result_.catalogue_ = catalogue;
    if (is_axis_list_) result_.last_of_slot_.resize(catalogue.slot_count());
  }

  ReadList read() && {
    result_.brief_.reserve(lines_.list().assignments.capacity());
    grammar::LineSplitter splitter(bytes_.substr(source_.text_begin()), source_.lines_before());
    std::string_view line;
    do {
      read_plain_lines(splitter);
      // Near the end of the text, and for lines too long to be plain.
      if (splitter.next(line)) read_by_grammar(line, splitter.number());
    } while (!splitter.at_end());
    return finish(std::move(lines_).finish(splitter.number()));
  }

  ReadList judge(grammar::AxisList tree) && {
    result_.brief_.reserve(tree.assignments.size());
    result_.may_name_numbers_ = may_name_numbers(bytes_);
    for (grammar::Assignment const& assignment : tree.assignments) look_closer(assignment, {});
    return finish(std::move(tree));
  }

 private:
  ReadList finish(grammar::AxisList tree) {
    result_.has_repetitions_ = repetitions_ != 0;
    ReadList read{.tree = std::move(tree), .line_values = std::move(result_)};
    read.line_values.assignments_ = read.tree.assignments;
    return read;
  }

  /// From the next line on: all but those near the text's end.
  void read_plain_lines(grammar::LineSplitter& splitter) {
    grammar::PlainLines lines;
    auto begin = static_cast<std::uint32_t>(splitter.position() - bytes_.data());
    std::uint32_t number = splitter.number();
    while (!lines_.has_ended()) {
      grammar::find_lines(bytes_, begin, lines);
      if (lines.count == 0) break;
      lines.lines_before = number;
      std::size_t const count = read_lines(lines);
      begin = lines.begins[count];
      number += static_cast<std::uint32_t>(count);
    }
    result_.may_name_numbers_ |= lines.may_name_numbers;
    splitter.go_on_at(bytes_.data() + begin, number);
  }

  /// Returns the number of lines that were read: all, or up to the end of the list.
  std::size_t read_lines(grammar::PlainLines const& lines) {
    std::size_t next = 0;
    while (next < lines.count) {
      std::size_t const count = grammar::split_lines(bytes_, lines, next, batch_);
      read_batch(lines, count);
      if (next == lines.count || count == batch_.size()) continue;
      read_by_grammar(lines.line(bytes_, next), lines.number(next));
      ++next;
      if (lines_.has_ended()) return next;
    }
    return next;
  }

  /// The assignments that were cut out of their lines, of which none ends the list.
  void read_batch(grammar::PlainLines const& lines, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      names_[i] = {bytes_.data() + batch_[i].name.begin, batch_[i].name.size()};
    }
    catalogue_.find_plain(std::span(names_).first(count), parameters_);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (read_plain(i)) continue;
      keep(kept, i);
      kept = i + 1;
      read_closer(lines, i);
    }
    keep(kept, count);
  }

  /// False if the line is left to the grammar.
  bool read_plain(std::size_t i) {
    schema::PlainParameter const& parameter = parameters_[i];
    PlainValue value;
    bool const is_plain = is_axis_list_ && parameter.values != nullptr &&
                          PlainValueReader(bytes_, batch_[i]).read(*parameter.values, value);
    if (!is_plain) return false;
    batch_[i].kind = value.kind;
    readings_[i] = {.number = value.number, .other = 0, .slot = brief(parameter.slot), .text = value.text};
    return true;
  }

  /// A line that is not plain. If its name is known and its value looks simple, the result of the grammar is
  /// known without parsing.
  void read_closer(grammar::PlainLines const& lines, std::size_t i) {
    grammar::Assignment& assignment = batch_[i];
    auto const kind = grammar::lexical::simple_kind(source_.slice(assignment.value));
    if (parameters_[i].values == nullptr || !kind) {
      std::size_t const line = assignment.line - lines.lines_before - 1;
      return read_by_grammar(lines.line(bytes_, line), assignment.line, parameters_[i]);
    }
    assignment.kind = *kind;
    lines_.add({&assignment, 1});
    look_closer(assignment, parameters_[i]);
  }

  /// Adds the assignments that were read without the grammar.
  void keep(std::size_t begin, std::size_t end) {
    auto number = static_cast<std::uint32_t>(result_.brief_.size());
    for (std::size_t i = begin; i < end; ++i) note_slot(parameters_[i].slot, ++number);
    lines_.add(std::span(batch_).subspan(begin, end - begin));
    result_.brief_.insert(result_.brief_.end(), readings_.data() + begin, readings_.data() + end);
  }

  /// `parameter` is that of the name, if it was looked up already.
  void read_by_grammar(std::string_view line, std::uint32_t number, schema::PlainParameter parameter = {}) {
    std::size_t const before = lines_.list().assignments.size();
    result_.may_name_numbers_ |= may_name_numbers(line);
    // The encoding is determined only for non-ASCII text.
    bool const is_ascii = ascii_prefix(line) == line.size();
    lines_.read(line, number, !is_ascii && source_.encoding() == Encoding::windows_1252);
    if (lines_.list().assignments.size() != before) look_closer(lines_.list().assignments.back(), parameter);
  }

  void look_closer(grammar::Assignment const& assignment, schema::PlainParameter parameter) {
    auto const number = static_cast<std::uint32_t>(result_.brief_.size());
    // Reserve at once: if one line is wrong, many may be.
    if (result_.others_.empty()) result_.others_.reserve(result_.brief_.capacity());
    LineValue& line_value = result_.others_.emplace_back();
    line_value.text = assignment.value;
    if (parameter.values != nullptr) {
      line_value.row = &catalogue_.parameter_of(parameter.slot);
      line_value.slot = parameter.slot;
      line_value.name_status = schema::NameLookup::Status::found;
    } else {
      look_up(assignment, line_value);
    }
    validator::judge(source_, assignment, line_value, result_.transcoded_);
    result_.brief_.push_back({.number = line_value.value.number,
                              .other = static_cast<std::uint32_t>(result_.others_.size()),
                              .slot = brief(line_value.slot),
                              .text = BriefReading::no_text});
    if (!line_value.row_known()) suggest(number, assignment);
    if (line_value.known()) note_slot(line_value.slot, number + 1);
    if (line_value.known() && line_value.status != ReadingStatus::value) {
      result_.without_value_.push_back(number);
    }
    if (is_doubtful(assignment, line_value)) result_.doubtful_.push_back(number);
  }

  void look_up(grammar::Assignment const& assignment, LineValue& line_value) {
    schema::NameLookup const lookup = catalogue_.find(source_.slice(assignment.name));
    line_value.row = lookup.row;
    line_value.slot = lookup.slot;
    line_value.name_status = lookup.status;
    line_value.name_folded = lookup.case_folded;
  }

  /// Notes the slot of an assignment, counted from 1.
  void note_slot(schema::Slot slot, std::uint32_t assignment) {
    std::uint32_t& last =
        is_axis_list_ ? result_.last_of_slot_[static_cast<std::size_t>(slot)] : result_.last_of_many_[slot];
    repetitions_ |= last;
    last = assignment;
  }

  static std::uint16_t brief(schema::Slot slot) { return static_cast<std::uint16_t>(slot); }

  void suggest(std::uint32_t number, grammar::Assignment const& assignment) {
    constexpr std::size_t most_suggestions = 1000;
    if (++unknown_names_ > most_suggestions) return;
    schema::NameSuggestions names = catalogue_.suggest_names(source_.slice(assignment.name));
    if (!names.names.empty()) result_.suggested_.push_back({.assignment = number, .names = std::move(names)});
  }

  SourceText const& source_;
  std::string_view bytes_;
  schema::Catalogue const& catalogue_;
  bool is_axis_list_ = catalogue_.kind() == schema::ListKind::axis;
  grammar::AxisListReader lines_;
  LineValues result_;
  // Buffers for the lines of one batch.
  std::array<grammar::Assignment, schema::names_at_once> batch_;
  std::array<std::string_view, schema::names_at_once> names_;
  std::array<schema::PlainParameter, schema::names_at_once> parameters_;
  std::array<BriefReading, schema::names_at_once> readings_;
  std::uint32_t repetitions_ = 0;  ///< zero as long as every line names a parameter of its own
  std::size_t unknown_names_ = 0;
};

ReadList read_list(SourceText const& source, schema::Catalogue const& catalogue) {
  return ListReader(source, catalogue).read();
}

ReadList judge_list(SourceText const& source, grammar::AxisList tree, schema::Catalogue const& catalogue) {
  return ListReader(source, catalogue).judge(std::move(tree));
}

}  // namespace axisc::validator
