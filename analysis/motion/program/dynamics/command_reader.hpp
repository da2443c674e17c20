// Reads what follows the name of a `#` command, word by word.
#pragma once

#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/state.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace axisc::motion {

class CommandReader {
 public:
  /// `name` is the first word of the command, of which `length` words are its name. Both references outlive
  /// this.
  CommandReader(std::size_t name, std::size_t length, NcBlock const& block, ProgramState& state)
      : name_(name), at_(name + length), block_(block), state_(state) {}

  [[nodiscard]] bool at_end() const { return at_ == block_.tokens.size(); }
  /// Empty at the end.
  [[nodiscard]] std::string_view next() const;
  /// The next word, whatever it is.
  std::string_view take();
  /// True where the next word is this one, which is taken.
  bool take(std::string_view word);
  /// A number or an expression; none where it was refused.
  std::optional<double> take_number();
  /// Refuses the command, at its name.
  void refuse(SentenceRef text);

 private:
  std::size_t name_, at_;
  NcBlock const& block_;
  ProgramState& state_;
};

}  // namespace axisc::motion
