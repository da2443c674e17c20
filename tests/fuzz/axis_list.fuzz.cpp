// Any bytes as an axis list, in both encodings: every span lies inside the text, every line that is not blank
// says something at most once, every number token converts or is beyond its type, quickly as slowly, and what
// lines say without the grammar is what they say with it.
#include "grammar/axis_list.hpp"

#include "grammar/number.hpp"
#include "schema/catalogue.hpp"
#include "schema/value.hpp"
#include "validator/same_lists.hpp"
#include "validator/values/short_number.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

using axisc::Span;
using axisc::grammar::Assignment;
using axisc::grammar::AxisList;
using axisc::grammar::TrailerKind;
using axisc::grammar::ValueKind;

void require(bool condition) {
  if (!condition) std::abort();
}

void check_span(Span span, std::string_view bytes) {
  require(span.begin <= span.end && span.end <= bytes.size());
  require(bytes.substr(span.begin, span.size()).find('\n') == std::string_view::npos);
}

/// What is read eight digits at a time is what is read digit by digit.
void check_short_number(Assignment const& assignment, std::string_view bytes) {
  namespace validator = axisc::validator;
  if (assignment.value.end < validator::room_before_number_end) return;
  std::string_view const token = bytes.substr(assignment.value.begin, assignment.value.size());
  char const* const end = token.data() + token.size();
  double number = 0;
  if (assignment.kind == ValueKind::integer && validator::read_short_integer(token.data(), end, number)) {
    require(axisc::schema::read_integer(token, axisc::schema::DataType::sgn64).number == number);
  }
  if (assignment.kind == ValueKind::real && validator::read_short_real(token.data(), end, number)) {
    axisc::schema::NumberReading const reading = axisc::schema::read_real(token);
    require(reading.status == axisc::schema::NumberStatus::good && reading.number == number);
  }
}

void check_value(Assignment const& assignment, std::string_view bytes) {
  std::string_view const token = bytes.substr(assignment.value.begin, assignment.value.size());
  if (assignment.kind == ValueKind::real && token.size() < 100) {
    bool const may_be_too_big = token.find_first_of("eE") != std::string_view::npos;
    require(may_be_too_big || axisc::grammar::real_value(token).has_value());
  }
}

void check_list(AxisList const& list, std::string_view bytes) {
  std::uint32_t line = 0;
  for (Assignment const& assignment : list.assignments) {
    Span const free_text = axisc::grammar::free_text(bytes, assignment);
    for (Span const span : {assignment.name, assignment.value, assignment.trailer, free_text}) {
      check_span(span, bytes);
    }
    require(!assignment.name.empty() && !assignment.value.empty());
    require(assignment.name.end < assignment.value.begin && assignment.value.end <= assignment.trailer.begin);
    require(free_text.begin == assignment.value.begin);
    require(assignment.trailer.empty() == (assignment.trailer_kind == TrailerKind::none));
    require(assignment.line > line && assignment.line <= list.lines);
    line = assignment.line;
    check_value(assignment, bytes);
    check_short_number(assignment, bytes);
  }
  line = 0;
  for (auto const& problem : list.problems) {
    check_span(problem.span, bytes);
    require(!problem.span.empty());
    require(problem.line > line && problem.line <= list.lines);
    line = problem.line;
  }
  for (auto const& directive : list.directives) {
    check_span(directive.comment, bytes);
    require(bytes.substr(directive.comment.begin, directive.comment.size()).find("axisc:") !=
            std::string_view::npos);
  }
  if (list.end_marker) check_span(*list.end_marker, bytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const bytes(reinterpret_cast<char const*>(data), size);
  for (bool const windows_1252 : {false, true}) {
    AxisList const list = axisc::grammar::parse_axis_list(bytes, 0, windows_1252);
    check_list(list, bytes);
  }
  axisc::SourceText const source("x.lis", std::string(bytes));
  require(axisc::tests::reads_as_by_the_grammar(source));
  return 0;
}
