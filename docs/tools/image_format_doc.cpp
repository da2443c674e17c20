#include "docs/tools/image_format_doc.hpp"

#include "design/readings.hpp"
#include "docs/tools/bounds_text.hpp"

#include <array>
#include <initializer_list>
#include <span>
#include <string>
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
# The coefficient image, format version 1.2

`axisc compile` writes a coefficient image (`.axim`), the runtime executes it. This page describes every byte. It is
made from the table from which the writer and the loader take their offsets, so it cannot disagree with them.

## Conventions

- Little-endian on every processor. `u16`, `u32` and `u64` are unsigned, `f64` is an IEEE 754 double, `u8xN` are N
  bytes. Fields are at their offset without any padding; reserved bytes are 0.
- Offsets of sections count from the start of the image, indices of records from 0 in their section.
- The image is never written to and may lie in read-only memory, at an address that is a multiple of 64.
- Texts are UTF-8 without terminators; `..._offset` and `..._size` give a range of the names section. Each distinct text
  is stored once, in the order of first use (axes, groups, lists, values: the name before the value). An empty text is 0, 0.
- Ranges of records are a first index and a count. An empty range is 0, 0.
- Checksums are CRC-32C: polynomial 0x1EDC6F41, bits reflected, initial value and final complement 0xFFFFFFFF; the checksum
  of the characters `123456789` is 0xE3069283.
- Equal machines give equal bytes: an image does not show when, where, from which folder or by which build it was made.

## Layout

    0                      header
    128                    section table, one entry per section
    next multiple of 64    sections, each at a multiple of 64, in the order of the list below

Bytes between the end of a section (or of the section table) and the next multiple of 64 are 0, also after the last
section: the total size is a multiple of 64. The header's checksum covers header and section table, with its own field as
zero; the payload's checksum covers every byte after the section table, those zeros included, so it is computed first.

A signed image (`axisc sign`) has a trailer of 80 bytes after its last byte, at total_size. It is not part of the image:
the header does not know it, and cutting it off gives the unsigned image again. A reader without a key ignores it; it
refuses any other bytes there.

Mandatory sections are in every image, empty ones too. Critical sections are present if they have records. Of the optional
sections `names` to `values` are either all present, empty ones too, or all absent: a stripped image (`compile --strip`) has none
of them, and fields that point into them are 0. `bounds` is there or not for itself.

A reader finds sections by their kind. It accepts a higher minor version: unknown sections are skipped where their flags
say optional, and records may be longer than it knows (`element_size`). It refuses an image with an unknown section
that is not optional, since the axes would move in another way without it; that is what a reader of format 1.0 does with
an image that has critical sections. It refuses another major version.

Format 1.1 added the critical sections. An image without them has the bytes of format 1.0, except for the minor version.
Format 1.2 added Vibration Guard (kernels of type 5, slots of family 3, bit 5 of a bank's keywords), which readers of 1.1
refuse, and the section `bounds`, which they skip. An image without both has the bytes and the number of format 1.1.

)";

constexpr std::string_view interpretation =
    R"(## How a filter is computed

Transfer functions are written `H(z) = (b0 + b1 z^-1 + b2 z^-2) / (1 + a1 z^-1 + a2 z^-2)`. The image holds each
second-order section in increment form, every coefficient rounded once from extended precision:

    k = 1 + a1 + a2                                   b = 1 - a2
    H(1) = 1:  H - 1 = (p + q z^-1)(1 - z^-1) / A     p = b0 - 1     q = p + b1 - a1
    H(1) = 0:  H     = (p + q z^-1)(1 - z^-1) / A     p = b0         q = b0 + b1       (blocks_constant)

Back to the usual form: `a2 = 1 - b`, `a1 = k + b - 2`; with H(1) = 1 `b0 = 1 + p`, `b1 = q - p + a1`,
`b2 = k - b0 - b1`; with H(1) = 0 `b0 = p`, `b1 = q - p`, `b2 = -q`. This is good enough for display; computing with it
loses seven digits where the cut-off frequency is low and the position large.

Each cycle, with `x` the filter's input and `d = x[n] - x[n-1]`, for the sections in their order:

    de = p d + r
    e  = e + de
    r  = de + q d - k e - b de
    d  = d + de        sum = sum + e       (H(1) = 1; after the last section y = x + sum)
    d  = de            y = e               (blocks_constant)

At rest every state is 0, whatever the position: a reset sets `e = r = 0` and `x[n-1] = x`. A section may be used when
k > 0, 0 < b < 2, 4 - k - 2b > 0 (its poles are inside the unit circle) and |p|, |q| <= 64. A first-order section has
a pole at 0: `b = 1`.

A pure delay (`realisation` 2) gives `y[n] = x[n - delay_cycles]`. The share blends the filter's output with its input:

    out = x + share (y - x)                         sections with H(1) = 1
    out = share y + (direct + direct_low) x         sections with H(1) = 0
    out = y + (direct + direct_low)(x - y)          a pure delay

The filters of an axis act one after the other in the order of their records; an HSC kernel acts before them, a FIR
kernel after them.

Filters with equal sections share one run of coefficient records: a filter whose whole list of sections is already
stored points there, otherwise its sections are appended. Samples of self-tests are shared likewise.

## How a kernel is computed

A linear-phase kernel with the causal taps b_0, b_1, ... is stored as tail sums `S_j = sum of b_k over k > j`, each rounded
once from extended precision. The taps follow from them: `b_0 = 1 - S_0`, `b_j = S_(j-1) - S_j`, the last one is the last
tail sum. Each cycle, with `d[n] = x[n] - x[n-1]`:

    E = S_0 d[n] + S_1 d[n-1] + ...        y = x - E

So the taps sum to 1 by construction, and at rest y = x exactly, whatever was rounded: a reset sets all d to 0. A symmetric
kernel has 2h tail sums and a delay of h cycles, a time delay as many tail sums as cycles, each of them its share (1 at
100 %). The share of a symmetric kernel is in its tail sums. |S_j| <= 64, at most 200 of them, of Vibration Guard 960. After an HSC kernel
the filters compute with `d = d - (E[n] - E[n-1])`.

Equal kernels are stored once, in the order of first use: by slots the lists' values, then by groups, banks and members. What
a type ignores has its default (frequency 30, quality 1), so that it makes no difference; NoVib has the order that its
frequency gives. Order 0 or share 0 means no kernel.

A kernel with an even number of taps, or one that blends with the undelayed signal, is stored in the same way with
`half_width` 0 and as many `delay_cycles` as tail sums; `group_delay` is its delay at 0 Hz.

A slot is the one linear-phase filter that an axis may have. `kernel` is that of the lists' values; it works from start-up
where `on_at_start` is 1. A slot remembers as many increments as its longest kernel needs (`history`), so that each of
its kernels can begin at any time.

## Channels, banks and fades

A group is an NC channel with its axes (members) and its banks: for each set of #FILTER parameters one kernel for each
member, in the order of the members (choices). Bank 0 holds the lists' values (no keyword); the parameter sets
follow in the order of the machine file, last the bank of HSC, if an axis has an HSC filter. A bank concerns the FIR
slots, that of HSC (bit 4) the HSC slots; the other members, and members without a slot, have the choice none. A slot
belongs to the first group that names its axis; groups without a slot are not stored.

    #FILTER ON [...]     the bank's kernels, switched on
    #FILTER [...]        those of the bank with the last one's parameters and these, for the slots that are on
    #FILTER OFF          no kernel, FIR and HSC
    end of the program   as at start-up; its fade is the longer one of bank 0 and of OFF, standstill if one of them needs it

All slots that a command reaches change over together. While every slot of the group has seen no increment of 2^-30 units or
more for as many cycles as it remembers, the change is immediate. Otherwise it takes F = `fade_cycles` from kernel A to
kernel B, with the same increments for both:

    E = E_A + w (E_B - E_A)        w = t^3 (10 - 15 t + 6 t^2)        t = 1/F, 2/F, ... 1

|w'| is at most 15/(8F), |w''| at most 10/(sqrt(3) F^2). With the axis' largest velocity v and acceleration a per cycle
(P-AXIS-00212 and P-AXIS-00008) and `L = g sum of |S_A - S_B|`, g the peak gain of the axis' other filters, |B - A| is at
most L v and changes by at most L a in a cycle. F is the smallest number for which the fade adds at most a quarter of the
limits:

    15/(8F) L v <= v/4        10/(sqrt(3) F^2) L v + 15/(4F) L a <= a/4

A is the worst kernel that the slot can be at, and of all slots that a bank concerns, the largest F counts, at least 1. It
is 0, at standstill only, where one of them would need more than 4096 cycles or has no limits.

## Improved Position Control

Each cycle, for the stages of an axis, with the velocity that `mode` names through the stage's filters in series:

    v_add = - sum of weight * stage        weight = min(weight_numerator / weight_denominator, 7)
    v_add = limit with the sign of v_add, where |v_add| > limit        limit = limit_factor/1000 * v_max
    increments = scale * v_add

with v_max the axis' `velocity_limit`. A gantry slave has no stages: it takes the `v_add` of its `source`, with its own
scale; its `limit` is that of the source. The scale is rounded once:

    controller 1    v_reso_num / v_reso_denom * (60 | 1 | T in s)        for time_base 0, 1, 2
    controller 2    6e-5 * multi_gain_z / multi_gain_n
    controller 0    0

The oscillator in front of a stage of mode 2 or 3 is `w0^2 / (s^2 + 2 D w0 s + w0^2)` by the bilinear transform,
pre-warped at `frequency`; D is in `quality`; its `prototype` 1 and `order` 2 have no meaning.

## Self-tests

A filter's samples start from the steady state for 0: no state, `x[-1] = 0`. The expected output is that of the stored
coefficients, computed in extended precision and rounded once, share included. Processors may contract multiplication
and addition, so an output may be off by 2 ulp of the largest input of the sequence; one that is off by more must not
move an axis. The compiler chooses this input: with a = 1/64, 8 samples of a; for i = 1 to 16 the samples (-1)^i a i/16; then
7 + `delay_cycles` samples of 0; last a 1. Where double arithmetic, with or without contraction, would use up more than half of
the tolerance, a is (64 - j)/4096 with the smallest j > 0 for which it does not.

A kernel's samples are made in the same way, with as many zeros as the kernel has tail sums after the 7 and always with
a = 1/64. They are run without a fade, on any slot whose history is long enough. Samples are in the order of the axes'
filters, the stages' filters, the kernels.

## Proof records

`dc_gain`, `group_delay` and `delay_cycles` of the axis come from the design in extended precision, `pole_radius` from the stored
coefficients. `peak_gain` and `overshoot` come from the step response of the stored coefficients in double, in the same order of
operations on every host, followed until it has settled, for 2^21 cycles at most. With a kernel that works from start-up
the axis' `peak_gain` is the product of the chain's and the kernel's, its `delay_cycles` the sum.

`peak_gain` is true for the recursion in real numbers on the stored coefficients: it is the sum of |h| over the cycles that were
followed, a bound of what rounding may have taken from it, and a bound of all that the states can still put out. Where 2^21 cycles
do not suffice (characteristic frequencies below some millionths of 1/T) the last one counts, and `peak_gain` may be several times
the largest amplification that a setpoint reaches; so may the product with a kernel's. `axisc inspect` then says "at most".
`overshoot` is that of the cycles followed.

Images of axisc 0.2.0 and before have the sum alone, without the bounds: usually by less than 2e-12 too low, far too low where the
filter is so slow. A loader refuses the grossest of them only, so compile such machines again.

## Bit for bit

Two runtimes that round every operation to a double give equal outputs if they follow this order of operations, which is that of
`axisrt` at level portable; [`axisrt_c.c`](../runtime/c99/axisrt_c.c) is written from it. Brackets and the order of terms count,
sums are added from the left, and nothing is contracted.

A setpoint that is not finite or beyond 2^53 is replaced by the one before; below 2^-500 it is +0. A signal is `base + sum`, with
its increment `d`. At the beginning of a chain `base = x[n]`, `sum = 0`, `d = x[n] - x[n-1]`; at its end `y = base + sum`. So the
size of a position enters one rounding only. Operations are, in the order of the chain, an HSC kernel, the filters, a FIR kernel
or guard. Filters that pass through, and delays of 0 cycles, are none; filters with H(1) = 1, share 1 and direct 0 that follow
each other are one, with the sections of all of them. `G(v) = (v + 2^-567) - 2^-567` brings a number back to multiples of 2^-620:
none gets subnormal.

Coefficients are taken as 0 where they are below a limit: p below 2^-44, k, b, `g = p + q`, share, direct, weights and scales
below 2^-62, `direct_low` below 2^-108, tail sums below 2^-128. A section with its states e and r, where r is kept as R = r +
2^-567:

    de = p d + (R - 2^-567)        e = e + de        R = R + ((g d - k e) - b de)

After every third section of an operation d becomes G(d).

    sections, H(1) = 1      for each: sum = sum + e, d = d + de; after the last one sum = G(sum), d = G(d)
    the same, with a share  afterwards sum = share sum + direct sum_in, d = share d + direct d_in
    sections, H(1) = 0      for each: d = de; with e of the last one
                            (h, l) = direct base without loss; l = l + direct_low base
                            sum = G(share e + (direct sum + l)), d = G(share d + direct d_in), base = G(h)
    delay, of D cycles      with base_D, sum_D, d_D of D cycles ago
                            sum = G(share sum_D + direct ((base - base_D) + sum)), d = G(share d_D + direct d), base = base_D
    kernel                  E = G(E); sum = sum - E[n], d = d - (E[n] - E[n-1])

A chain that is nothing but 1, 2, 4 or 6 sections with H(1) = 1 and share 1 leaves its last sum and d as they are, without G.
"Without loss" is Dekker's product with the factor 2^27 + 1: `l = ((ah bh - h) + ah bl + al bh) + al bl`.

E is added up over a ring of increments whose length is `8 ((max(history, 1) + 6) / 8 + 1)` (whole division; 16 for 1), from place
0 on. Blocks of eight places count from the present one backwards; the increment in place i of a block goes into sum i mod 4 with
the tail sum of its age, and `E = (s0 + s1) + (s2 + s3)`. Moving averages are computed otherwise: with `s = S_0 / K` for K tail
sums, K > 1, a kernel is one if `|s (K - j) - S_j| <= 2^-50 |S_j|` for all of them. Time is cut into windows of K cycles, the
first begins at create:

    G = G - Q        Q = Q - d[n-K]        C = (C - P) + K d[n]        P = P + d[n]        E = s (C + G)

and after the last cycle of a window G = C, Q = P, C = P = 0. After a command the kernel is applied as the others are until the
fade is over; at the end of that cycle G = sum of (K - j) d[n-j] for j = 0, 1, ..., Q = sum of d[n-j], C = P = 0, and a window
begins. A fade begins with t = 1/F in the cycle after the command; `w = ((t t) t) (10 + t (6 t - 15))`, `E = E_A + w (E_B - E_A)`,
and its last cycle is E_B. A reset sets all of these states and the ring to 0 and ends a fade; windows and places go on.

States of sections that are tiny or run away are cleared: e = 0, R = 2^-567 unless 2^-500 <= |e| + |R| <= 2^200. They are looked
at in turn, after a cycle. Chains have the same form if their operations are of the same kinds, with as many sections, equal
delays and rings of equal length. Lines (axes, or stages) of one form are a batch, in their order. That holds for the first 32
forms, in the order of their first lines; of the other lines, in their order, those of one form that follow each other are a
batch. Each operation with N sections in all lines of a batch has a place among them, line by line, from the first one at create;
in every cycle the next N/6 sections, rounded up, are looked at, after the last one comes the first.

A reset to x (below 2^-500: 0) clears e, r and kernels, fills delays with the signal that reaches them, and leaves as the latest
output what the formulas give for d = 0. A shift of the origin by an offset adds, along the chain, the steady output for a
constant offset to what delays hold, base with its rounding error, which goes to sum, and to the latest input and output.

An output is implausible that moves by more than `G((P + 1/4) (velocity_limit 10 T))`, T = cycle_time_ns 1e-9, where the limit is
above 0. P is the axis' `peak_gain`; with a slot it is divided by that of the kernel that works from start-up and multiplied by
the largest one, at least 1, of all kernels with at most as many tail sums as the slot remembers (of all where that is more than
200).

Stages of mode 1 get the motor's velocity where there is no direct one. The sum of v_add begins at 0 and becomes G(v_add) before
it is limited. A command at standstill finds every increment below 2^-30 in the last max(history, 1) cycles.

## What a loader refuses

Each with a status of its own: fewer bytes than a header, another magic, another major version, bytes after
the image that are not a whole trailer, wrong checksums, sections outside the image, overlapping or unaligned sections, an unknown
section that is not optional, counts and indices outside their section, numbers that are not finite, sections that may be unstable, delays beyond
100 cycles and kernels beyond 200 tail sums, unknown kinds, a cycle time of 0 or above 1 s, and proofs that cannot be true: a
`pole_radius` outside 0 to 1, a `dc_gain` other than 1 (`direct` where the constant part is blocked), a `kernel_sum` other than 1, a
`peak_gain` that is not above 0 or is below `dc_gain` by more than a millionth of it (in an axis the product of its filters' `dc_gain`), a negative
`overshoot` or `tail_gain`. Records of `bounds` are complete and in order, their numbers finite and not negative, `gain_low` is at
most `gain_high`, which is not below H(1), and `radius_high` at most 1. Slot and member of an axis name
each other, choices fit into their slot's history, a gantry slave's source has stages of its own. Where a key is set, also an
image without a trailer and one whose signature is wrong. `runtime/include/axisrt.h` names them.
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

std::string rows(std::span<std::string_view const> words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += "| " + std::to_string(i) + " | `" + std::string(words[i]) + "` |\n";
  }
  return text;
}

std::string readings() {
  return "\n## Readings\n\n`reading` and `cycle_reading` say which departure from the manuals the "
         "coefficients were computed with\n([settings](settings.md), `design`). They are for people and "
         "tools: a runtime executes the coefficients.\n\n| `reading` of a filter | word of the settings "
         "|\n|--:|---|\n" +
         rows(design::filter_reading_words) +
         "\n| `reading` of a kernel | word of the settings |\n|--:|---|\n" +
         rows(design::kernel_reading_words) + "\n| `cycle_reading` | word of the settings |\n|--:|---|\n" +
         rows(design::cycle_reading_words);
}

}  // namespace

std::string image_format_document() {
  std::string text(introduction);
  text += section_list();
  text += "## Records\n\n";
  for (RecordRow const& record : records) text += record_description(record);
  text += interpretation;
  text += bounds_text;
  text += readings();
  return text;
}

}  // namespace axisc::docs
