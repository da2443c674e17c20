// `must<kind>[p]`: the place where a line has to continue with `p`. On failure it remembers what was expected
// and where, and the line fails like with any other parser: nothing is thrown, so a file full of mistakes
// reads as fast as a sound one.
//
// The first expectation of a line that fails is the one that counts. `must` belongs into sequences; inside an
// alternative it would remember a failure that the next branch repairs.
#pragma once

#include <boost/spirit/home/x3.hpp>

namespace axisc::grammar {

/// The first expectation of a line that was not met; `where` is null while there is none. Each grammar has
/// its own enumeration of possible mistakes.
template <typename Kind>
struct Failure {
  Kind kind{};
  char const* where = nullptr;
};

/// Under this tag the context of a parse carries its Failure.
struct FailureTag {};

template <auto kind, typename Subject>
struct MustDirective : boost::spirit::x3::unary_parser<Subject, MustDirective<kind, Subject>> {
  using base_type = boost::spirit::x3::unary_parser<Subject, MustDirective<kind, Subject>>;
  static bool const is_pass_through_unary = true;
  static bool const handles_container = Subject::handles_container;

  constexpr explicit MustDirective(Subject const& expected) : base_type(expected) {}

  template <typename Iterator, typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, Iterator const& last, Context const& context, RuleContext& rule_context,
             Attribute& attribute) const {
    Iterator const start = first;
    if (this->subject.parse(first, last, context, rule_context, attribute)) return true;
    Failure<decltype(kind)>& failure = boost::spirit::x3::get<FailureTag>(context);
    if (failure.where == nullptr) failure = {.kind = kind, .where = start};
    return false;
  }
};

template <auto kind>
struct MustGenerator {
  template <typename Subject>
  constexpr auto operator[](Subject const& expected) const {
    using Parser = typename boost::spirit::x3::extension::as_parser<Subject>::value_type;
    return MustDirective<kind, Parser>(boost::spirit::x3::as_parser(expected));
  }
};

template <auto kind>
inline constexpr MustGenerator<kind> must{};

}  // namespace axisc::grammar
