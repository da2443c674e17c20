// The grammar of expressions, in Spirit X3. Its actions write the steps as a stack computes them.
#pragma once

#include "grammar/expression.hpp"
#include "grammar/nc_command_def.hpp"

namespace axisc::grammar::expression_syntax {

using block_syntax::gap;
using block_syntax::word_end;

struct StepsTag;

/// Appends an operation.
inline constexpr auto append = [](Operation operation) {
  return [operation](auto& context) { x3::get<StepsTag>(context).push_back({operation, 0, {}}); };
};
inline constexpr auto append_variable = [](auto& context) {
  auto const range = x3::_attr(context);
  x3::get<StepsTag>(context).push_back({Operation::variable, 0, std::string(range.begin(), range.end())});
};
inline constexpr auto append_number = [](auto& context) {
  auto const range = x3::_attr(context);
  x3::get<StepsTag>(context).push_back({Operation::number, number_of(range.begin(), range.end()), {}});
};

inline constexpr x3::rule<struct ConditionRule> condition{"condition"};
inline constexpr x3::rule<struct OperandRule> operand{"operand"};
inline constexpr x3::rule<struct FactorRule> factor{"factor"};
inline constexpr x3::rule<struct ProductRule> product{"product"};
inline constexpr x3::rule<struct SumRule> sum{"sum"};
inline constexpr x3::rule<struct ComparisonRule> comparison{"comparison"};
inline constexpr x3::rule<struct ConjunctionRule> conjunction{"conjunction"};

inline constexpr auto bracket = '[' >> gap >> condition >> ']' >> gap;
inline constexpr auto function(char const* name, Operation operation) {
  return (x3::lit(name) >> gap >> &x3::lit('[') >> bracket)[append(operation)];
}
inline constexpr auto number = x3::raw[(block_syntax::digits >> -('.' >> -block_syntax::digits)) |
                                       ('.' >> block_syntax::digits)][append_number] >>
                               gap;
inline constexpr auto variable =
    x3::raw[(('P' >> block_syntax::digits) | ("V.P." >> block_syntax::identifier)) >> word_end]
           [append_variable] >>
    gap;

inline constexpr auto operand_def =
    x3::omit[number | variable | function("ABS", Operation::absolute) |
             function("SQRT", Operation::square_root) | function("SIN", Operation::sine) |
             function("COS", Operation::cosine) | function("TAN", Operation::tangent) |
             function("INT", Operation::whole_part) | function("NOT", Operation::logical_not) | bracket];
inline constexpr auto factor_def =
    ('-' >> gap >> operand)[append(Operation::negate)] | (-x3::lit('+') >> gap >> operand);
inline constexpr auto product_def = factor >> *(('*' >> gap >> factor)[append(Operation::multiply)] |
                                                ('/' >> gap >> factor)[append(Operation::divide)]);
inline constexpr auto sum_def = product >> *(('+' >> gap >> product)[append(Operation::add)] |
                                             ('-' >> gap >> product)[append(Operation::subtract)]);
inline constexpr auto comparison_def = sum >> -(("==" >> gap >> sum)[append(Operation::equal)] |
                                                ("!=" >> gap >> sum)[append(Operation::unequal)] |
                                                ("<=" >> gap >> sum)[append(Operation::less_or_equal)] |
                                                (">=" >> gap >> sum)[append(Operation::greater_or_equal)] |
                                                ('<' >> gap >> sum)[append(Operation::less)] |
                                                ('>' >> gap >> sum)[append(Operation::greater)]);
inline constexpr auto conjunction_def = comparison >> *(("AND" >> word_end >> gap >>
                                                         comparison)[append(Operation::logical_and)]);
inline constexpr auto condition_def = conjunction >> *(("OR" >> word_end >> gap >>
                                                        conjunction)[append(Operation::logical_or)]);

BOOST_SPIRIT_DEFINE(operand, factor, product, sum, comparison, conjunction, condition)

}  // namespace axisc::grammar::expression_syntax
