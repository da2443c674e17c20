#include "docs/tools/image_format_doc.hpp"

#include <array>
#include <initializer_list>
#include <string_view>

namespace axisc::docs {
namespace {

struct RecordRow {
  std::string_view name;
  unsigned size;
  std::string_view meaning;
};

struct FieldRow {
  std::string_view record;
  std::string_view name;
  std::string_view type;
  unsigned offset;
  std::string_view meaning;
};

struct SectionRow {
  std::string_view name;
  unsigned kind;
  std::string_view record;
  std::string_view flags;
  std::string_view meaning;
};

#define AXIM_FIELD(record, field, type, offset, meaning)
#define AXIM_SECTION(name, kind, record, flags, meaning)
#define AXIM_RECORD(record, size, meaning) RecordRow{#record, (size), (meaning)},
constexpr std::array records = {
#include "runtime/format/fields.inc"
};
#undef AXIM_RECORD
#undef AXIM_FIELD

#define AXIM_RECORD(record, size, meaning)
#define AXIM_FIELD(record, field, type, offset, meaning) \
  FieldRow{#record, #field, #type, (offset), (meaning)},
constexpr std::array fields = {
#include "runtime/format/fields.inc"
};
#undef AXIM_FIELD
#undef AXIM_SECTION

#define AXIM_FIELD(record, field, type, offset, meaning)
#define AXIM_SECTION(name, kind, record, flags, meaning) \
  SectionRow{#name, (kind), #record, #flags, (meaning)},
constexpr std::array sections = {
#include "runtime/format/fields.inc"
};
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION

constexpr std::string_view introduction =
    R"(<!-- Made from runtime/format/fields.inc by docs/tools/image_format_doc.cpp; change those. -->
# The coefficient image, format version 1.0

`axisc compile` writes a coefficient image (`.axim`), the runtime executes it. This page describes every byte. It is
made from the table from which the writer and the loader take their offsets, so it cannot disagree with them.

## Conventions

- Little-endian on every processor. `u16`, `u32` and `u64` are unsigned, `f64` is an IEEE 754 double, `u8xN` are N
  bytes. Fields stand at their offset without any padding; reserved bytes are 0.
- Offsets of sections count from the start of the image, indices of records from 0 in their section.
- The image is never written to and may lie in read-only memory, at an address that is a multiple of 64.
- Texts are UTF-8 without terminators; `..._offset` and `..._size` give a range of the names section. Each distinct text
  is stored once, in the order of first use (axes, lists, values: the name before the value). An empty text is 0, 0.
- Ranges of records are a first index and a count. An empty range is 0, 0.
- Checksums are CRC-32C: polynomial 0x1EDC6F41, bits reflected, initial value and final complement 0xFFFFFFFF; the checksum
  of the characters `123456789` is 0xE3069283.
- Equal machines give equal bytes: nothing in an image tells when, where, from which folder or by which build it was made.

## Layout

    0                      header
    128                    section table, one entry per section
    next multiple of 64    sections, each at a multiple of 64, in the order of the list below

Bytes between the end of a section (or of the section table) and the next multiple of 64 are 0, behind the last section
too: the total size is a multiple of 64. The header's checksum covers header and section table, with its own field as
zero; the payload's checksum covers every byte behind the section table, those zeros included, so it is computed first.

A stripped image (`compile --strip`) has the mandatory sections only; fields that point into the others are 0. Any other
image has all of them, empty ones too.

A reader finds sections by their kind. It accepts a higher minor version: unknown optional sections are skipped, records
may be longer than it knows (`element_size`), and an unknown mandatory section is refused. It refuses another major
version.

)";

constexpr std::string_view interpretation =
    R"(## How a filter is computed

Transfer functions are written `H(z) = (b0 + b1 z^-1 + b2 z^-2) / (1 + a1 z^-1 + a2 z^-2)`. The image holds each
second-order section in increment form, every coefficient rounded once from extended precision:

    k = 1 + a1 + a2                                   b = 1 - a2
    H(1) = 1:  H - 1 = (p + q z^-1)(1 - z^-1) / A     p = b0 - 1     q = p + b1 - a1
    H(1) = 0:  H     = (p + q z^-1)(1 - z^-1) / A     p = b0         q = b0 + b1       (blocks_constant)

Back to the usual form: `a2 = 1 - b`, `a1 = k + b - 2`; with H(1) = 1 `b0 = 1 + p`, `b1 = q - p + a1`,
`b2 = k - b0 - b1`; with H(1) = 0 `b0 = p`, `b1 = q - p`, `b2 = -q`. For display that is good enough; computing with it
loses seven digits where the cut-off frequency is low and the position large.

Each cycle, with `x` the filter's input and `d = x[n] - x[n-1]`, for the sections in their order:

    de = p d + r
    e  = e + de
    r  = de + q d - k e - b de
    d  = d + de        sum = sum + e       (H(1) = 1; behind the last section y = x + sum)
    d  = de            y = e               (blocks_constant)

At rest every state is 0, whatever the position: a reset sets `e = r = 0` and `x[n-1] = x`. A section may be used when
k > 0, 0 < b < 2, 4 - k - 2b > 0 (its poles lie inside the unit circle) and |p|, |q| <= 64. A first-order section has
a pole at 0: `b = 1`.

A pure delay (`realisation` 2) gives `y[n] = x[n - delay_cycles]`. The share blends the filter's output with its input:

    out = x + share (y - x)                         sections with H(1) = 1
    out = share y + (direct + direct_low) x         sections with H(1) = 0
    out = y + (direct + direct_low)(x - y)          a pure delay

The filters of an axis act one after the other in the order of their records.

Filters with equal sections share one run of coefficient records: a filter whose whole list of sections is already
stored points there, otherwise its sections are appended. Samples of self-tests are shared in the same way.

## Self-tests

A filter's samples start from the steady state for 0: no state, `x[-1] = 0`. The expected output is that of the stored
coefficients, computed in extended precision and rounded once, share included. Processors may contract multiplication
and addition, so an output may be off by 2 ulp of the largest input of the sequence; one that is off by more must not
move an axis. The compiler chooses this input: with a = 1/64, 8 samples of a; for i = 1 to 16 the samples (-1)^i a i/16; then
7 + `delay_cycles` samples of 0; last a 1. Where double arithmetic, with or without contraction, would use up more than half of
the tolerance, a is (64 - j)/4096 with the smallest j > 0 for which it does not.

## Proof records

`pole_radius`, `dc_gain`, `group_delay` and `delay_cycles` of the axis come from the design in extended precision.
`peak_gain` and `overshoot` come from the step response of the stored coefficients in double, in the same order of
operations on every host, followed until it has settled, for 2^21 cycles at most.

## What a loader refuses

Each with a status of its own: fewer bytes than a header, another magic, another major version, a size that
is not the given one, wrong checksums, sections outside the image, overlapping or unaligned sections, an unknown mandatory
section, counts and indices outside their section, numbers that are not finite, sections that may be unstable, delays beyond
100 cycles, unknown kinds, a cycle time of 0 or above 1 s. `runtime/include/axisrt.h` names them.
)";

std::string table_row(std::initializer_list<std::string_view> cells) {
  std::string row = "|";
  for (std::string_view const cell : cells) row.append(" ").append(cell).append(" |");
  return row += '\n';
}

std::string section_list() {
  std::string text = "## Sections\n\n";
  text += table_row({"kind", "section", "record", "reader", "meaning"});
  text += table_row({"--:", "---", "---", "---", "---"});
  for (SectionRow const& section : sections) {
    text += table_row(
        {std::to_string(section.kind), section.name, section.record, section.flags, section.meaning});
  }
  return text + "\n";
}

std::string record_description(RecordRow const& record) {
  std::string text = "### " + std::string(record.name) + ", " + std::to_string(record.size) +
                     (record.size == 1 ? " byte\n\n" : " bytes\n\n") + std::string(record.meaning) + "\n\n";
  bool has_fields = false;
  for (FieldRow const& field : fields) {
    if (field.record != record.name) continue;
    if (!has_fields) {
      text += table_row({"offset", "type", "field", "meaning"});
      text += table_row({"--:", "---", "---", "---"});
      has_fields = true;
    }
    text += table_row({std::to_string(field.offset), field.type, field.name, field.meaning});
  }
  return has_fields ? text + "\n" : text;
}

}  // namespace

std::string image_format_document() {
  std::string text(introduction);
  text += section_list();
  text += "## Records\n\n";
  for (RecordRow const& record : records) text += record_description(record);
  text += interpretation;
  return text;
}

}  // namespace axisc::docs
