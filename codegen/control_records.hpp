// Records of Improved Position Control.
#pragma once

#include "codegen/filter_records.hpp"
#include "codegen/image_tables.hpp"
#include "configuration/machine/machine.hpp"

namespace axisc::codegen {

/// A control for each axis with active stages and for each gantry slave of one. To be called when the filters
/// of all axes are in their tables: those of the stages follow.
void add_control_records(machine::Machine const& machine, FilterRecords& filters, ImageTables& tables);

}  // namespace axisc::codegen
