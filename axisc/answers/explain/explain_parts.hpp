// Parts of what `explain` answers.
#pragma once

#include "axisc/answers/explain/search.hpp"
#include "presentation/document.hpp"
#include "schema/catalogue.hpp"
#include "schema/lookup/lookup.hpp"
#include "validator/engine/rule.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace axisc::says {

/// A version of axisc.
inline constexpr Sentence since{"since", "seit"};

}  // namespace axisc::says

namespace axisc {

/// Of all kinds of lists, those of axes first.
[[nodiscard]] std::vector<schema::Catalogue> catalogues_of(schema::Catalogue const& of_axes);

/// A message of the control. Without a row it is only known that `foretelling` are about it.
[[nodiscard]] presentation::Section message_section(std::uint32_t number,
                                                    schema::ControlMessage const* message,
                                                    std::span<validator::Rule const* const> foretelling);
[[nodiscard]] presentation::Section topic_section(schema::Topic const& topic,
                                                  std::span<schema::Catalogue const> catalogues);

/// One row for each: kind, name, another name, and meaning.
[[nodiscard]] presentation::Table subjects_table(std::string key, std::span<Subject const> subjects);
[[nodiscard]] std::vector<Subject> subjects_of(std::span<Hit const> hits);

/// The version of axisc that had the rule first.
[[nodiscard]] presentation::Value version_of(validator::Rule const& rule);

/// The first sentence of a page, without emphasis.
[[nodiscard]] Wording first_sentence(Page const& page);

}  // namespace axisc
