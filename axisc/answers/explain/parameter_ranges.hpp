// Ranges of filter parameters, which depend on the type of the filter and on the NC cycle time T.
#pragma once

#include "presentation/value.hpp"
#include "schema/catalogue.hpp"

#include <vector>

namespace axisc {

/// "1 ≤ value < 6 T": an end that is Nothing is left out. One of the ends is there.
[[nodiscard]] presentation::Words range_words(presentation::Value lowest, bool excludes_lowest,
                                              presentation::Value highest, bool excludes_highest);

struct TypeRange {
  presentation::Names types;  ///< as lists write them, or the family of filters
  presentation::Words range;
};

/// By rising number of the type; types of one range together. Empty for parameters without such ranges.
[[nodiscard]] std::vector<TypeRange> ranges_by_type(schema::Parameter const& parameter);

}  // namespace axisc
