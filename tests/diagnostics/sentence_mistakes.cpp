// Sentences that must not compile, one for each number; sentence_mistakes.cmake compiles them. Number 0 is
// right.
#include "diagnostics/sentence.hpp"

namespace axisc {

#if AXISC_MISTAKE == 0
constexpr Sentence sentence{"{count} of {limit_2}", "von {limit_2} sind es {count}"};
static_assert(sentence.in(Language::german).starts_with("von"));
#elif AXISC_MISTAKE == 1
constexpr Sentence sentence{"one", ""};
#elif AXISC_MISTAKE == 2
constexpr Sentence sentence{"one", "eins "};
#elif AXISC_MISTAKE == 3
constexpr Sentence sentence{"{count} of {limit}", "{count} von {grenze}"};
#elif AXISC_MISTAKE == 4
constexpr Sentence sentence{"one", "eins von {limit}"};
#elif AXISC_MISTAKE == 5
constexpr Sentence sentence{"{limit", "{limit"};
#elif AXISC_MISTAKE == 6
constexpr Sentence sentence{"{} and }", "{} und }"};
#elif AXISC_MISTAKE == 7
SentenceRef kept() {
  return Sentence{"one", "eins"};
}
#endif

}  // namespace axisc
