#include "axisc/asked/plane.hpp"

#include "axisc/environment/failure.hpp"
#include "diagnostics/joined.hpp"

namespace axisc::says {

constexpr Sentence bad_plane{"--plane needs two of the axes {axes}, not \"{value}\"",
                             "--plane braucht zwei der Achsen {axes}, nicht \"{value}\""};

}  // namespace axisc::says

namespace axisc {

std::pair<std::size_t, std::size_t> asked_plane(std::string const& word,
                                                std::vector<std::string> const& axes) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (std::size_t j = 0; j < axes.size(); ++j) {
      if (i != j && (word == axes[i] + axes[j] || word == axes[i] + "," + axes[j])) return {i, j};
    }
  }
  throw Failure({says::bad_plane, {{"axes", joined(axes)}, {"value", word}}});
}

}  // namespace axisc
