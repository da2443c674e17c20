#include "axisc/settings/glob.hpp"

#include <vector>

namespace axisc {

bool matches_glob(std::string_view pattern, std::string_view path) {
  // fits[j]: the pattern read so far fits the first j characters of the path.
  std::vector<bool> fits(path.size() + 1, false);
  fits[0] = true;
  for (std::size_t i = 0; i < pattern.size();) {
    std::vector<bool> next(path.size() + 1, false);
    bool const folders = pattern.substr(i, 3) == "**/";
    bool const anything = pattern.substr(i, 2) == "**";
    if (folders || anything) {
      bool reached = false;
      for (std::size_t j = 0; j <= path.size(); ++j) {
        bool const at_name = anything && !folders ? true : j == 0 || path[j - 1] == '/';
        next[j] = fits[j] || (reached && at_name);
        reached = reached || fits[j];
      }
      i += folders ? 3 : 2;
    } else if (pattern[i] == '*') {
      for (std::size_t j = 0; j <= path.size(); ++j) {
        next[j] = fits[j] || (j > 0 && next[j - 1] && path[j - 1] != '/');
      }
      ++i;
    } else {
      for (std::size_t j = 1; j <= path.size(); ++j) {
        bool const same = pattern[i] == '?' ? path[j - 1] != '/' : pattern[i] == path[j - 1];
        next[j] = fits[j - 1] && same;
      }
      ++i;
    }
    fits = std::move(next);
  }
  return fits[path.size()];
}

}  // namespace axisc
