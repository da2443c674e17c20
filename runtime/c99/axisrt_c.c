/* axisrt_c: see axisrt_c.h. The formulas are those of docs/image-format.md, in the order of operations that
 * it prescribes, with the letters that it uses. */
#include "axisrt_c.h"

#include <float.h>
#include <string.h>

/* Every operation is rounded to a double, and none is merged with another: otherwise outputs would depend on
 * the processor. 32-bit x86 needs SSE2 (-msse2 -mfpmath=sse, /arch:SSE2). */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "no -ffast-math and no /fp:fast"
#elif (defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 2)) || \
    (defined(_M_IX86_FP) && _M_IX86_FP < 2)
#error "doubles are not computed as doubles"
#endif
#if defined(__clang__)
#pragma clang fp contract(off)
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#else
#pragma STDC FP_CONTRACT OFF
#endif

#define NONE 0xFFFFFFFFu

/* ---- numbers ----------------------------------------------------------------------------------- */

#define LARGEST_POSITION 9007199254740992.0        /* 2^53 */
#define SMALLEST_POSITION 3.054936363499605e-151   /* 2^-500 */
#define SMALLEST_NUMERATOR 5.684341886080802e-14   /* 2^-44 */
#define SMALLEST_COEFFICIENT 2.168404344971009e-19 /* 2^-62 */
#define SMALLEST_REST 3.0814879110195774e-33       /* 2^-108 */
#define SMALLEST_TAIL 2.938735877055719e-39        /* 2^-128 */
#define SMALLEST_STATE 3.054936363499605e-151      /* 2^-500 */
#define LARGEST_STATE 1.6069380442589903e+60       /* 2^200 */
#define GRID 2.070105401319524e-171                /* 2^-567 */
#define MOTION 9.313225746154785e-10               /* 2^-30 */
#define HALF_ULP 1.1102230246251565e-16            /* 2^-53 */

static uint64_t bits_of(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

static double double_of(uint64_t bits) {
  double x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

static uint64_t magnitude_bits(double x) {
  return bits_of(x) & (~(uint64_t)0 >> 1);
}

static double magnitude(double x) {
  return double_of(magnitude_bits(x));
}

/* |x| <= limit; compared as integers, so that NaN raises no flag. */
static int is_within(double x, double limit) {
  return magnitude_bits(x) <= bits_of(limit);
}

static int is_finite(double x) {
  return is_within(x, DBL_MAX);
}

static double unless_below(double limit, double x) {
  return is_within(x, limit) && magnitude(x) != limit ? 0 : x;
}

static double on_grid(double x) {
  return (x + GRID) - GRID;
}

/* high + low is the product, without loss (T. J. Dekker, 1971). */
static void exact_product(double a, double b, double* high, double* low) {
  double const shift = 134217729; /* 2^27 + 1 */
  double const a_shifted = shift * a, b_shifted = shift * b;
  double const a_high = a_shifted - (a_shifted - a), b_high = b_shifted - (b_shifted - b);
  double const a_low = a - a_high, b_low = b - b_high;
  *high = a * b;
  *low = (a_high * b_high - *high) + a_high * b_low + a_low * b_high + a_low * b_low;
}

/* ---- the image: its sections ------------------------------------------------------------------- */

/* Kinds of sections as the format numbers them; samples of self-tests are kind 17 there. */
enum { AXES = 1, FILTERS, COEFFICIENTS, KERNELS, TAILS, SLOTS, GROUPS, MEMBERS, BANKS, CHOICES };
enum { CONTROLS = CHOICES + 1, STAGES, SAMPLES, KINDS };

static uint32_t const record_size[KINDS] = {0, 128, 192, 32, 128, 8, 32, 32, 4, 64, 4, 128, 64, 16};

/* Offsets of fields in their records. */
enum { axis_first_filter = 20, axis_filter_count = 24, axis_first_interface_filter = 28 };
enum { axis_interface_filter_count = 32, axis_position_window = 40, axis_velocity_limit = 48 };
enum { axis_peak_gain = 64 };
enum { filter_realisation = 12, filter_blocks_constant = 20, filter_first_section = 24 };
enum { filter_section_count = 28, filter_delay_cycles = 32, filter_share = 48, filter_direct = 56 };
enum { filter_direct_low = 64, filter_first_sample = 152, filter_sample_count = 156 };
enum { kernel_type = 0, kernel_first_tail = 16, kernel_tail_count = 20, kernel_first_sample = 24 };
enum { kernel_sample_count = 28, kernel_peak_gain = 72 };
enum { slot_axis = 0, slot_family = 4, slot_kernel = 12, slot_on_at_start = 16, slot_history = 20 };
enum { slot_group = 24, slot_member = 28 };
enum { group_first_member = 8, group_member_count = 12, group_first_bank = 16, group_bank_count = 20 };
enum { group_off_fade_cycles = 24 };
enum { bank_keywords = 0, bank_order = 4, bank_share = 8, bank_frequency = 16, bank_quality = 24 };
enum { bank_first_choice = 32, bank_fade_cycles = 36 };
enum { control_axis = 0, control_source = 4, control_first_stage = 8, control_stage_count = 12 };
enum { control_limit = 24, control_scale = 32 };
enum { stage_mode = 4, stage_first_filter = 8, stage_filter_count = 12, stage_weight = 16 };
enum { REALISATION_SECTIONS = 1, REALISATION_DELAY = 2, FAMILY_HSC = 1, FAMILY_FIR = 2, FAMILY_GUARD = 3 };
enum { KERNEL_GUARD = 5, KEYWORD_HSC = 16, KEYWORD_GUARD = 32, MOST_TAILS = 200, MOST_GUARD_TAILS = 960 };

typedef struct image_view {
  uint32_t cycle_time_ns;
  struct {
    const uint8_t* first;
    uint32_t count, stride;
  } table[KINDS];
} image_view;

static uint32_t u32(const uint8_t* at) {
  return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static uint64_t u64(const uint8_t* at) {
  return u32(at) | (uint64_t)u32(at + 4) << 32;
}

static double f64(const uint8_t* at) {
  return double_of(u64(at));
}

static uint32_t count_of(const image_view* v, int kind) {
  return v->table[kind].count;
}

static const uint8_t* record(const image_view* v, int kind, uint32_t index) {
  return v->table[kind].first + (size_t)index * v->table[kind].stride;
}

static int holds(const image_view* v, int kind, uint32_t first, uint32_t count) {
  return count == 0 || (first <= count_of(v, kind) && count <= count_of(v, kind) - first);
}

/* Index of the slot or control of an axis; both are in ascending order of their first field, the axis. */
static uint32_t find_axis(const image_view* v, int kind, uint32_t axis) {
  uint32_t begin = 0, end = count_of(v, kind);
  while (begin < end) {
    uint32_t const middle = begin + (end - begin) / 2;
    if (u32(record(v, kind, middle)) < axis) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return begin < count_of(v, kind) && u32(record(v, kind, begin)) == axis ? begin : NONE;
}

/* CRC-32C, four bits at a time. */
static uint32_t crc32c(const uint8_t* bytes, size_t size, uint32_t before) {
  static uint32_t const remainder[16] = {
      0x00000000u, 0x105EC76Fu, 0x20BD8EDEu, 0x30E349B1u, 0x417B1DBCu, 0x5125DAD3u, 0x61C69362u, 0x7198540Du,
      0x82F63B78u, 0x92A8FC17u, 0xA24BB5A6u, 0xB21572C9u, 0xC38D26C4u, 0xD3D3E1ABu, 0xE330A81Au, 0xF36E6F75u};
  uint32_t crc = ~before;
  for (; size > 0; --size, ++bytes) {
    crc ^= *bytes;
    crc = crc >> 4 ^ remainder[crc & 15];
    crc = crc >> 4 ^ remainder[crc & 15];
  }
  return ~crc;
}

/* One entry of the section table. */
static axisrt_c_status read_section(const uint8_t* image, const uint8_t* entry, uint64_t total,
                                    uint64_t* free_from, image_view* v) {
  uint32_t const kind = u32(entry), stride = u32(entry + 24), count = u32(entry + 28);
  uint64_t const offset = u64(entry + 8), size = u64(entry + 16);
  int const own = kind == 17 ? SAMPLES : kind < SAMPLES ? (int)kind : 0;
  if (offset > total || size > total - offset || size != (uint64_t)stride * count)
    return AXISRT_C_OUT_OF_BOUNDS;
  if (offset % 64 != 0 || offset < *free_from) return AXISRT_C_OVERLAP;
  *free_from = offset + size;
  if (own == 0) { /* names, lists, values and bounds are not needed here */
    return (kind >= 16 && kind <= 20) || u32(entry + 4) == 1 ? AXISRT_C_OK : AXISRT_C_UNKNOWN_KIND;
  }
  if (v->table[own].first != NULL || stride < record_size[own]) return AXISRT_C_OUT_OF_BOUNDS;
  v->table[own].first = image + (size_t)offset;
  v->table[own].count = count;
  v->table[own].stride = stride;
  return AXISRT_C_OK;
}

static axisrt_c_status open_image(const uint8_t* image, size_t size, image_view* v) {
  static uint8_t const zero[4] = {0, 0, 0, 0};
  uint64_t total, directory, free_from;
  uint32_t i, crc;
  memset(v, 0, sizeof *v);
  if (image == NULL) return AXISRT_C_BAD_ARGUMENT;
  if (size < 4) return AXISRT_C_TOO_SHORT;
  if (u32(image) != 0x4D495841u /* AXIM */) return AXISRT_C_WRONG_MAGIC;
  if (size < 128) return AXISRT_C_TOO_SHORT;
  if (u32(image + 4) % 65536 != 1) return AXISRT_C_WRONG_VERSION;
  total = u64(image + 16);
  if (total > size) return AXISRT_C_TOO_SHORT;
  directory = u32(image + 8) + (uint64_t)32 * u32(image + 28);
  if (u32(image + 8) < 128 || directory > total) return AXISRT_C_OUT_OF_BOUNDS;
  if (size > total && (size - total != 80 || u32(image + (size_t)total) != 0x47535841u /* AXSG */))
    return AXISRT_C_WRONG_SIZE;
  crc = crc32c(image, 12, 0);
  crc = crc32c(zero, 4, crc);
  crc = crc32c(image + 16, (size_t)directory - 16, crc);
  if (crc != u32(image + 12)) return AXISRT_C_WRONG_CHECKSUM;
  if (crc32c(image + (size_t)directory, (size_t)(total - directory), 0) != u32(image + 24))
    return AXISRT_C_WRONG_CHECKSUM;
  free_from = directory;
  for (i = 0; i < u32(image + 28); ++i) {
    const uint8_t* const entry = image + u32(image + 8) + (size_t)32 * i;
    axisrt_c_status const status = read_section(image, entry, total, &free_from, v);
    if (status != AXISRT_C_OK) return status;
  }
  v->cycle_time_ns = u32(image + 32);
  if (v->cycle_time_ns < 1 || v->cycle_time_ns > 1000000000u) return AXISRT_C_INCONSISTENT_CYCLE;
  for (i = AXES; i <= COEFFICIENTS; ++i) {
    if (v->table[i].first == NULL) return AXISRT_C_OUT_OF_BOUNDS;
  }
  return count_of(v, AXES) == u32(image + 36) ? AXISRT_C_OK : AXISRT_C_OUT_OF_BOUNDS;
}

/* ---- the image: what create relies on ---------------------------------------------------------- */

#define DEMAND(condition, status)    \
  do {                               \
    if (!(condition)) return status; \
  } while (0)

static axisrt_c_status check_sections(const image_view* v) {
  uint32_t i;
  for (i = 0; i < count_of(v, COEFFICIENTS); ++i) {
    const uint8_t* const section = record(v, COEFFICIENTS, i);
    double const p = f64(section), q = f64(section + 8), k = f64(section + 16), b = f64(section + 24);
    DEMAND(is_finite(p) && is_finite(q) && is_finite(k) && is_finite(b), AXISRT_C_NOT_FINITE);
    DEMAND(k > 0 && b > 0 && b < 2 && 4 - k - 2 * b > 0 && is_within(p, 64) && is_within(q, 64),
           AXISRT_C_UNSTABLE);
  }
  return AXISRT_C_OK;
}

static axisrt_c_status check_filters(const image_view* v) {
  uint32_t i;
  for (i = 0; i < count_of(v, FILTERS); ++i) {
    const uint8_t* const filter = record(v, FILTERS, i);
    uint32_t const realisation = u32(filter + filter_realisation),
                   sections = u32(filter + filter_section_count);
    double const s = f64(filter + filter_share), direct = f64(filter + filter_direct);
    double const direct_low = f64(filter + filter_direct_low);
    DEMAND(realisation <= REALISATION_DELAY, AXISRT_C_UNKNOWN_KIND);
    DEMAND(u32(filter + filter_delay_cycles) <= 100, AXISRT_C_KERNEL_TOO_LONG);
    DEMAND(is_finite(s) && is_finite(direct) && is_finite(direct_low), AXISRT_C_NOT_FINITE);
    DEMAND(s >= 0 && s <= 1 && direct >= 0 && direct <= 1 && is_within(direct_low, HALF_ULP),
           AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(u32(filter + filter_blocks_constant) <= (realisation == REALISATION_SECTIONS ? 1u : 0u),
           AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(realisation == REALISATION_SECTIONS ? sections >= 1 && sections <= 6 : sections == 0,
           AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(holds(v, COEFFICIENTS, u32(filter + filter_first_section), sections), AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(holds(v, SAMPLES, u32(filter + filter_first_sample), u32(filter + filter_sample_count)),
           AXISRT_C_OUT_OF_BOUNDS);
  }
  return AXISRT_C_OK;
}

/* Chains share no filter: each begins where the one before it ended. */
static axisrt_c_status check_chain(const image_view* v, uint32_t first, uint32_t count, uint32_t most,
                                   uint32_t* next) {
  DEMAND(count <= most && (count == 0 || first == *next) && holds(v, FILTERS, *next, count),
         AXISRT_C_OUT_OF_BOUNDS);
  *next += count;
  return AXISRT_C_OK;
}

static axisrt_c_status check_chains(const image_view* v) {
  uint32_t next_filter = 0, next_stage = 0, i, k;
  axisrt_c_status status = AXISRT_C_OK;
  for (i = 0; i < count_of(v, AXES) && status == AXISRT_C_OK; ++i) {
    const uint8_t* const axis = record(v, AXES, i);
    DEMAND(is_finite(f64(axis + axis_position_window)) && is_finite(f64(axis + axis_velocity_limit)) &&
               is_finite(f64(axis + axis_peak_gain)),
           AXISRT_C_NOT_FINITE);
    status = check_chain(v, u32(axis + axis_first_filter), u32(axis + axis_filter_count), 3, &next_filter);
    if (status != AXISRT_C_OK) break;
    status = check_chain(v, u32(axis + axis_first_interface_filter), u32(axis + axis_interface_filter_count),
                         1, &next_filter);
  }
  for (i = 0; i < count_of(v, CONTROLS) && status == AXISRT_C_OK; ++i) {
    const uint8_t* const control = record(v, CONTROLS, i);
    uint32_t const axis = u32(control + control_axis), source = u32(control + control_source);
    uint32_t const stages = u32(control + control_stage_count), master = find_axis(v, CONTROLS, source);
    DEMAND(is_finite(f64(control + control_limit)) && is_finite(f64(control + control_scale)),
           AXISRT_C_NOT_FINITE);
    DEMAND(is_within(f64(control + control_limit), LARGEST_STATE) &&
               is_within(f64(control + control_scale), LARGEST_STATE),
           AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(axis < count_of(v, AXES) && (i == 0 || axis > u32(record(v, CONTROLS, i - 1))),
           AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(source == axis ? stages >= 1 && stages <= 3 : stages == 0, AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(master != NONE && u32(record(v, CONTROLS, master) + control_source) == source,
           AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(stages == 0 || u32(control + control_first_stage) == next_stage, AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(holds(v, STAGES, next_stage, stages), AXISRT_C_OUT_OF_BOUNDS);
    for (k = 0; k < stages && status == AXISRT_C_OK; ++k) {
      const uint8_t* const stage = record(v, STAGES, next_stage + k);
      DEMAND(u32(stage + stage_mode) >= 1 && u32(stage + stage_mode) <= 3, AXISRT_C_UNKNOWN_KIND);
      DEMAND(f64(stage + stage_weight) >= 0 && f64(stage + stage_weight) <= 7, AXISRT_C_OUT_OF_BOUNDS);
      status =
          check_chain(v, u32(stage + stage_first_filter), u32(stage + stage_filter_count), 3, &next_filter);
    }
    next_stage += stages;
  }
  if (status != AXISRT_C_OK) return status;
  return next_filter == count_of(v, FILTERS) && next_stage == count_of(v, STAGES) ? AXISRT_C_OK
                                                                                  : AXISRT_C_OUT_OF_BOUNDS;
}

/* No kernel, or one that fits into a history. */
static int is_executable(const image_view* v, uint32_t kernel, uint32_t history) {
  return kernel == NONE ||
         (kernel < count_of(v, KERNELS) && u32(record(v, KERNELS, kernel) + kernel_tail_count) <= history);
}

static axisrt_c_status check_kernels_and_slots(const image_view* v) {
  uint32_t i;
  for (i = 0; i < count_of(v, TAILS); ++i) {
    DEMAND(is_finite(f64(record(v, TAILS, i))), AXISRT_C_NOT_FINITE);
    DEMAND(is_within(f64(record(v, TAILS, i)), 64), AXISRT_C_OUT_OF_BOUNDS);
  }
  for (i = 0; i < count_of(v, KERNELS); ++i) {
    const uint8_t* const kernel = record(v, KERNELS, i);
    uint32_t const type = u32(kernel + kernel_type), tails = u32(kernel + kernel_tail_count);
    DEMAND(type <= KERNEL_GUARD, AXISRT_C_UNKNOWN_KIND);
    DEMAND(tails <= (type == KERNEL_GUARD ? MOST_GUARD_TAILS : MOST_TAILS), AXISRT_C_KERNEL_TOO_LONG);
    DEMAND(is_finite(f64(kernel + kernel_peak_gain)), AXISRT_C_NOT_FINITE);
    DEMAND(tails >= 1 && f64(kernel + kernel_peak_gain) >= 0.999999, AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(holds(v, TAILS, u32(kernel + kernel_first_tail), tails), AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(holds(v, SAMPLES, u32(kernel + kernel_first_sample), u32(kernel + kernel_sample_count)),
           AXISRT_C_OUT_OF_BOUNDS);
  }
  for (i = 0; i < count_of(v, SLOTS); ++i) {
    const uint8_t* const slot = record(v, SLOTS, i);
    uint32_t const axis = u32(slot + slot_axis), family = u32(slot + slot_family),
                   history = u32(slot + slot_history);
    DEMAND(family >= FAMILY_HSC && family <= FAMILY_GUARD, AXISRT_C_UNKNOWN_KIND);
    DEMAND(history <= (family == FAMILY_GUARD ? MOST_GUARD_TAILS : MOST_TAILS), AXISRT_C_KERNEL_TOO_LONG);
    DEMAND(axis < count_of(v, AXES) && (i == 0 || axis > u32(record(v, SLOTS, i - 1))),
           AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(is_executable(v, u32(slot + slot_kernel), history) && u32(slot + slot_on_at_start) <= 1,
           AXISRT_C_OUT_OF_BOUNDS);
  }
  for (i = 0; i < count_of(v, SAMPLES); ++i) {
    DEMAND(is_within(f64(record(v, SAMPLES, i)), LARGEST_POSITION), AXISRT_C_OUT_OF_BOUNDS);
  }
  return AXISRT_C_OK;
}

/* Slot of the axis of a member. */
static uint32_t slot_of_member(const image_view* v, uint32_t member) {
  return find_axis(v, SLOTS, u32(record(v, MEMBERS, member)));
}

static axisrt_c_status check_groups(const image_view* v) {
  uint32_t next_member = 0, next_bank = 0, next_choice = 0, i, k, m;
  for (i = 0; i < count_of(v, GROUPS); ++i) {
    const uint8_t* const group = record(v, GROUPS, i);
    uint32_t const members = u32(group + group_member_count), banks = u32(group + group_bank_count);
    DEMAND(u32(group + group_first_member) == next_member && holds(v, MEMBERS, next_member, members),
           AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(banks >= 1 && u32(group + group_first_bank) == next_bank && holds(v, BANKS, next_bank, banks),
           AXISRT_C_OUT_OF_BOUNDS);
    DEMAND(u32(group + group_off_fade_cycles) <= 4096, AXISRT_C_OUT_OF_BOUNDS);
    /* Member and slot name each other, so that no two groups reach one slot. */
    for (m = 0; m < members; ++m) {
      uint32_t const slot = slot_of_member(v, next_member + m);
      DEMAND(slot == NONE || (u32(record(v, SLOTS, slot) + slot_group) == i &&
                              u32(record(v, SLOTS, slot) + slot_member) == next_member + m),
             AXISRT_C_OUT_OF_BOUNDS);
    }
    for (k = 0; k < banks; ++k) {
      const uint8_t* const bank = record(v, BANKS, next_bank + k);
      DEMAND(u32(bank + bank_keywords) <= 63, AXISRT_C_UNKNOWN_KIND);
      DEMAND(u32(bank + bank_first_choice) == next_choice && holds(v, CHOICES, next_choice, members) &&
                 u32(bank + bank_fade_cycles) <= 4096,
             AXISRT_C_OUT_OF_BOUNDS);
      for (m = 0; m < members; ++m) {
        uint32_t const slot = slot_of_member(v, next_member + m);
        uint32_t const history = slot == NONE ? 0 : u32(record(v, SLOTS, slot) + slot_history);
        DEMAND(is_executable(v, u32(record(v, CHOICES, next_choice + m)), history), AXISRT_C_OUT_OF_BOUNDS);
      }
      next_choice += members;
    }
    next_member += members;
    next_bank += banks;
  }
  return AXISRT_C_OK;
}

static axisrt_c_status check_image(const image_view* v) {
  axisrt_c_status status = check_sections(v);
  if (status == AXISRT_C_OK) status = check_filters(v);
  if (status == AXISRT_C_OK) status = check_chains(v);
  if (status == AXISRT_C_OK) status = check_kernels_and_slots(v);
  if (status == AXISRT_C_OK) status = check_groups(v);
  return status;
}

/* ---- what is in memory ------------------------------------------------------------------------- */

typedef struct section {
  double p, g, k, b; /* g = p + q */
  double e, r;       /* r is kept as r + GRID */
} section;

typedef struct signal_t { /* value base + sum, and its increment */
  double base, sum, d;
} signal_t;

typedef struct kernel {
  const double* tail; /* S_0, S_1, ... */
  uint32_t count;
  double ramp; /* S_j = ramp (count - j) for a moving average, 0 for every other kernel */
  double peak_gain;
} kernel;

typedef struct slot {
  double* history; /* ring of increments */
  uint32_t length; /* of the ring: whole blocks of eight */
  uint32_t present;
  uint32_t remembers; /* increments that count for a standstill */
  uint32_t family, on, on_at_start;
  const kernel *listed, *now, *before;
  uint32_t fade_position, fade_length; /* equal: no fade */
  uint32_t is_ramp;                    /* 1: `now` is applied by its four sums */
  uint32_t ramp_phase;
  double c, p, g, q; /* sums of a moving average */
  double removed;    /* from the signal in the latest cycle */
} slot;

enum { PASS, PASSING, SHARED, BLOCKING, DELAY, SLOT };

typedef struct operation { /* one step of a chain */
  int kind;
  uint32_t section_count, delay, newest;
  section* sections;
  double share, direct, direct_low;
  signal_t* ring; /* delay + 1 signals; the newest one is at `newest` */
  slot* filter;
} operation;

enum { MOST_OPERATIONS = 4 };

typedef struct line { /* an axis, or a stage of Improved Position Control, with its chain */
  operation operations[MOST_OPERATIONS];
  uint32_t operation_count;
  uint32_t reset_done;
  double input, output;
  double largest_increment; /* that is plausible */
} line;

typedef struct batch {   /* lines of the same form: their tiny states are cleared in turn */
  uint32_t first, count; /* in the order */
  uint32_t next_line[MOST_OPERATIONS], next_section[MOST_OPERATIONS];
} batch;

typedef struct port {
  line* lines;
  uint32_t line_count;
  uint32_t* order; /* of the lines, batch after batch */
  batch* batches;
  uint32_t batch_count;
} port;

typedef struct group {
  uint32_t first_member, member_count, first_bank, bank_count, off_fade_cycles;
} group;

typedef struct bank {
  axisrt_c_bank_parameters parameters;
  uint32_t first_choice, fade_cycles;
} bank;

typedef struct stage {
  uint32_t mode, axis;
  double weight;
} stage;

typedef struct control {
  uint32_t axis, source; /* source: index of a control */
  uint32_t first_stage, stage_count;
  double limit, scale, v_add;
} control;

struct axisrt_c {
  uint32_t cycle_time_ns, axis_count, kernel_count, slot_count, group_count, stage_count, control_count;
  port setpoint, interface_port, velocity;
  double* position_windows;
  uint8_t* has_interface;
  kernel* kernels; /* one more than the image has: the last lets the signal pass */
  slot* slots;
  group* groups;
  slot** members; /* null for an axis without a slot */
  bank* banks;
  const kernel** choices;
  stage* stages;
  double *stage_in, *stage_out;
  uint8_t* stage_status;
  control* controls;
};

/* ---- one cycle of a chain ---------------------------------------------------------------------- */

/*   de = p d + r,   e += de,   r += g d - k e - b de */
static double run_section(section* s, double d) {
  double const de = s->p * d + (s->r - GRID);
  s->e += de;
  s->r += s->g * d - s->k * s->e - s->b * de;
  return de;
}

/* H(1) = 1: each section adds to the signal. `raw`: the sums leave as they are. */
static signal_t run_passing(const operation* o, signal_t x, int raw) {
  uint32_t i;
  for (i = 0; i < o->section_count; ++i) {
    double const de = run_section(&o->sections[i], x.d);
    x.sum += o->sections[i].e;
    x.d += de;
    if (i % 3 == 2) x.d = on_grid(x.d);
  }
  if (raw) return x;
  x.sum = on_grid(x.sum);
  x.d = on_grid(x.d);
  return x;
}

static signal_t run_shared(const operation* o, signal_t x) {
  signal_t y = run_passing(o, x, 0);
  y.sum = o->share * y.sum + o->direct * x.sum;
  y.d = o->share * y.d + o->direct * x.d;
  return y;
}

/* base' = (1 - s) base in twice the precision, sum' = s e + (1 - s) sum + what base' lost. */
static signal_t join_blocking(const operation* o, signal_t x, double e, double de) {
  signal_t y;
  double high, low;
  exact_product(o->direct, x.base, &high, &low);
  low += o->direct_low * x.base;
  y.base = on_grid(high);
  y.sum = on_grid(o->share * e + (o->direct * x.sum + low));
  y.d = on_grid(o->share * de + o->direct * x.d);
  return y;
}

/* H(1) = 0: each section replaces the signal. */
static signal_t run_blocking(const operation* o, signal_t x) {
  double d = x.d, e = 0;
  uint32_t i;
  for (i = 0; i < o->section_count; ++i) {
    d = run_section(&o->sections[i], d);
    e = o->sections[i].e;
    if (i % 3 == 2) d = on_grid(d);
  }
  return join_blocking(o, x, e, d);
}

static signal_t join_delay(const operation* o, signal_t x, signal_t delayed) {
  signal_t y;
  double const distance = (x.base - delayed.base) + x.sum;
  y.base = delayed.base;
  y.sum = on_grid(o->share * delayed.sum + o->direct * distance);
  y.d = on_grid(o->share * delayed.d + o->direct * x.d);
  return y;
}

static signal_t run_delay(operation* o, signal_t x) {
  uint32_t const oldest = o->newest == o->delay ? 0 : o->newest + 1;
  o->ring[o->newest] = x;
  o->newest = oldest;
  return join_delay(o, x, o->ring[oldest]);
}

/* E = S_0 d[n] + S_1 d[n-1] + ...: in blocks of eight places, the present one first; in four sums. */
static double apply(const slot* s, const kernel* h) {
  double part[4] = {0, 0, 0, 0};
  uint32_t const blocks = s->length / 8, block = s->present / 8, phase = s->present % 8;
  uint32_t c, i;
  for (c = 0; 8 * c < h->count + 8 && c < blocks; ++c) {
    const double* const d = s->history + (size_t)8 * (block >= c ? block - c : block + blocks - c);
    for (i = 0; i < 8; ++i) { /* d[i] is phase + 8 c - i cycles old */
      uint32_t const age = phase + 8 * c - i;
      if (phase + 8 * c >= i && age < h->count) part[i % 4] += h->tail[age] * d[i];
    }
  }
  return (part[0] + part[1]) + (part[2] + part[3]);
}

static double increment_of_age(const slot* s, uint32_t age) {
  return s->history[s->present >= age ? s->present - age : s->present + s->length - age];
}

/* E / ramp = C[n] + G[n]: the increments of the present window, and those before it. */
static double run_ramp(slot* s, double d) {
  double removed;
  s->g -= s->q;
  s->q -= increment_of_age(s, s->now->count);
  s->c = (s->c - s->p) + (double)s->now->count * d;
  s->p += d;
  removed = s->now->ramp * (s->c + s->g);
  if (++s->ramp_phase == s->now->count) {
    s->ramp_phase = 0;
    s->g = s->c;
    s->q = s->p;
    s->c = s->p = 0;
  }
  return removed;
}

/* Takes the increments so far as those of the window before. */
static void begin_ramp(slot* s) {
  uint32_t j;
  s->is_ramp = 1;
  s->ramp_phase = 0;
  s->c = s->p = s->g = s->q = 0;
  for (j = 0; j < s->now->count; ++j) {
    s->g += (double)(s->now->count - j) * increment_of_age(s, j);
    s->q += increment_of_age(s, j);
  }
}

static int is_fading(const slot* s) {
  return s->fade_position < s->fade_length;
}

/* E = E_A + w (E_B - E_A),  w = t^3 (10 - 15 t + 6 t^2). The last cycle of a fade is B alone. */
static double run_kernels(slot* s) {
  double const after = apply(s, s->now);
  if (is_fading(s)) {
    double const t = (double)++s->fade_position / (double)s->fade_length;
    double const w = t * t * t * (10 + t * (6 * t - 15));
    if (is_fading(s)) {
      double const before = apply(s, s->before);
      return before + w * (after - before);
    }
  }
  return after;
}

/* y = x - E */
static signal_t run_slot(slot* s, signal_t x) {
  double removed;
  s->history[s->present] = x.d;
  removed = on_grid(s->is_ramp ? run_ramp(s, x.d) : run_kernels(s));
  x.sum -= removed;
  x.d -= removed - s->removed;
  s->removed = removed;
  if (!s->is_ramp && !is_fading(s) && s->now->ramp != 0) begin_ramp(s);
  s->present = s->present + 1 == s->length ? 0 : s->present + 1;
  return x;
}

static signal_t run_operation(operation* o, signal_t x, int raw) {
  switch (o->kind) {
    case PASSING: return run_passing(o, x, raw);
    case SHARED: return run_shared(o, x);
    case BLOCKING: return run_blocking(o, x);
    case DELAY: return run_delay(o, x);
    case SLOT: return run_slot(o->filter, x);
    default: return x;
  }
}

/* A chain that is nothing but 1, 2, 4 or 6 sections with H(1) = 1. */
static int leaves_raw(const line* l) {
  uint32_t const n = l->operations[0].section_count;
  return l->operation_count == 1 && l->operations[0].kind == PASSING &&
         (n == 1 || n == 2 || n == 4 || n == 6);
}

static uint8_t step_line(line* l, double in, double* out) {
  int const good = is_within(in, LARGEST_POSITION);
  signal_t x;
  uint32_t i;
  uint8_t status = AXISRT_C_OK;
  x.base = good && l->reset_done ? unless_below(SMALLEST_POSITION, in) : l->input;
  x.sum = 0;
  x.d = x.base - l->input;
  l->input = x.base;
  for (i = 0; i < l->operation_count; ++i) x = run_operation(&l->operations[i], x, leaves_raw(l));
  x.base += x.sum;
  if (!l->reset_done) {
    status = AXISRT_C_NOT_RESET;
  } else if (!(magnitude(x.base - l->output) <= l->largest_increment)) {
    status = AXISRT_C_IMPLAUSIBLE;
  } else if (!good) {
    status = AXISRT_C_BAD_INPUT;
  }
  l->output = x.base;
  *out = l->reset_done ? x.base : good ? in : 0;
  return status;
}

/* States that are tiny, or too large, become zero. */
static void bound_section(section* s) {
  double const size = magnitude(s->e) + magnitude(s->r);
  if (SMALLEST_STATE <= size && size <= LARGEST_STATE) return;
  s->e = 0;
  s->r = GRID;
}

/* The next sixth of a batch's sections. */
static void bound_some_sections(const port* p, batch* b) {
  uint32_t const operations = p->lines[p->order[b->first]].operation_count;
  uint32_t i, done;
  for (i = 0; i < operations; ++i) {
    uint32_t const sections = p->lines[p->order[b->first]].operations[i].section_count;
    for (done = 0; done < b->count * sections; done += 6) {
      bound_section(
          &p->lines[p->order[b->first + b->next_line[i]]].operations[i].sections[b->next_section[i]]);
      if (++b->next_section[i] < sections) continue;
      b->next_section[i] = 0;
      b->next_line[i] = b->next_line[i] + 1 == b->count ? 0 : b->next_line[i] + 1;
    }
  }
}

static axisrt_c_status step_port(port* p, const double* in, double* out, uint8_t* status) {
  int worst = AXISRT_C_OK;
  uint32_t i;
  for (i = 0; i < p->line_count; ++i) {
    uint8_t const happened = step_line(&p->lines[i], in[i], &out[i]);
    if (status != NULL) status[i] = happened;
    if (happened > worst) worst = happened;
  }
  for (i = 0; i < p->batch_count; ++i) bound_some_sections(p, &p->batches[i]);
  return (axisrt_c_status)worst;
}

/* ---- the steady state -------------------------------------------------------------------------- */

static void reset_slot(slot* s) {
  s->fade_position = s->fade_length;
  memset(s->history, 0, s->length * sizeof *s->history);
  s->c = s->p = s->g = s->q = s->removed = 0;
}

/* The steady state of an operation for a constant signal x; what leaves it then. */
static signal_t reset_operation(operation* o, signal_t x) {
  signal_t y = x;
  uint32_t i;
  for (i = 0; i < o->section_count; ++i) {
    o->sections[i].e = 0;
    o->sections[i].r = GRID;
  }
  switch (o->kind) {
    case SHARED: y.sum = on_grid(o->share * x.sum + o->direct * x.sum); break;
    case BLOCKING: y = join_blocking(o, x, 0, 0); break;
    case DELAY:
      for (i = 0; i <= o->delay; ++i) o->ring[i] = x;
      y = join_delay(o, x, x);
      break;
    case SLOT: reset_slot(o->filter); break;
    default: break;
  }
  return y;
}

static void reset_line(line* l, double position) {
  signal_t x;
  uint32_t i;
  x.base = unless_below(SMALLEST_POSITION, position);
  x.sum = x.d = 0;
  l->input = x.base;
  for (i = 0; i < l->operation_count; ++i) x = reset_operation(&l->operations[i], x);
  l->output = x.base + x.sum;
  l->reset_done = 1;
}

/* Adds a constant to every signal that a chain holds, without loss where it is representable (Knuth). */
static void rebase_line(line* l, double offset) {
  signal_t shift;
  uint32_t i, k;
  shift.base = unless_below(SMALLEST_POSITION, offset);
  shift.sum = shift.d = 0;
  l->input += shift.base;
  for (i = 0; i < l->operation_count; ++i) {
    operation* const o = &l->operations[i];
    if (o->kind == DELAY) {
      for (k = 0; k <= o->delay; ++k) {
        double const a = o->ring[k].base, high = a + shift.base, part = high - a;
        o->ring[k].base = high;
        o->ring[k].sum += ((a - (high - part)) + (shift.base - part)) + shift.sum;
      }
      shift = join_delay(o, shift, shift);
    } else if (o->kind == BLOCKING) {
      shift = join_blocking(o, shift, 0, 0);
    } else if (o->kind == SHARED) {
      shift.sum = on_grid(o->share * shift.sum + o->direct * shift.sum);
    }
  }
  l->output += shift.base + shift.sum;
}

/* ---- create ------------------------------------------------------------------------------------ */

/* Hands out memory from the beginning to the end; without memory it only counts. */
typedef struct arena {
  uint8_t* memory;
  uint64_t used;
} arena;

static void* take(arena* a, uint64_t count, size_t size) {
  void* const place = a->memory == NULL ? NULL : a->memory + (size_t)a->used;
  a->used += (count * size + 7) / 8 * 8;
  return place;
}

static double ulp(double x) {
  return double_of(magnitude_bits(x) + 1) - magnitude(x);
}

/* Runs an operation that is steady at 0 on the samples of its filter or kernel; leaves it steady. */
static axisrt_c_status self_test(const image_view* v, uint32_t first, uint32_t count, operation* o) {
  signal_t x = {0, 0, 0}, y;
  double largest = 0, before = 0;
  int passed = 1;
  uint32_t i;
  for (i = 0; i < count; ++i) {
    double const input = magnitude(f64(record(v, SAMPLES, first + i)));
    if (input > largest) largest = input;
  }
  for (i = 0; i < count; ++i) {
    const uint8_t* const sample = record(v, SAMPLES, first + i);
    x.base = f64(sample);
    x.d = x.base - before;
    before = x.base;
    y = run_operation(o, x, 0);
    passed = passed && is_within(y.base + y.sum - f64(sample + 8), 2 * ulp(largest));
  }
  x.base = x.d = 0;
  reset_operation(o, x);
  o->newest = 0;
  return passed ? AXISRT_C_OK : AXISRT_C_SELF_TEST_FAILED;
}

/* The operation of a filter of the image, in the steady state for 0. */
static void build_operation(const image_view* v, const uint8_t* filter, arena* a, operation* o) {
  uint32_t const realisation = u32(filter + filter_realisation), delay = u32(filter + filter_delay_cycles);
  uint32_t const first = u32(filter + filter_first_section);
  signal_t const zero = {0, 0, 0};
  uint32_t i;
  memset(o, 0, sizeof *o);
  o->share = unless_below(SMALLEST_COEFFICIENT, f64(filter + filter_share));
  o->direct = unless_below(SMALLEST_COEFFICIENT, f64(filter + filter_direct));
  o->direct_low = unless_below(SMALLEST_REST, f64(filter + filter_direct_low));
  if (realisation == REALISATION_DELAY && delay > 0) {
    o->kind = DELAY;
    o->delay = delay;
    o->ring = (signal_t*)take(a, (uint64_t)delay + 1, sizeof *o->ring);
  } else if (realisation == REALISATION_SECTIONS) {
    int const whole = f64(filter + filter_share) == 1 && f64(filter + filter_direct) == 0;
    o->kind = u32(filter + filter_blocks_constant) != 0 ? BLOCKING : whole ? PASSING : SHARED;
    o->section_count = u32(filter + filter_section_count);
    o->sections = (section*)take(a, o->section_count, sizeof *o->sections);
  }
  if (a->memory == NULL) return;
  for (i = 0; i < o->section_count; ++i) {
    const uint8_t* const s = record(v, COEFFICIENTS, first + i);
    o->sections[i].p = unless_below(SMALLEST_NUMERATOR, f64(s));
    o->sections[i].g = unless_below(SMALLEST_COEFFICIENT, f64(s) + f64(s + 8));
    o->sections[i].k = unless_below(SMALLEST_COEFFICIENT, f64(s + 16));
    o->sections[i].b = unless_below(SMALLEST_COEFFICIENT, f64(s + 24));
  }
  reset_operation(o, zero);
}

/* `before` and `after`: slots of HSC, and of FIR or Vibration Guard; null where there is none. */
static axisrt_c_status build_line(const image_view* v, uint32_t first, uint32_t count, slot* before,
                                  slot* after, arena* a, line* l) {
  uint32_t i;
  memset(l, 0, sizeof *l);
  l->largest_increment = DBL_MAX;
  if (before != NULL) {
    l->operations[0].kind = SLOT;
    l->operations[l->operation_count++].filter = before;
  }
  for (i = 0; i < count; ++i) {
    const uint8_t* const filter = record(v, FILTERS, first + i);
    operation* const last = l->operation_count > 0 ? &l->operations[l->operation_count - 1] : NULL;
    operation o;
    build_operation(v, filter, a, &o);
    if (a->memory != NULL) {
      axisrt_c_status const status =
          self_test(v, u32(filter + filter_first_sample), u32(filter + filter_sample_count), &o);
      if (status != AXISRT_C_OK) return status;
    }
    if (o.kind == PASSING && last != NULL && last->kind == PASSING) {
      last->section_count += o.section_count; /* their sections are neighbours in memory */
    } else if (o.kind != PASS) {
      l->operations[l->operation_count++] = o;
    }
  }
  if (after != NULL) {
    l->operations[l->operation_count].kind = SLOT;
    l->operations[l->operation_count++].filter = after;
  }
  return AXISRT_C_OK;
}

static int same_form(const line* one, const line* other) {
  uint32_t i;
  if (one->operation_count != other->operation_count) return 0;
  for (i = 0; i < one->operation_count; ++i) {
    const operation *a = &one->operations[i], *b = &other->operations[i];
    if (a->kind != b->kind || a->section_count != b->section_count || a->delay != b->delay) return 0;
    if (a->kind == SLOT && a->filter->length != b->filter->length) return 0;
  }
  return 1;
}

enum { MOST_FORMS = 32 };

/* Lines of each of the first 32 forms are a batch; of any other form, those that follow each other. */
static void build_batches(port* p) {
  uint32_t form[MOST_FORMS];
  uint32_t forms = 0, placed = 0, i, k;
  for (i = 0; i < p->line_count && forms < MOST_FORMS; ++i) {
    for (k = 0; k < forms && !same_form(&p->lines[form[k]], &p->lines[i]); ++k) {
    }
    if (k == forms) form[forms++] = i;
  }
  memset(p->batches, 0, p->line_count * sizeof *p->batches);
  for (k = 0; k < forms; ++k) {
    batch* const b = &p->batches[p->batch_count++];
    b->first = placed;
    for (i = form[k]; i < p->line_count; ++i) {
      if (same_form(&p->lines[form[k]], &p->lines[i])) p->order[placed++] = i;
    }
    b->count = placed - b->first;
  }
  for (i = 0; i < p->line_count; ++i) {
    batch* b = &p->batches[p->batch_count];
    for (k = 0; k < forms && !same_form(&p->lines[form[k]], &p->lines[i]); ++k) {
    }
    if (k < forms) continue;
    if (p->batch_count > forms && same_form(&p->lines[p->order[placed - 1]], &p->lines[i])) {
      --b;
    } else {
      ++p->batch_count;
      b->first = placed;
    }
    p->order[placed++] = i;
    ++b->count;
  }
}

static void take_port(arena* a, uint32_t lines, port* p) {
  p->line_count = lines;
  p->lines = (line*)take(a, lines, sizeof *p->lines);
  p->order = (uint32_t*)take(a, lines, sizeof *p->order);
  p->batches = (batch*)take(a, lines, sizeof *p->batches);
}

/* The factor s of tails s (count - j), apart from their rounding; 0 for other kernels. */
static double find_ramp(const kernel* h) {
  double const ramp = h->tail[0] / h->count;
  uint32_t j;
  if (h->count < 2) return 0;
  for (j = 0; j < h->count; ++j) {
    double const limit = 8.881784197001252e-16 * magnitude(h->tail[j]); /* 2^-50 */
    if (!is_within(ramp * (h->count - j) - h->tail[j], limit)) return 0;
  }
  return ramp;
}

static void build_kernels(const image_view* v, arena* a, axisrt_c* rt) {
  uint32_t i, j;
  rt->kernels = (kernel*)take(a, (uint64_t)rt->kernel_count + 1, sizeof *rt->kernels);
  if (a->memory != NULL) memset(rt->kernels, 0, ((size_t)rt->kernel_count + 1) * sizeof *rt->kernels);
  for (i = 0; i < rt->kernel_count; ++i) {
    const uint8_t* const from = record(v, KERNELS, i);
    uint32_t const first = u32(from + kernel_first_tail), count = u32(from + kernel_tail_count);
    double* const tail = (double*)take(a, count, sizeof *tail);
    if (a->memory == NULL) continue;
    for (j = 0; j < count; ++j) tail[j] = unless_below(SMALLEST_TAIL, f64(record(v, TAILS, first + j)));
    rt->kernels[i].tail = tail;
    rt->kernels[i].count = count;
    rt->kernels[i].ramp = find_ramp(&rt->kernels[i]);
    rt->kernels[i].peak_gain = f64(from + kernel_peak_gain);
  }
}

/* Begins to work with a kernel, without a fade where `fade_cycles` is 0. */
static void switch_slot(slot* s, const kernel* to, uint32_t fade_cycles) {
  s->before = s->now;
  s->now = to;
  s->fade_position = 0;
  s->fade_length = fade_cycles;
  s->is_ramp = 0;
}

/* The steady state from which a slot starts. */
static void start_slot(slot* s, const kernel* h) {
  switch_slot(s, h, 0);
  reset_slot(s);
  s->present = s->ramp_phase = 0;
  s->is_ramp = h->ramp != 0;
}

static axisrt_c_status build_slots(const image_view* v, arena* a, axisrt_c* rt) {
  const kernel* pass;
  uint32_t i, k;
  rt->slots = (slot*)take(a, rt->slot_count, sizeof *rt->slots);
  if (a->memory != NULL) memset(rt->slots, 0, rt->slot_count * sizeof *rt->slots);
  pass = a->memory != NULL ? rt->kernels + rt->kernel_count : NULL;
  for (i = 0; i < rt->slot_count; ++i) {
    const uint8_t* const from = record(v, SLOTS, i);
    uint32_t const remembers = u32(from + slot_history) > 0 ? u32(from + slot_history) : 1;
    uint32_t const length = remembers < 2 ? 16 : ((remembers + 6) / 8 + 1) * 8;
    double* const history = (double*)take(a, length, sizeof *history);
    slot* s;
    if (a->memory == NULL) continue;
    s = &rt->slots[i];
    s->history = history;
    s->length = length;
    s->remembers = remembers;
    s->family = u32(from + slot_family);
    s->on = s->on_at_start = u32(from + slot_on_at_start);
    s->listed = u32(from + slot_kernel) == NONE ? pass : &rt->kernels[u32(from + slot_kernel)];
    start_slot(s, s->on ? s->listed : pass);
  }
  for (k = 0; k < rt->kernel_count && a->memory != NULL; ++k) {
    const uint8_t* const from = record(v, KERNELS, k);
    for (i = 0; i < rt->slot_count && rt->slots[i].length < rt->kernels[k].count + 7; ++i) {
    }
    if (i < rt->slot_count) {
      slot* const s = &rt->slots[i];
      const kernel* const now = s->now;
      operation o;
      axisrt_c_status status;
      memset(&o, 0, sizeof o);
      o.kind = SLOT;
      o.filter = s;
      start_slot(s, &rt->kernels[k]);
      status = self_test(v, u32(from + kernel_first_sample), u32(from + kernel_sample_count), &o);
      start_slot(s, now);
      if (status != AXISRT_C_OK) return status;
    }
  }
  return AXISRT_C_OK;
}

/* (P + 1/4) v, P being the largest peak gain of the chain with any kernel that its slot has room for. */
static double largest_increment(const image_view* v, const axisrt_c* rt, uint32_t index, const slot* s) {
  const uint8_t* const axis = record(v, AXES, index);
  double const T = rt->cycle_time_ns * 1e-9;
  double const velocity = f64(axis + axis_velocity_limit) * 10 * T;
  double gain = f64(axis + axis_peak_gain), largest = 1;
  uint32_t i;
  if (!(velocity > 0)) return DBL_MAX;
  if (s != NULL) {
    for (i = 0; i < rt->kernel_count; ++i) {
      int const fits = rt->kernels[i].count <= s->remembers || s->remembers > MOST_TAILS;
      if (fits && rt->kernels[i].peak_gain > largest) largest = rt->kernels[i].peak_gain;
    }
    if (s->on_at_start && s->listed->count > 0) gain = gain / s->listed->peak_gain;
    gain = gain * largest;
  }
  return on_grid((gain + 0.25) * velocity);
}

static axisrt_c_status build_ports(const image_view* v, arena* a, axisrt_c* rt) {
  axisrt_c_status status = AXISRT_C_OK;
  uint32_t i, k;
  line l;
  take_port(a, rt->axis_count, &rt->setpoint);
  take_port(a, rt->axis_count, &rt->interface_port);
  take_port(a, rt->stage_count, &rt->velocity);
  rt->position_windows = (double*)take(a, rt->axis_count, sizeof *rt->position_windows);
  rt->has_interface = (uint8_t*)take(a, rt->axis_count, 1);
  for (i = 0; i < rt->axis_count && status == AXISRT_C_OK; ++i) {
    const uint8_t* const axis = record(v, AXES, i);
    uint32_t const number = find_axis(v, SLOTS, i), filters = u32(axis + axis_interface_filter_count);
    slot* const s = number == NONE || a->memory == NULL ? NULL : &rt->slots[number];
    int const first = s != NULL && s->family == FAMILY_HSC;
    status = build_line(v, u32(axis + axis_first_filter), u32(axis + axis_filter_count), first ? s : NULL,
                        first ? NULL : s, a, &l);
    l.largest_increment = largest_increment(v, rt, i, s);
    if (a->memory != NULL) rt->setpoint.lines[i] = l;
    if (status != AXISRT_C_OK) break;
    status = build_line(v, u32(axis + axis_first_interface_filter), filters, NULL, NULL, a, &l);
    l.reset_done = filters == 0;
    if (a->memory == NULL) continue;
    rt->interface_port.lines[i] = l;
    rt->position_windows[i] = f64(axis + axis_position_window);
    rt->has_interface[i] = filters > 0;
  }
  rt->controls = (control*)take(a, rt->control_count, sizeof *rt->controls);
  rt->stages = (stage*)take(a, rt->stage_count, sizeof *rt->stages);
  rt->stage_in = (double*)take(a, rt->stage_count, sizeof *rt->stage_in);
  rt->stage_out = (double*)take(a, rt->stage_count, sizeof *rt->stage_out);
  rt->stage_status = (uint8_t*)take(a, rt->stage_count, 1);
  for (i = 0; i < rt->control_count && status == AXISRT_C_OK; ++i) {
    const uint8_t* const from = record(v, CONTROLS, i);
    uint32_t const stages = u32(from + control_stage_count);
    uint32_t const first = stages > 0 ? u32(from + control_first_stage) : 0;
    for (k = first; k < first + stages && status == AXISRT_C_OK; ++k) {
      const uint8_t* const s = record(v, STAGES, k);
      status = build_line(v, u32(s + stage_first_filter), u32(s + stage_filter_count), NULL, NULL, a, &l);
      if (a->memory == NULL) continue;
      rt->velocity.lines[k] = l;
      rt->stages[k].mode = u32(s + stage_mode);
      rt->stages[k].axis = u32(from + control_axis);
      rt->stages[k].weight = unless_below(SMALLEST_COEFFICIENT, f64(s + stage_weight));
    }
    if (a->memory == NULL) continue;
    rt->controls[i].axis = u32(from + control_axis);
    rt->controls[i].source = find_axis(v, CONTROLS, u32(from + control_source));
    rt->controls[i].first_stage = first;
    rt->controls[i].stage_count = stages;
    rt->controls[i].limit = unless_below(SMALLEST_POSITION, magnitude(f64(from + control_limit)));
    rt->controls[i].scale = unless_below(SMALLEST_COEFFICIENT, f64(from + control_scale));
    rt->controls[i].v_add = 0;
  }
  if (a->memory == NULL || status != AXISRT_C_OK) return status;
  build_batches(&rt->setpoint);
  build_batches(&rt->interface_port);
  build_batches(&rt->velocity);
  return AXISRT_C_OK;
}

static void build_groups(const image_view* v, arena* a, axisrt_c* rt) {
  uint32_t i;
  rt->groups = (group*)take(a, rt->group_count, sizeof *rt->groups);
  rt->members = (slot**)take(a, count_of(v, MEMBERS), sizeof *rt->members);
  rt->banks = (bank*)take(a, count_of(v, BANKS), sizeof *rt->banks);
  rt->choices = (const kernel**)take(a, count_of(v, CHOICES), sizeof *rt->choices);
  if (a->memory == NULL) return;
  for (i = 0; i < rt->group_count; ++i) {
    const uint8_t* const from = record(v, GROUPS, i);
    rt->groups[i].first_member = u32(from + group_first_member);
    rt->groups[i].member_count = u32(from + group_member_count);
    rt->groups[i].first_bank = u32(from + group_first_bank);
    rt->groups[i].bank_count = u32(from + group_bank_count);
    rt->groups[i].off_fade_cycles = u32(from + group_off_fade_cycles);
  }
  for (i = 0; i < count_of(v, MEMBERS); ++i) {
    uint32_t const number = slot_of_member(v, i);
    rt->members[i] = number == NONE ? NULL : &rt->slots[number];
  }
  for (i = 0; i < count_of(v, BANKS); ++i) {
    const uint8_t* const from = record(v, BANKS, i);
    rt->banks[i].parameters.keywords = u32(from + bank_keywords);
    rt->banks[i].parameters.order = u32(from + bank_order);
    rt->banks[i].parameters.share = f64(from + bank_share);
    rt->banks[i].parameters.frequency = f64(from + bank_frequency);
    rt->banks[i].parameters.quality = f64(from + bank_quality);
    rt->banks[i].first_choice = u32(from + bank_first_choice);
    rt->banks[i].fade_cycles = u32(from + bank_fade_cycles);
  }
  for (i = 0; i < count_of(v, CHOICES); ++i) {
    uint32_t const number = u32(record(v, CHOICES, i));
    rt->choices[i] = &rt->kernels[number == NONE ? rt->kernel_count : number];
  }
}

/* Everything in the order in which it lies in memory. */
static axisrt_c_status build(const image_view* v, arena* a, axisrt_c** made) {
  axisrt_c counted;
  axisrt_c* const place = (axisrt_c*)take(a, 1, sizeof counted);
  axisrt_c* const rt = place != NULL ? place : &counted;
  axisrt_c_status status;
  memset(rt, 0, sizeof *rt);
  rt->cycle_time_ns = v->cycle_time_ns;
  rt->axis_count = count_of(v, AXES);
  rt->kernel_count = count_of(v, KERNELS);
  rt->slot_count = count_of(v, SLOTS);
  rt->group_count = count_of(v, GROUPS);
  rt->stage_count = count_of(v, STAGES);
  rt->control_count = count_of(v, CONTROLS);
  build_kernels(v, a, rt);
  status = build_slots(v, a, rt);
  if (status == AXISRT_C_OK) status = build_ports(v, a, rt);
  if (status == AXISRT_C_OK) build_groups(v, a, rt);
  if (status == AXISRT_C_OK && made != NULL) *made = rt;
  return status;
}

static axisrt_c_status open_and_count(const void* image, size_t image_size, image_view* v, uint64_t* bytes) {
  arena counting = {NULL, 0};
  axisrt_c_status status = open_image((const uint8_t*)image, image_size, v);
  if (status == AXISRT_C_OK) status = check_image(v);
  if (status != AXISRT_C_OK) return status;
  status = build(v, &counting, NULL);
  *bytes = counting.used;
  return *bytes > SIZE_MAX ? AXISRT_C_MEMORY_TOO_SMALL : status;
}

axisrt_c_status axisrt_c_memory_size(const void* image, size_t image_size, size_t* bytes) {
  image_view v;
  uint64_t needed = 0;
  axisrt_c_status status;
  if (bytes == NULL) return AXISRT_C_BAD_ARGUMENT;
  status = open_and_count(image, image_size, &v, &needed);
  if (status == AXISRT_C_OK) *bytes = (size_t)needed;
  return status;
}

axisrt_c_status axisrt_c_create(const void* image, size_t image_size, void* memory, size_t memory_size,
                                axisrt_c** runtime) {
  image_view v;
  uint64_t needed = 0;
  arena place = {(uint8_t*)memory, 0};
  axisrt_c_status status;
  if (runtime == NULL) return AXISRT_C_BAD_ARGUMENT;
  *runtime = NULL;
  status = open_and_count(image, image_size, &v, &needed);
  if (status != AXISRT_C_OK) return status;
  if (memory == NULL || needed > memory_size) return AXISRT_C_MEMORY_TOO_SMALL;
  if ((uintptr_t)memory % AXISRT_C_ALIGNMENT != 0) return AXISRT_C_MISALIGNED;
  return build(&v, &place, runtime);
}

/* ---- properties -------------------------------------------------------------------------------- */

uint32_t axisrt_c_cycle_time_ns(const axisrt_c* rt) {
  return rt == NULL ? 0 : rt->cycle_time_ns;
}

uint32_t axisrt_c_axis_count(const axisrt_c* rt) {
  return rt == NULL ? 0 : rt->axis_count;
}

int axisrt_c_has_interface(const axisrt_c* rt, uint32_t axis) {
  return rt != NULL && axis < rt->axis_count && rt->has_interface[axis];
}

int axisrt_c_has_position_control(const axisrt_c* rt, uint32_t axis) {
  uint32_t i;
  for (i = 0; rt != NULL && i < rt->control_count; ++i) {
    if (rt->controls[i].axis == axis) return 1;
  }
  return 0;
}

uint32_t axisrt_c_group_count(const axisrt_c* rt) {
  return rt == NULL ? 0 : rt->group_count;
}

uint32_t axisrt_c_bank_count(const axisrt_c* rt, uint32_t index) {
  return rt == NULL || index >= rt->group_count ? 0 : rt->groups[index].bank_count;
}

uint32_t axisrt_c_busy_cycles(const axisrt_c* rt, uint32_t index) {
  uint32_t most = 0, i;
  if (rt == NULL || index >= rt->group_count) return 0;
  for (i = 0; i < rt->groups[index].member_count; ++i) {
    const slot* const s = rt->members[rt->groups[index].first_member + i];
    if (s != NULL && s->fade_length - s->fade_position > most) most = s->fade_length - s->fade_position;
  }
  return most;
}

axisrt_c_status axisrt_c_get_bank(const axisrt_c* rt, uint32_t index, uint32_t number,
                                  axisrt_c_bank_parameters* parameters) {
  if (parameters == NULL || number >= axisrt_c_bank_count(rt, index)) return AXISRT_C_BAD_ARGUMENT;
  *parameters = rt->banks[rt->groups[index].first_bank + number].parameters;
  return AXISRT_C_OK;
}

axisrt_c_status axisrt_c_get_axis_state(const axisrt_c* rt, uint32_t axis, axisrt_c_axis_state* state) {
  const line* l;
  uint32_t i;
  if (rt == NULL || state == NULL || axis >= rt->axis_count) return AXISRT_C_BAD_ARGUMENT;
  l = &rt->setpoint.lines[axis];
  state->unfiltered = l->input;
  state->filtered = l->output;
  state->kernel = AXISRT_C_NO_KERNEL;
  state->fading = 0;
  state->reset_done = l->reset_done;
  state->settled = l->reset_done && magnitude(l->input - l->output) <= rt->position_windows[axis];
  for (i = 0; i < l->operation_count; ++i) {
    const slot* const s = l->operations[i].filter;
    if (s == NULL) continue;
    if (s->now->count > 0) state->kernel = (uint32_t)(s->now - rt->kernels);
    state->fading = (uint32_t)is_fading(s);
  }
  return AXISRT_C_OK;
}

/* ---- reset, cycle, commands -------------------------------------------------------------------- */

static axisrt_c_status reset_axis(const axisrt_c* rt, line* lines, uint32_t axis, double x) {
  if (axis >= rt->axis_count) return AXISRT_C_BAD_ARGUMENT;
  if (!is_within(x, LARGEST_POSITION)) return AXISRT_C_BAD_INPUT;
  reset_line(&lines[axis], x);
  return AXISRT_C_OK;
}

axisrt_c_status axisrt_c_reset(axisrt_c* rt, uint32_t axis, double position) {
  return rt == NULL ? AXISRT_C_BAD_ARGUMENT : reset_axis(rt, rt->setpoint.lines, axis, position);
}

axisrt_c_status axisrt_c_reset_interface(axisrt_c* rt, uint32_t axis, double value) {
  return rt == NULL ? AXISRT_C_BAD_ARGUMENT : reset_axis(rt, rt->interface_port.lines, axis, value);
}

axisrt_c_status axisrt_c_reset_velocity(axisrt_c* rt, uint32_t axis, double v_set, double v_motor,
                                        double v_direct) {
  double velocities[4]; /* by the mode of a stage */
  uint32_t i;
  if (rt == NULL || axis >= rt->axis_count) return AXISRT_C_BAD_ARGUMENT;
  velocities[1] = v_direct;
  velocities[2] = v_motor;
  velocities[3] = v_set;
  for (i = 1; i <= 3; ++i) {
    if (!is_within(velocities[i], LARGEST_POSITION)) return AXISRT_C_BAD_INPUT;
  }
  for (i = 0; i < rt->stage_count; ++i) {
    if (rt->stages[i].axis == axis) reset_line(&rt->velocity.lines[i], velocities[rt->stages[i].mode]);
  }
  return AXISRT_C_OK;
}

axisrt_c_status axisrt_c_rebase(axisrt_c* rt, uint32_t axis, double offset) {
  line* l;
  if (rt == NULL || axis >= rt->axis_count) return AXISRT_C_BAD_ARGUMENT;
  l = &rt->setpoint.lines[axis];
  if (!l->reset_done) return AXISRT_C_NOT_RESET;
  if (!is_within(offset, LARGEST_POSITION) || !is_within(l->input + offset, LARGEST_POSITION))
    return AXISRT_C_BAD_INPUT;
  rebase_line(l, offset);
  return AXISRT_C_OK;
}

axisrt_c_status axisrt_c_step(axisrt_c* rt, const double* in, double* out, uint8_t* status) {
  if (rt == NULL || in == NULL || out == NULL) return AXISRT_C_BAD_ARGUMENT;
  return step_port(&rt->setpoint, in, out, status);
}

axisrt_c_status axisrt_c_step_interface(axisrt_c* rt, const double* in, double* out, uint8_t* status) {
  if (rt == NULL || in == NULL || out == NULL) return AXISRT_C_BAD_ARGUMENT;
  return step_port(&rt->interface_port, in, out, status);
}

/* v_add = - sum of weight * stage, within the limit. */
static uint8_t join_stages(const axisrt_c* rt, control* c) {
  uint8_t worst = AXISRT_C_OK;
  double sum = 0;
  uint32_t i;
  for (i = c->first_stage; i < c->first_stage + c->stage_count; ++i) {
    if (rt->stage_status[i] > worst) worst = rt->stage_status[i];
    sum -= rt->velocity.lines[i].reset_done ? rt->stages[i].weight * rt->stage_out[i] : 0;
  }
  sum = on_grid(sum);
  c->v_add = is_within(sum, c->limit) ? sum : bits_of(sum) >> 63 != 0 ? -c->limit : c->limit;
  return worst;
}

axisrt_c_status axisrt_c_step_velocity(axisrt_c* rt, const double* v_set, const double* v_motor,
                                       const double* v_direct, double* v_add, double* increments,
                                       uint8_t* status) {
  int worst = AXISRT_C_OK;
  uint32_t i;
  if (rt == NULL || v_set == NULL || v_motor == NULL || v_add == NULL) return AXISRT_C_BAD_ARGUMENT;
  for (i = 0; i < rt->stage_count; ++i) {
    uint32_t const mode = rt->stages[i].mode;
    const double* const from = mode == 3 ? v_set : mode == 1 && v_direct != NULL ? v_direct : v_motor;
    rt->stage_in[i] = from[rt->stages[i].axis];
  }
  step_port(&rt->velocity, rt->stage_in, rt->stage_out, rt->stage_status);
  for (i = 0; i < rt->axis_count; ++i) {
    v_add[i] = 0;
    if (increments != NULL) increments[i] = 0;
    if (status != NULL) status[i] = AXISRT_C_OK;
  }
  for (i = 0; i < rt->control_count; ++i) {
    control* const c = &rt->controls[i];
    uint8_t happened;
    if (c->source != i) continue;
    happened = join_stages(rt, c);
    if (status != NULL) status[c->axis] = happened;
    if (happened > worst) worst = happened;
  }
  for (i = 0; i < rt->control_count; ++i) {
    const control* const c = &rt->controls[i];
    v_add[c->axis] = rt->controls[c->source].v_add;
    if (increments != NULL) increments[c->axis] = v_add[c->axis] * c->scale;
  }
  return (axisrt_c_status)worst;
}

/* No increment to speak of for as many cycles as the slot remembers. */
static int is_at_rest(const slot* s) {
  uint32_t age;
  for (age = 1; age <= s->remembers; ++age) {
    if (!(magnitude(increment_of_age(s, age)) < MOTION)) return 0;
  }
  return 1;
}

typedef struct change {
  int action;
  const bank* to; /* null for OFF and the program's end */
} change;

static int reaches(const change* c, const slot* s) {
  int const guard =
      c->action == AXISRT_C_GUARD_OFF || (c->to != NULL && (c->to->parameters.keywords & KEYWORD_GUARD) != 0);
  if (c->action == AXISRT_C_PROGRAM_END) return 1;
  if (guard || s->family == FAMILY_GUARD) return guard && s->family == FAMILY_GUARD;
  if (c->to == NULL) return 1;
  return s->family == (uint32_t)((c->to->parameters.keywords & KEYWORD_HSC) != 0 ? FAMILY_HSC : FAMILY_FIR);
}

static uint32_t is_on_after(const change* c, const slot* s) {
  if (c->action == AXISRT_C_PROGRAM_END) return s->on_at_start;
  if (c->action == AXISRT_C_SET) return s->on;
  return c->action == AXISRT_C_ON;
}

static const kernel* kernel_after(const axisrt_c* rt, const change* c, const slot* s, uint32_t member) {
  if (!is_on_after(c, s)) return rt->kernels + rt->kernel_count;
  return c->to == NULL ? s->listed : rt->choices[c->to->first_choice + member];
}

static uint32_t fade_cycles(const axisrt_c* rt, const group* g, const change* c) {
  uint32_t const on = rt->banks[g->first_bank].fade_cycles, off = g->off_fade_cycles;
  if (c->to != NULL) return c->to->fade_cycles;
  if (c->action != AXISRT_C_PROGRAM_END) return off;
  if (on == 0 || off == 0) return 0;
  return on > off ? on : off;
}

axisrt_c_status axisrt_c_command(axisrt_c* rt, uint32_t index, axisrt_c_action action, uint32_t number) {
  change c;
  const group* g;
  uint32_t i, fade;
  int busy = 0, rests = 1, changes = 0;
  if (rt == NULL || index >= rt->group_count || (uint32_t)action > AXISRT_C_GUARD_OFF)
    return AXISRT_C_BAD_ARGUMENT;
  g = &rt->groups[index];
  c.action = (int)action;
  c.to = NULL;
  if (action == AXISRT_C_ON || action == AXISRT_C_SET) {
    if (number >= g->bank_count) return AXISRT_C_NO_BANK;
    c.to = &rt->banks[g->first_bank + number];
  }
  for (i = 0; i < g->member_count; ++i) {
    const slot* const s = rt->members[g->first_member + i];
    if (s == NULL) continue;
    busy = busy || is_fading(s);
    rests = rests && is_at_rest(s);
    changes = changes || (reaches(&c, s) && kernel_after(rt, &c, s, i) != s->now);
  }
  if (busy) return AXISRT_C_BUSY;
  fade = fade_cycles(rt, g, &c);
  if (changes && !rests && fade == 0) return AXISRT_C_NEEDS_STANDSTILL;
  for (i = 0; i < g->member_count; ++i) {
    slot* const s = rt->members[g->first_member + i];
    if (s == NULL || !reaches(&c, s)) continue;
    if (kernel_after(rt, &c, s, i) != s->now) switch_slot(s, kernel_after(rt, &c, s, i), rests ? 0 : fade);
    s->on = is_on_after(&c, s);
  }
  return AXISRT_C_OK;
}
