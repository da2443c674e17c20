#include "grammar/expression.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace axisc::grammar::expression_syntax {
namespace {

double number_of(char const* first, char const* last) {
  double value = 0;
  std::from_chars(first, last, value);
  return value;
}

}  // namespace
}  // namespace axisc::grammar::expression_syntax

#include "grammar/expression_def.hpp"

namespace axisc::grammar {
namespace {

constexpr int deepest_bracket = 32;
constexpr double degree = std::numbers::pi / 180;

bool nests_too_deep(std::string_view text) {
  int depth = 0;
  int deepest = 0;
  for (char const byte : text) {
    if (byte == '[') deepest = std::max(deepest, ++depth);
    if (byte == ']') --depth;
  }
  return deepest > deepest_bracket;
}

double unary(Operation operation, double x) {
  switch (operation) {
    case Operation::negate: return -x;
    case Operation::absolute: return std::abs(x);
    case Operation::square_root: return std::sqrt(x);
    case Operation::sine: return std::sin(x * degree);
    case Operation::cosine: return std::cos(x * degree);
    case Operation::tangent: return std::tan(x * degree);
    case Operation::whole_part: return std::trunc(x);
    default: return x == 0 ? 1 : 0;
  }
}

double binary(Operation operation, double x, double y) {
  switch (operation) {
    case Operation::add: return x + y;
    case Operation::subtract: return x - y;
    case Operation::multiply: return x * y;
    case Operation::divide: return x / y;
    case Operation::equal: return x == y ? 1 : 0;
    case Operation::unequal: return x != y ? 1 : 0;
    case Operation::less: return x < y ? 1 : 0;
    case Operation::less_or_equal: return x <= y ? 1 : 0;
    case Operation::greater: return x > y ? 1 : 0;
    case Operation::greater_or_equal: return x >= y ? 1 : 0;
    case Operation::logical_and: return x != 0 && y != 0 ? 1 : 0;
    default: return x != 0 || y != 0 ? 1 : 0;
  }
}

}  // namespace

std::optional<Expression> parse_expression(std::string_view text) {
  if (nests_too_deep(text)) return std::nullopt;
  Expression expression;
  char const* first = text.data();
  char const* const last = first + text.size();
  auto const parser = x3::with<expression_syntax::StepsTag>(
      expression.steps)[expression_syntax::gap >> expression_syntax::condition];
  if (!x3::parse(first, last, parser)) return std::nullopt;
  expression.size = static_cast<std::size_t>(first - text.data());
  return expression;
}

std::optional<double> value_of(Expression const& expression,
                               std::function<std::optional<double>(std::string const&)> const& variable) {
  std::vector<double> stack;
  for (auto const& step : expression.steps) {
    if (step.operation == Operation::number) {
      stack.push_back(step.number);
    } else if (step.operation == Operation::variable) {
      auto const value = variable(step.variable);
      if (!value) return std::nullopt;
      stack.push_back(*value);
    } else if (step.operation < Operation::add) {
      if (stack.empty()) return std::nullopt;
      stack.back() = unary(step.operation, stack.back());
    } else {
      if (stack.size() < 2) return std::nullopt;
      double const right = stack.back();
      stack.pop_back();
      stack.back() = binary(step.operation, stack.back(), right);
    }
  }
  // More than one value is left where the text ended in the middle of an operation.
  if (stack.size() != 1 || !std::isfinite(stack.front())) return std::nullopt;
  return stack.front();
}

}  // namespace axisc::grammar
