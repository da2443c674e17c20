// Values that the catalogue allows, for the lists of the generator.
#pragma once

#include "lists/generator.hpp"
#include "lists/random.hpp"
#include "schema/catalogue.hpp"

#include <optional>

namespace axisc::bench {

/// False for parameters that depend on others, so that a random value would be a mistake: filters, limits
/// that other parameters give, what names or links axes.
[[nodiscard]] bool is_free(schema::Parameter const& parameter);

/// A value of a free parameter, as a list writes it.
[[nodiscard]] Entry random_entry(schema::Parameter const& parameter, schema::Slot slot, Random& random);

}  // namespace axisc::bench
