#include "axisc/answers/explain/explain_answer.hpp"

namespace axisc::says {

constexpr Sentence word_computed{"taken into account by plans of a path",
                                 "in Plänen einer Bahn berücksichtigt"};
constexpr Sentence word_accepted{"accepted: changes nothing that is planned",
                                 "angenommen: ändert nichts Geplantes"};
constexpr Sentence word_refused{"refused by `simulate` (AX9008)", "wird von `simulate` abgelehnt (AX9008)"};
constexpr Sentence word_in_block{"counts in its block", "gilt in seinem Satz"};
constexpr Sentence word_modal{"counts until another word changes it", "gilt, bis ein anderes Wort es ändert"};
constexpr Sentence word_facts{"{use}; {reach}", "{use}; {reach}"};
constexpr Sentence word_form{"Written as `{form}`.", "Schreibweise: `{form}`."};
constexpr Sentence word_source{"Source: {address}", "Quelle: {address}"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

Symbol use_of(schema::MotionWord const& word) {
  switch (word.use) {
    case schema::WordUse::computed: return {"computed", says::word_computed};
    case schema::WordUse::accepted: return {"accepted", says::word_accepted};
    case schema::WordUse::refused: break;
  }
  return {"refused", says::word_refused};
}

}  // namespace

Document word_answer(schema::MotionWord const& word) {
  bool const is_block = word.reach == schema::WordReach::block;
  Symbol const use = use_of(word);
  Symbol const reach{is_block ? "block" : "modal", is_block ? says::word_in_block : says::word_modal};
  Wording const meaning{std::string(word.meaning.in(Language::english)),
                        std::string(word.meaning.in(Language::german))};
  auto const address = word.source.empty() ? std::string() : schema::address_of(word.source);
  Table table{.key = "words", .audience = Audience::programs};
  add_row(table, {data("word", word.word), data("form", word.form), data("use", use), data("reach", reach),
                  data("page", meaning), data("source", address.empty() ? Value() : Value(address))});
  Document answer{
      .version = 3,
      .title = as_given(word.word),
      .blocks = {Paragraph{Words(says::word_facts, {{"use", use.words}, {"reach", reach.words}})},
                 Paragraph{word.meaning}, Paragraph{Words(says::word_form, {{"form", word.form}})}},
      .csv_table = "words"};
  if (!address.empty()) {
    // Of the catalogue's own making: a link.
    answer.blocks.emplace_back(Paragraph{Words(says::word_source, {{"address", Wording(address)}})});
  }
  answer.blocks.emplace_back(std::move(table));
  return answer;
}

}  // namespace axisc
