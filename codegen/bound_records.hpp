// The section `bounds`: what holds for every input of the chains of an image.
#pragma once

#include "codegen/image_tables.hpp"

#include <cstddef>
#include <span>

namespace axisc::codegen {

/// Computes the records from the image without them, as anyone does who checks them. Equal chains are
/// computed once. Cost: that of runtime::bounds::BoundComputation for each different chain and kernel.
void add_bound_records(std::span<std::byte const> image, ImageTables& tables);

}  // namespace axisc::codegen
