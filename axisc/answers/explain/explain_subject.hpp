// What the user of `explain` named.
#pragma once

#include "axisc/answers/explain/search.hpp"
#include "schema/catalogue.hpp"
#include "schema/lookup/lookup.hpp"
#include "schema/motion_words.hpp"
#include "validator/engine/rule.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

struct ExplainSubject {
  std::vector<validator::Rule const*> rules;
  std::optional<std::uint32_t> number;  ///< of a message of the control
  schema::ControlMessage const* message = nullptr;
  std::vector<validator::Rule const*> foretelling;  ///< that name this message
  schema::MotionWord const* motion_word = nullptr;  ///< of an NC program
  schema::Topic const* topic = nullptr;
  std::vector<schema::Parameter const*> parameters;
  std::string read_as;    ///< what was named has a typing error: what was meant
  std::vector<Hit> hits;  ///< of a search: others, or all where none of the above is the answer

  [[nodiscard]] bool is_found() const {
    return !rules.empty() || number || motion_word != nullptr || topic != nullptr || !parameters.empty();
  }
};

/// Something that was named as programs name it, or else a search; for words that mean nothing neither a
/// subject nor hits. The first catalogue is that of axis lists.
[[nodiscard]] ExplainSubject find_subject(std::span<schema::Catalogue const> catalogues,
                                          std::string const& text);

/// The same, with a Failure for words that mean nothing, which says what may have been meant.
[[nodiscard]] ExplainSubject explain_subject(std::span<schema::Catalogue const> catalogues,
                                             std::string const& text);

/// A name of `see` in a topic: a parameter, P-AXIS-00140, a code, the number of a message, a word of NC
/// programs or another topic.
[[nodiscard]] std::optional<Subject> subject_named(std::span<schema::Catalogue const> catalogues,
                                                   std::string_view name);

}  // namespace axisc
