// What a reader of NC programs says, one line for each event.
#pragma once

#include "grammar/nc_program.hpp"

#include <string>
#include <string_view>

namespace axisc::test {

/// `2: address <G01>`, `3: filter <#FILTER> on <ORDER>=integer <20>`, with spans cut from `bytes`.
class ProgramTrace final : public grammar::ProgramListener {
 public:
  explicit ProgramTrace(std::string_view bytes) : bytes_(bytes) {}

  void word(grammar::Word const& word) override;
  void command(grammar::NcCommand command) override;
  void directive(grammar::Directive const& directive) override;

  std::string text;

 private:
  [[nodiscard]] std::string shown(Span span) const;

  std::string_view bytes_;
};

/// The trace of parse by ProgramReader.
[[nodiscard]] std::string trace_program(std::string_view bytes, grammar::ProgramDetail detail);

/// One command as the trace shows it.
[[nodiscard]] std::string trace_command(std::string_view text);

}  // namespace axisc::test
