// Records of linear-phase kernels, slots, channels and banks.
#pragma once

#include "codegen/image_tables.hpp"
#include "codegen/kernel_plan.hpp"

namespace axisc::codegen {

void add_kernel_records(KernelPlan const& plan, CompiledKernels const& kernels, bool strip,
                        ImageTables& tables);

}  // namespace axisc::codegen
