/* Constants of the image format, made from fields.inc: axim_header_... as enumerators. C and C++. */
#ifndef AXISRT_IMAGE_FORMAT_H
#define AXISRT_IMAGE_FORMAT_H

#include <stdint.h>

/* Instead of an index: no kernel, the setpoint passes unchanged. */
#define AXIM_NONE 0xFFFFFFFFu

enum {
  axim_major = 1,
  axim_minor = 2,
  axim_alignment = 64,
  axim_flag_optional = 1,
  axim_most_delay = 100,
  axim_most_sections = 6,
  axim_most_filters = 3,
  axim_most_interface_filters = 1,
  axim_most_stage_filters = 3,
  axim_most_stages = 3,
  axim_most_tails = 200,
  axim_most_guard_tails = 960,
  axim_most_fade_cycles = 4096,
  axim_most_samples = 1024,

  axim_keyword_order = 1,
  axim_keyword_share = 2,
  axim_keyword_fcut = 4,
  axim_keyword_quality = 8,
  axim_keyword_hsc = 16,
  axim_keyword_guard = 32,

  axim_family_hsc = 1,
  axim_family_fir = 2,
  axim_family_guard = 3,

  axim_kernel_guard = 5,

  axim_realisation_pass_through = 0,
  axim_realisation_sections = 1,
  axim_realisation_delay = 2,

  axim_port_setpoint = 0,
  axim_port_interface = 1,
  axim_port_velocity = 2,

  axim_bound_majorant = 1,

/* axim_<record>_size */
#define AXIM_RECORD(record, size, meaning) axim_##record##_size = (size),
#define AXIM_FIELD(record, field, type, offset, meaning)
#define AXIM_SECTION(name, kind, record, flags, meaning)
#include "runtime/format/fields.inc"
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION

/* axim_<record>_<field>_offset, in its record */
#define AXIM_RECORD(record, size, meaning)
#define AXIM_FIELD(record, field, type, offset, meaning) axim_##record##_##field##_offset = (offset),
#define AXIM_SECTION(name, kind, record, flags, meaning)
#include "runtime/format/fields.inc"
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION

/* axim_kind_<section> */
#define AXIM_RECORD(record, size, meaning)
#define AXIM_FIELD(record, field, type, offset, meaning)
#define AXIM_SECTION(name, kind, record, flags, meaning) axim_kind_##name = (kind),
#include "runtime/format/fields.inc"
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION

  axim_format_end_ = 0
};

#endif
