/* Checks the bounds that a coefficient image claims: cc -std=c99 -O2 axim_check.c -lm && ./a.out mill.axim
 *
 * Written from docs/image-format.md alone: its section "Bounds" has the formulas. Shares nothing with axisc.
 * Exit status: 0 every claim holds, 1 one does not (record, field, claimed, computed), 2 not readable.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* clang-format off */
#define U 0x1p-53
#define SECOND (1 + 0x1p-20)
#define OUT (1 + 0x1p-18)
#define NONE 0xFFFFFFFFu
enum { AXES = 1, FILTERS, SECTIONS, KERNELS, TAILS, SLOTS, GROUPS, BANKS = 9, CHOICES, STAGES = 12, BOUNDS = 20 };
static const uint8_t *image, *table[32]; static uint32_t stride[32], count[32];
static uint64_t little_endian(const uint8_t *at, int size) {
  return size > 0 ? little_endian(at + 1, size - 1) << 8 | *at : 0;
}
static uint32_t u32(const uint8_t *at) { return (uint32_t)little_endian(at, 4); }
static uint64_t u64(const uint8_t *at) { return little_endian(at, 8); }
static double f64(const uint8_t *at) { uint64_t bits = u64(at); double x; return memcpy(&x, &bits, sizeof x), x; }
static void unreadable(const char *why) { printf("not readable: %s\n", why); exit(2); }
static const uint8_t *record(int kind, uint32_t index) {
  if (index >= count[kind]) unreadable("an index is outside its section");
  return table[kind] + (size_t)index * stride[kind];
}
static uint32_t crc32c(const uint8_t *bytes, size_t size, uint32_t crc) {
  while (size-- > 0) {
    crc ^= *bytes++;
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (0x82F63B78u & (0u - (crc & 1u)));
  }
  return crc;
}
static void open_image(size_t size) {
  static const uint8_t zero[4];
  if (size < 128 || memcmp(image, "AXIM\1", 6) != 0) unreadable("not an image of format 1");
  uint64_t total = u64(image + 16), header = u32(image + 8), end = header + 32 * (uint64_t)u32(image + 28);
  if (total > size || header < 128 || end > total) unreadable("cut off");
  uint32_t crc = crc32c(image + 16, end - 16, crc32c(zero, 4, crc32c(image, 12, ~0u)));
  int same = ~crc == u32(image + 12) && ~crc32c(image + end, total - end, ~0u) == u32(image + 24);
  if (!same) unreadable("it was changed after it was written");
  for (uint32_t i = 0; i < u32(image + 28); ++i) {
    const uint8_t *entry = image + header + 32 * (size_t)i;
    uint64_t offset = u64(entry + 8), bytes = u64(entry + 16); uint32_t kind = u32(entry); if (kind >= 32) continue;
    uint64_t records = (uint64_t)u32(entry + 24) * u32(entry + 28);
    if (offset > total || bytes > total - offset || bytes != records) unreadable("a section is outside the image");
    table[kind] = image + offset; stride[kind] = u32(entry + 24); count[kind] = u32(entry + 28);
  }
  if (table[BOUNDS] == NULL) unreadable("the image has no bounds");
}

/* What rounding takes from a + b, and from a b. */
static double lost_of_sum(double a, double b) { double y = (a + b) - a; return (a - ((a + b) - y)) + (b - y); }
static double lost_of_product(double a, double b) {
  double shift = 0x1p27 + 1, a1 = shift * a - (shift * a - a), b1 = shift * b - (shift * b - b), a2 = a - a1, b2 = b - b1;
  return ((a1 * b1 - a * b) + a1 * b2 + a2 * b1) + a2 * b2;
}

/* ---- B1 and B2: sections ---- */
typedef struct { double a[4]; } matrix; /* ee, er, re, rr */
typedef struct { /* stored, g = p + q; sums of what states do; sums for every unit of d; m (0: not certain), s */
  double p, g, lost_of_g, k, b, ee, er, re, rr, change, excess, following, passed, shrinking, scale;
} section;
/* The exact sign of a sum of products, in parts that do not overlap. */
static double parts[16]; static int part_count;
static void add_part(double x) {
  for (int i = 0; i < part_count; ++i) { double sum = x + parts[i]; parts[i] = lost_of_sum(x, parts[i]); x = sum; }
  parts[part_count++] = x;
}
static void add_product(double a, double b) { add_part(lost_of_product(a, b)); add_part(a * b); }
static int holds(double R, double k, double b, double c, double m) {
  part_count = 0; add_product(R, R); add_product(c, 1); add_product(-c, b);
  add_product(2 * m, R); add_product(-m * k, R); add_product(-m * b, R);
  while (part_count > 0 && parts[part_count - 1] == 0) --part_count;
  return part_count == 0 || parts[part_count - 1] > 0;
}
static int poles_are_within(double R, double k, double b) {
  return R == 0 ? k == 1 && b == 1 : holds(R, k, b, 1, 0) && holds(R, k, b, -1, 0) && holds(R, k, b, 1, 1) && holds(R, k, b, 1, -1);
}
typedef struct { double e, r, sum_e, sum_r, change; } walk;
static void walk_on(walk *w, double k, double b) {
  double r = w->r;
  w->sum_e += fabs(w->e); w->sum_r += fabs(r); w->e += r; w->r = (r - b * r) - k * w->e; w->change += fabs(w->r - r);
}
static double norm(matrix x) { return fmax(fabs(x.a[0]) + fabs(x.a[1]), fabs(x.a[2]) + fabs(x.a[3])); }
static matrix with_rest(matrix sum, double n) {
  double f = n / (1 - n) * OUT, of_e = (sum.a[0] + sum.a[1]) * f, of_r = (sum.a[2] + sum.a[3]) * f;
  return (matrix){{sum.a[0] + of_e, sum.a[1] + of_e, sum.a[2] + of_r, sum.a[3] + of_r}};
}
/* s, a power of two, with k/4 < s^2 <= k */
static double root_below(double k) { int exponent; frexp(k, &exponent); return ldexp(1, (int)floor((exponent - 1) / 2.0)); }
/* The sums of all |A^n| from the poles alone. */
static matrix from_poles(double k, double b) {
  double R = 1, mirrored = (4 - k) - 2 * b, near = fmin(k, mirrored), square = (near + b) * (near + b) / 4;
  for (double step = 0.5; step >= 0x1p-40; step /= 2) if (poles_are_within(R - step, k, b)) R -= step;
  double rest = 1 - R, doubt = 0x1p-48 * (near + square), least = (near - square) - doubt, sum = 1 / (rest * rest);
  if (least > 0) sum = 1 / (rest * fmax(rest, root_below(least)));
  else if (square - near > doubt && b <= 1) sum = 1 / near;
  double of_r = (1 / rest + 2 * root_below(k) * sum) * OUT;
  if (!(rest > 0)) return (matrix){{0x1p200, 0x1p200, 0x1p200, 0x1p200}};
  return (matrix){{1 + of_r, sum * OUT, k * sum * OUT, of_r}};
}
static section read_section(const uint8_t *at, int blocks) {
  double p = f64(at), q = f64(at + 8), g = p + q, k = f64(at + 16), b = f64(at + 24), s = root_below(k); int m = 0;
  if (!(k > 0 && b > 0 && b < 2 && 4 - k - 2 * b > 0)) unreadable("a section is not stable");
  walk of_e = {1, 0, 0, 0, 0}, of_r = {0, 1, 0, 0, 0}, of_d = {p, g - k * p - b * p, 0, 0, 0}; matrix power;
  do {
    for (int i = 0; i < 16; ++i, ++m) walk_on(&of_e, k, b), walk_on(&of_r, k, b), walk_on(&of_d, k, b);
    power = (matrix){{of_e.e, of_r.e * s, of_e.r / s, of_r.r}};
  } while (norm(power) > 0x1p-24 && m < 1 << 21);
  int ended = norm(power) <= 0x1p-24;
  matrix all = with_rest((matrix){{of_e.sum_e, of_r.sum_e * s, of_e.sum_r / s, of_r.sum_r}}, 0x1p-23), poles = {{0}};
  if (!ended) poles = from_poles(k, b), all = (matrix){{poles.a[0], poles.a[1] * s, poles.a[2] / s, poles.a[3]}};
  double row_e = (all.a[0] + all.a[1]) * (12 * U), row_r = (all.a[2] + all.a[3]) * (12 * U);
  double column_e = all.a[0] + all.a[2], column_r = all.a[1] + all.a[3], walked = of_d.sum_e * s + of_d.sum_r;
  section z = {.p = p, .g = g, .lost_of_g = lost_of_sum(p, q), .k = k, .b = b, .scale = s};
  z.ee = (all.a[0] + row_e * column_e) * OUT; z.er = (all.a[1] + row_e * column_r) / s * OUT;
  z.re = (all.a[2] + row_r * column_e) * s * OUT; z.rr = (all.a[3] + row_r * column_r) * OUT;
  z.change = (of_r.change + 2 * (row_r * column_r + (z.re * fabs(of_r.e) + z.rr * fabs(of_r.r)))) * OUT;
  z.excess = (of_d.sum_e + row_e / s * walked + z.ee * fabs(of_d.e) + z.er * fabs(of_d.r)) * OUT;
  z.following = (of_d.sum_r + row_r * walked + z.re * fabs(of_d.e) + z.rr * fabs(of_d.r)) * OUT;
  if (fmax(row_e, row_r) > 0x1p-20) {
    double r = fabs(g - k * p - b * p) + 4 * U * (fabs(g) + (k + b) * fabs(p)); poles = from_poles(k, b);
    z.ee = poles.a[0]; z.er = poles.a[1]; z.re = poles.a[2]; z.rr = poles.a[3]; z.change = 2 * z.rr;
    z.excess = z.ee * fabs(p) + z.er * r; z.following = z.re * fabs(p) + z.rr * r;
  }
  z.passed = (blocks ? fabs(p) : fabs(1 + p)) + z.following;
  z.shrinking = ended && fmax(row_e, row_r) <= 0x1p-25 ? m : 0; return z;
}

/* ---- The chain and its kernel ---- */
typedef struct { int first, count, delay, blocks, shared; double share, direct, lost_of_direct, base; } filter;
static filter filters[3]; static section sections[18];
static int filter_count, section_count, certain, tail_count, before;
static double final_value, delays, tails[1024], tail_sum, tap_sum;
static void read_chain(uint32_t first, uint32_t filter_total) {
  if (filter_total > 3) unreadable("a chain is too long");
  filter_count = section_count = 0; certain = 1; final_value = 1; delays = 0;
  for (uint32_t i = 0; i < filter_total; ++i) {
    const uint8_t *at = record(FILTERS, first + i);
    uint32_t realisation = u32(at + 12), total = u32(at + 28), delay = u32(at + 32);
    if (total > 6 || delay > 100) unreadable("a filter is too long");
    if (realisation == 0 || (realisation == 2 && delay == 0)) continue;
    filter *f = &filters[filter_count++]; f->first = section_count; f->count = (int)total;
    f->delay = realisation == 2 ? (int)delay : 0; f->blocks = u32(at + 20) != 0; f->share = f64(at + 48);
    f->direct = f64(at + 56); f->shared = f->share != 1 && f->direct != 1; f->base = final_value;
    f->lost_of_direct = lost_of_sum(1, -f->share);
    if (f->blocks) final_value *= f->direct;
    delays += f->delay;
    for (uint32_t j = 0; j < total; ++j) {
      section *s = &sections[section_count++];
      *s = read_section(record(SECTIONS, u32(at + 24) + j), f->blocks); certain = certain && s->shrinking > 0;
    }
  }
}
static double tail(int j) { return j < tail_count ? tails[j] : 0; }
static double tap(int j) { return (j == 0 ? 1 : tail(j - 1)) - tail(j); }
static void read_kernel(uint32_t kernel, int is_before) {
  tail_count = 0; tail_sum = 0; tap_sum = 1; before = is_before;
  if (kernel == NONE) return;
  const uint8_t *at = record(KERNELS, kernel); tail_count = (int)u32(at + 20); tap_sum = 0;
  if (u32(at + 20) > 960) unreadable("a kernel is too long");
  for (int j = 0; j < tail_count; ++j) tails[j] = f64(record(TAILS, u32(at + 16) + (uint32_t)j));
  for (int j = 0; j <= tail_count; ++j) tail_sum += fabs(tail(j)), tap_sum += fabs(tap(j));
  tail_sum *= SECOND; tap_sum *= SECOND;
}

/* ---- B3: the response ---- */
/* A number, and what roundings took from it in a run of `keep` cycles; other runs (0) do not keep that. */
typedef struct { double value, lost; } kept;
static int keep;
static kept plus(kept a, kept b) {
  return (kept){a.value + b.value, keep ? (a.lost + b.lost) + lost_of_sum(a.value, b.value) : 0};
}
static kept product(double a, double lost, kept x) {
  return (kept){a * x.value, keep ? (a * x.lost + lost * x.value) + lost_of_product(a, x.value) : 0};
}
static double rounded(kept x) { return x.value + x.lost; }
static double whole(kept x) { return fabs(x.value) + fabs(x.lost); }
typedef struct { double d[2], de[2], e[2], r[2]; } sizes; /* [0] per increment, [1] per distance from rest */
typedef struct { kept excess, d; } signal;
typedef struct { double excess, d; } left;
typedef struct { int cycles, ended; double gain, gain_rest, distance, distance_rest, highest, output[2]; sizes of[18]; } response;
static struct { kept e, r, d, de; } state[18]; static signal ring[3][100]; static int ring_at[3];
static void add_size(double z[2], kept *last, kept x) {
  double now = keep ? x.lost : x.value, then = keep ? last->lost : last->value;
  z[0] += fabs(now); z[1] += fabs(now - then); *last = x;
}
static kept run_section(int i, kept d, sizes *z) {
  const section *s = &sections[i];
  kept de = plus(product(s->p, 0, d), state[i].r), e = plus(state[i].e, de);
  kept r = plus(product(s->g, s->lost_of_g, d), product(-s->k, 0, e)); r = plus(state[i].r, plus(r, product(-s->b, 0, de)));
  add_size(z->d, &state[i].d, d); add_size(z->de, &state[i].de, de);
  add_size(z->e, &state[i].e, e); add_size(z->r, &state[i].r, r); return de;
}
static kept shared(const filter *f, kept y, kept x) {
  return plus(product(f->share, 0, y), product(f->direct, f->lost_of_direct, x));
}
static signal run_chain(signal x, response *to) {
  for (int i = 0; i < filter_count; ++i) {
    const filter *f = &filters[i]; signal y = x;
    for (int k = f->first; k < f->first + f->count; ++k) {
      kept de = run_section(k, y.d, &to->of[k]);
      y.d = f->blocks ? de : plus(y.d, de); y.excess = f->blocks ? state[k].e : plus(y.excess, state[k].e);
    }
    if (f->delay > 0) y = ring[i][ring_at[i]], ring[i][ring_at[i]] = x, ring_at[i] = (ring_at[i] + 1) % f->delay;
    x.excess = shared(f, y.excess, x.excess); x.d = shared(f, y.d, x.d);
  }
  return x;
}
static void add_rest(double z[2], double last, double rest) { z[0] += rest; z[1] += 2 * rest + fabs(last); }
/* What is left after the chain, which is added to the sizes where they are given. */
static left rest_of_chain(response *to) {
  left x = {0, 0};
  for (int i = 0; i < filter_count; ++i) {
    const filter *f = &filters[i]; left y = {f->blocks ? 0 : x.excess, x.d};
    for (int k = f->first; k < f->first + f->count; ++k) {
      const section *s = &sections[k];
      double re = s->re * whole(state[k].e) + s->rr * whole(state[k].r);
      double ee = s->ee * whole(state[k].e) + s->er * whole(state[k].r) + s->excess * y.d;
      if (to != NULL) {
        add_rest(to->of[k].d, state[k].d.value, y.d); add_rest(to->of[k].e, 0, ee);
        add_rest(to->of[k].de, state[k].de.value, re + (fabs(s->p) + s->following) * y.d);
        add_rest(to->of[k].r, state[k].r.value, re + s->following * y.d); to->of[k].e[1] = to->of[k].de[0];
      }
      y.excess = f->blocks ? ee : y.excess + ee; y.d = re + s->passed * y.d;
    }
    for (int k = 0; k < f->delay; ++k) y.excess += whole(ring[i][k].excess), y.d += whole(ring[i][k].d);
    x.excess = f->share * y.excess + f->direct * x.excess; x.d = f->share * y.d + f->direct * x.d;
  }
  return x;
}
static void add_exactly(double sum[2], double x) { sum[1] += lost_of_sum(sum[0], x); sum[0] += x; }
static void respond(response *to) {
  double gain[2] = {0, 0}, distance[2] = {0, 0}, change = 0, last = 0;
  left rest = {0, 0}; int n = 0; memset(to, 0, sizeof *to); memset(state, 0, sizeof state); to->highest = -final_value;
  for (int i = 0; i < filter_count; ++i) {
    ring_at[i] = 0;
    for (int k = 0; k < filters[i].delay; ++k) ring[i][k] = (signal){{-filters[i].base, 0}, {0, 0}};
  }
  while (!to->ended && n < 1 << 22) {
    for (int end = n + 64; n < end; ++n) {
      kept all = {n == 0 ? 1 : tail(n - 1), 0}, passed = {-tail(n), 0};
      signal x = run_chain((signal){passed, plus(all, passed)}, to);
      double d = rounded(x.d), excess = rounded(x.excess);
      add_exactly(gain, fabs(d)); add_exactly(distance, fabs(excess)); change += fabs(d - last);
      last = d; to->highest = fmax(to->highest, excess);
    }
    if (n <= tail_count) continue;
    rest = rest_of_chain(NULL); to->gain = gain[0] + gain[1]; to->distance = distance[0] + distance[1];
    to->ended = keep ? n == keep : rest.d <= 0x1p-44 * to->gain && rest.excess <= 0x1p-44 * to->distance;
  }
  if (!keep) rest_of_chain(to);
  to->cycles = n; to->gain_rest = rest.d * SECOND; to->distance_rest = rest.excess * SECOND;
  to->output[0] = to->gain + rest.d; to->output[1] = change + 2 * rest.d + fabs(last);
}

/* ---- B4: rounding ---- */
typedef struct { double error, of_d, of_sum, of_setpoint, sum; } rounding;
/* `x`: 0 for sizes per increment, 1 per distance; an error behind the chain counts `to_sum` and `to_d`. */
static rounding rounding_of(const sizes *of, double sum, double d, int x, double to_sum, double to_d) {
  double sums[4] = {sum}, ds[4] = {d}, in_sum[3], in_d[3];
  for (int i = 0; i < filter_count; ++i) {
    const filter *f = &filters[i]; const sizes *end = &of[f->first + f->count - 1];
    in_sum[i] = f->blocks ? end->e[x] : sums[i];
    for (int k = f->first; !f->blocks && k < f->first + f->count; ++k) in_sum[i] += of[k].e[x];
    in_d[i] = f->delay > 0 ? ds[i] : f->blocks ? end->de[x] : end->d[x] + end->de[x];
    sums[i + 1] = f->share * in_sum[i] + f->direct * ((f->delay > 0 ? (x ? 2 : f->delay) : 0) + sums[i]);
    ds[i + 1] = f->share * in_d[i] + f->direct * ds[i];
  }
  rounding z = {0, to_d, to_sum, 1, sums[filter_count]};
  for (int i = filter_count - 1; i >= 0; --i) {
    const filter *f = &filters[i];
    double of_share = f->shared ? 4 * f->share + 0x1p-9 : 0;
    double of_direct = f->shared ? (f->delay > 0 ? 5 : 4) * f->direct + 0x1p-9 : 0;
    const rounding behind = z;
    if (f->delay > 0) {
      double path = (x ? 2 : f->delay) + sums[i], both = f->share + f->direct;
      z.error += (of_share + of_direct) * (path * z.of_sum + ds[i] * z.of_d);
      z.of_sum *= both; z.of_d *= both; z.of_setpoint *= both; continue;
    }
    z.error += (of_share * in_sum[i] + of_direct * sums[i]) * z.of_sum + (of_share * in_d[i] + of_direct * ds[i]) * z.of_d;
    z.of_sum *= f->share; z.of_d *= f->share; z.of_setpoint *= f->share;
    for (int k = f->first + f->count - 1; k >= f->first; --k) {
      const section *s = &sections[k];
      double D = of[k].d[x], DE = of[k].de[x], E = of[k].e[x], R = of[k].r[x];
      double to_e = f->blocks && k < f->first + f->count - 1 ? 0 : z.of_sum;
      if (!f->blocks) z.error += in_sum[i] * z.of_sum + (D + DE) * z.of_d;
      in_sum[i] -= E;
      double p = fabs(s->p) < 0x1p-44 ? 1 + 0x1p53 : 1, g = fabs(s->g) < 0x1p-62 ? 4 + 0x1p53 : 4;
      double of_r = to_e * s->er + z.of_d * s->rr;
      z.error += (p * fabs(s->p) * D + DE) * (to_e * s->rr + z.of_d * (1 + s->change));
      z.error += E * (to_e * (s->ee - 1) + z.of_d * s->re);
      z.error += (g * fabs(s->g) * D + 3 * s->k * E + 2 * s->b * DE + R) * of_r;
      z.of_d = to_e * s->excess + s->passed * z.of_d; z.of_setpoint *= s->passed;
    }
    z.of_sum = (f->blocks ? 0 : z.of_sum) + f->direct * behind.of_sum; z.of_d += f->direct * behind.of_d;
    z.of_setpoint += f->direct * behind.of_setpoint;
  }
  z.error *= U * SECOND; return z;
}
static double rounding_error(const response *alone, const response *joint, int x) {
  double d = x ? 2 : 1, of_kernel = (10.0 * tail_count + 16) * tail_sum + 0x1p-60, more;
  rounding z; if (tail_count == 0) {
    z = rounding_of(alone->of, 0, d, x, 1, 0); more = d * z.of_d;
  } else if (before) {
    z = rounding_of(joint->of, tail_sum * d, tap_sum * d, x, 1, 0);
    more = d * (tail_sum * z.of_sum + tap_sum * z.of_d + of_kernel * z.of_setpoint + tail_sum * z.of_sum +
                (1 + 2 * tap_sum) * z.of_d);
  } else {
    z = rounding_of(alone->of, 0, d, x, 1, tail_sum);
    more = d * z.of_d + of_kernel * alone->output[x] + (z.sum + tail_sum * alone->output[x]);
  }
  return z.error + U * SECOND * more;
}

/* ---- B6: standstill ---- */
/* The least n >= 0 with x <= 2^n. */
static int bits_of(double x) { int n; double share = frexp(x, &n); n -= share == 0.5; return n > 0 ? n : 0; }
static double rest_cycles(const sizes *of) {
  double cycles = 1 + delays + (tail_count > 0 ? 2 * tail_count + 16 : 0);
  for (int i = 0; i < section_count; ++i) {
    const section *s = &sections[i];
    double state_size = fmax(s->scale * of[i].e[1], of[i].r[1]);
    double growth = fmax(s->ee + s->er * s->scale, s->re / s->scale + s->rr);
    int bits = 54 + 501 + bits_of(state_size) + bits_of(1 / s->scale) + bits_of(growth);
    cycles += (bits + 22) / 23 * s->shrinking + 6;
  }
  return cycles;
}

/* ---- The records ---- */
static uint32_t at_record, failures;
static void claim(const char *field, double claimed, double computed, int holds_true) {
  if (!holds_true) printf("record %u: %s claims %.17g, computed %.17g\n", (unsigned)at_record, field, claimed, computed);
  failures += !holds_true;
}
static void at_least(const uint8_t *r, int offset, const char *field, double bound, int claimable) {
  double claimed = f64(r + offset);
  claim(field, claimed, bound, claimable ? claimed >= bound && claimed < HUGE_VAL : claimed == 0);
}
static double limit_of(uint32_t axis) { return f64(record(AXES, axis) + 48) * 10 * (u32(image + 32) * 1e-9); }
/* The record of a chain: port 0 with a kernel, 1, or 2 with a stage. */
static double check(uint32_t axis, uint32_t port, uint32_t kernel, uint32_t stage, int is_before) {
  static response alone, joint, again;
  if (at_record >= count[BOUNDS]) { printf("record %u is missing\n", (unsigned)at_record), exit(1); }
  const uint8_t *r = record(BOUNDS, at_record), *a = port == 2 ? record(STAGES, stage) : record(AXES, axis);
  int is_due = u32(r) == axis && u32(r + 4) == port && u32(r + 8) == kernel && u32(r + 20) == stage;
  claim("key", u32(r + 8), kernel, is_due);
  const uint8_t *range = a + (port == 0 ? 20 : port == 1 ? 28 : 8);
  if (kernel == NONE) read_chain(u32(range), u32(range + 4)), read_kernel(NONE, is_before), respond(&alone);
  read_kernel(kernel, is_before);
  if (tail_count > 0) respond(&joint);
  const response *run = tail_count > 0 ? &joint : &alone, *sums = run;
  const sizes *executed = tail_count > 0 && before ? joint.of : alone.of;
  double gain_error = 0, distance_error = 0, radius = f64(r + 56), W[2] = {0, 0};
  int exact = section_count == 0 && tail_count == 0;
  for (int i = 0; i < filter_count; ++i) exact = exact && !filters[i].shared;
  if (!exact) {
    rounding to_d = rounding_of(run->of, tail_sum, tap_sum, 0, 0, 1);
    rounding to_sum = rounding_of(run->of, tail_sum, tap_sum, 0, 1, 0);
    gain_error = to_d.error + U * SECOND * tap_sum * to_d.of_d;
    distance_error = to_sum.error + U * SECOND * tap_sum * to_sum.of_d;
    if (run->ended && gain_error > 0x1p-32 * run->gain) {
      keep = run->cycles; respond(&again); keep = 0; sums = &again;
      gain_error = 8 * (rounding_of(again.of, 0, U * tap_sum, 0, 0, 1).error + 8 * U * gain_error);
      distance_error = 8 * (rounding_of(again.of, 0, U * tap_sum, 0, 1, 0).error + 8 * U * distance_error);
    }
    gain_error += 4 * U * sums->gain; distance_error += 4 * U * sums->distance;
  }
  uint32_t flags = run->ended && certain ? 0 : 1; claim("flags", u32(r + 12), flags, u32(r + 12) == flags);
  claim("cycles", u32(r + 16), run->cycles, u32(r + 16) == (uint32_t)run->cycles);
  double low = f64(r + 24), more = distance_error + sums->distance_rest;
  claim("gain_low", low, sums->gain - gain_error, low == 0 || (low > 0 && low <= sums->gain - gain_error));
  at_least(r, 32, "gain_high", sums->gain + (gain_error + sums->gain_rest), 1);
  at_least(r, 40, "overshoot_high", final_value > 0 ? (fmax(sums->highest, 0) + more) / final_value : 0, 1);
  at_least(r, 48, "distance_high", final_value == 1 ? sums->distance + more : 0, 1);
  for (int i = 0; i < section_count; ++i) {
    claim("radius_high", radius, NAN, radius <= 1 && poles_are_within(radius, sections[i].k, sections[i].b));
    for (int x = 0; x < 2; ++x) W[x] = fmax(W[x], fmax(executed[i].e[x], executed[i].r[x]));
  }
  at_least(r, 56, "radius_high", 0, 1);
  double E = rounding_error(&alone, run, 0);
  at_least(r, 64, "rounding_increment", E, certain);
  at_least(r, 72, "rounding_position", rounding_error(&alone, run, 1), certain);
  at_least(r, 80, "state_increment", W[0] * SECOND, certain);
  at_least(r, 88, "state_position", W[1] * SECOND, certain);
  double rests = flags == 0 ? rest_cycles(executed) : 0, claimed = (double)u64(r + 96);
  claim("rest_cycles", claimed, rests, flags == 0 ? claimed >= rests : claimed == 0);
  at_least(r, 104, "limit_error", port == 0 ? E * limit_of(axis) : 0, certain); ++at_record;
  return f64(r + 32);
}

/* B7: what fades from one kernel of an axis to another add, as shares of its limits. */
static void check_fade(double gain, uint32_t from, uint32_t to, double F, uint32_t axis) {
  static double other[1024];
  double T = u32(image + 32) * 1e-9, a = f64(record(AXES, axis) + 56) * 1e4 * T * T, v = limit_of(axis), L = 0;
  if (F == 0 || !(v > 0) || !(a > 0)) return;
  read_kernel(from, 0); for (int j = 0; j < 1024; ++j) other[j] = tail(j);
  read_kernel(to, 0); for (int j = 0; j < 1024; ++j) L += gain * fabs(other[j] - tail(j));
  double most = fmax(15 / (8 * F) * L, 10 / sqrt(3) / (F * F) * L * (v / a) + 15 / (4 * F) * L);
  claim("change of kernels", 0.25, most, most <= 0.25 * (1 + 0x1p-30));
}
/* Kernel i of those that an axis can execute, the lists' and its channel's; NONE at their end. */
static uint32_t kernel_of(const uint8_t *slot, uint32_t i) {
  if (i == 0 || u32(slot + 24) == NONE) return i == 0 ? u32(slot + 12) : NONE;
  const uint8_t *group = record(GROUPS, u32(slot + 24)), *bank = record(BANKS, u32(group + 16) + i - 1);
  return u32(record(CHOICES, u32(bank + 32) + u32(slot + 28) - u32(group + 8)));
}
static void check_axis(uint32_t axis) {
  const uint8_t *slot = NULL, *a = record(AXES, axis), *group = NULL;
  for (uint32_t i = 0; i < count[SLOTS]; ++i) if (u32(record(SLOTS, i)) == axis) slot = record(SLOTS, i);
  if (slot != NULL && u32(slot + 24) != NONE) group = record(GROUPS, u32(slot + 24));
  uint32_t family = slot != NULL ? u32(slot + 4) : 0, banks = group != NULL ? u32(group + 20) : 0;
  double gain = u32(a + 24) > 0 || slot != NULL ? check(axis, 0, NONE, 0, 0) : 1;
  for (uint32_t last = NONE, next; slot != NULL; last = next) {
    next = NONE;
    for (uint32_t i = 0, kernel; i <= banks; ++i) {
      if (kernel = kernel_of(slot, i), (last == NONE || kernel > last) && kernel < next) next = kernel;
    }
    if (next == NONE) break;
    check(axis, 0, next, 0, family == 1);
  }
  for (uint32_t from = 0; group != NULL && from <= banks + 1; ++from) {
    uint32_t start = from > banks ? NONE : kernel_of(slot, from);
    check_fade(gain, start, NONE, u32(group + 24), axis);
    for (uint32_t i = 1; i <= banks; ++i) {
      const uint8_t *bank = record(BANKS, u32(group + 16) + i - 1); uint32_t keywords = u32(bank);
      if ((keywords & 32 ? 3u : keywords & 16 ? 1u : 2u) != family) continue;
      check_fade(gain, start, kernel_of(slot, i), u32(bank + 36), axis);
    }
  }
  if (u32(a + 32) > 0) check(axis, 1, NONE, 0, 0);
}

int main(int arguments, char **argument) {
  FILE *file = arguments == 2 ? fopen(argument[1], "rb") : NULL;
  if (file == NULL) unreadable("usage: axim_check IMAGE");
  fseek(file, 0, SEEK_END); size_t size = (size_t)ftell(file); rewind(file);
  uint8_t *bytes = calloc(size + 256, 1); /* no record reaches farther */
  if (bytes == NULL || fread(bytes, 1, size, file) != size) unreadable("the file cannot be read");
  image = bytes; open_image(size);
  for (uint32_t axis = 0; axis < count[AXES]; ++axis) check_axis(axis);
  for (unsigned i = 0; i < count[STAGES]; ++i) check(u32(record(FILTERS, u32(record(STAGES, i) + 8))), 2, NONE, i, 0);
  claim("bounds", count[BOUNDS], at_record, at_record == count[BOUNDS]);
  return failures == 0 ? printf("verified: %u records\n", (unsigned)at_record), 0 : 1;
}
