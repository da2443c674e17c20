#include "analysis/motion/program/variables.hpp"

#include "analysis/motion/program/numbers.hpp"
#include "grammar/expression.hpp"

namespace axisc::motion::says {

constexpr Sentence cannot_simulate_expression{
    "the simulation cannot compute this: it knows numbers, P1, V.P.NAME with a value, + - * / [ ], "
    "comparisons, AND, OR and ABS, SQRT, SIN, COS, TAN, INT, NOT",
    "die Simulation kann das nicht berechnen: sie kennt Zahlen, P1, V.P.NAME mit einem Wert, + - * / [ ], "
    "Vergleiche, AND, OR und ABS, SQRT, SIN, COS, TAN, INT, NOT"};

}  // namespace axisc::motion::says

namespace axisc::motion {

bool is_variable(std::string_view name) {
  if (name.starts_with("V.P.")) return true;
  return name.starts_with('P') && whole_number(name.substr(1)).has_value();
}

std::optional<double> ProgramVariables::value_at(std::uint32_t& place, NcBlock const& block,
                                                 Token const& token, ProgramProblems& problems) const {
  auto const expression = grammar::parse_expression(block.lines.substr(place - block.offset));
  auto const variable = [this](std::string const& name) -> std::optional<double> {
    auto const found = values_.find(name);
    return found == values_.end() ? std::nullopt : std::optional(found->second);
  };
  auto const value = expression ? grammar::value_of(*expression, variable) : std::nullopt;
  if (!value) {
    problems.refuse(block, token, says::cannot_simulate_expression);
    return std::nullopt;
  }
  place += static_cast<std::uint32_t>(expression->size);
  return value;
}

double ProgramVariables::value_behind(std::size_t at, NcBlock const& block, ProgramProblems& problems) const {
  Token const& token = block.tokens[at];
  if (at + 1 == block.tokens.size()) {
    problems.refuse(block, token, says::cannot_simulate_here);
    return 0;
  }
  std::uint32_t place = block.tokens[at + 1].span.begin;
  auto const value = value_at(place, block, token, problems);
  if (value && block.tokens.back().span.begin >= place) {
    problems.refuse(block, token, says::cannot_simulate_expression);
    return 0;
  }
  return value.value_or(0);
}

}  // namespace axisc::motion
