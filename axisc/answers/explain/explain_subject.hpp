// What the user of `explain` named.
#pragma once

#include "schema/catalogue.hpp"
#include "schema/motion_words.hpp"
#include "validator/engine/rule.hpp"

#include <span>
#include <string>
#include <vector>

namespace axisc {

struct ExplainSubject {
  std::vector<validator::Rule const*> rules;
  std::vector<validator::Rule const*> foretelling;  ///< the word is a message of the control that they name
  schema::MotionWord const* motion_word = nullptr;  ///< of an NC program
  std::vector<schema::Parameter const*> parameters;
  bool is_searched = false;  ///< `parameters` are those that contain the word
};

/// The first catalogue is that of axis lists. Failure for a word that means nothing.
[[nodiscard]] ExplainSubject explain_subject(std::span<schema::Catalogue const> catalogues,
                                             std::string const& word);

}  // namespace axisc
