#include "analysis/motion/program/problems.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace axisc::motion {
namespace {

constexpr Code not_simulated{9007};
constexpr Code cannot_simulate{9008};

std::string_view name_of(Code code) {
  if (code == not_simulated) return "not-simulated";
  return code == cannot_simulate ? "cannot-simulate" : "";
}

ProgramProblem problem_at(NcBlock const& block, Token const& token, Code code, Message message) {
  ProgramProblem problem;
  problem.finding.code = code;
  problem.finding.severity = code == not_simulated ? Severity::warning : Severity::error;
  problem.finding.name = name_of(code);
  message.arguments.push_back({.name = "word", .value = std::string(block.text(token))});
  problem.finding.message = std::move(message);
  problem.line = token.line;
  std::size_t const at = token.span.begin - block.offset;
  std::size_t const begin = at == 0 ? 0 : block.lines.rfind('\n', at - 1) + 1;
  std::size_t const end = std::min(block.lines.find('\n', at), block.lines.size());
  problem.line_text = block.lines.substr(begin, end - begin);
  problem.span = {.begin = static_cast<std::uint32_t>(at - begin),
                  .end = static_cast<std::uint32_t>(at - begin + token.span.size())};
  return problem;
}

}  // namespace

void ProgramProblems::report(NcBlock const& block, Token const& token, Code code, Message message) {
  sink_(problem_at(block, token, code, std::move(message)));
}

void ProgramProblems::ignore(NcBlock const& block, Token const& token, std::string const& key,
                             SentenceRef text, std::vector<Argument> arguments) {
  constexpr std::size_t most_named = 100;
  if (ignored_.size() < most_named && ignored_.insert(key).second) {
    report(block, token, not_simulated, {text, std::move(arguments)});
  }
}

void ProgramProblems::ignore_unless_used(NcBlock const& block, Token const& token, std::string const& key,
                                         SentenceRef text) {
  if (later_) return;
  later_ = problem_at(block, token, not_simulated, {text});
  later_key_ = key;
}

void ProgramProblems::finish() {
  if (later_ && !used_ && ignored_.insert(later_key_).second) sink_(*std::move(later_));
}

void ProgramProblems::refuse(NcBlock const& block, Token const& token, SentenceRef text) {
  refused_ = true;
  broken_ = broken_ || block.is_kept;
  report(block, token, cannot_simulate, {text});
}

}  // namespace axisc::motion
