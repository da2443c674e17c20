// Codes, numbers and names of parameters as people write them.
#pragma once

#include "axisc/answers/explain/explain_subject.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// By code ("AX3005", "ax3005", "3005") or name ("delay-too-long"); null for others.
[[nodiscard]] validator::Rule const* rule_named(std::string const& word);

/// Rows with the number in "P-AXIS-00140" or "P-CHAN-00035". The number may stand alone for a parameter of
/// axes; zeros in front may be missing.
[[nodiscard]] std::vector<schema::Parameter const*> rows_of_number(
    std::span<schema::Catalogue const> catalogues, std::string const& word);

/// Those of axis lists, else of the other kinds: several of them may know one name. `filter[2].order` and
/// `filter[].order` name the same row.
[[nodiscard]] std::vector<schema::Parameter const*> rows_of_name(
    std::span<schema::Catalogue const> catalogues, std::string const& word);

/// Rules that name the number of the message.
[[nodiscard]] std::vector<validator::Rule const*> rules_foretelling(std::string_view number);

/// The topic about a command as programs write it, "#FILTER ON [ORDER=40]", or of that name; null for others.
[[nodiscard]] schema::Topic const* topic_named(std::string_view text);

}  // namespace axisc
