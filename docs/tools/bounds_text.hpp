// The section "Bounds" of docs/image-format.md: enough to write a program that checks them.
#pragma once

#include <string_view>

namespace axisc::docs {

inline constexpr std::string_view bounds_text =
    R"(
## Bounds

The section `bounds` states what holds for every input; [certificate](certificate.md) says what that is worth. It is written
unless `compile --no-bounds` leaves it out; `--strip` keeps it. A reader may skip it. Records are in this order: axis by axis
that of the setpoint chain without a kernel, then those with each kernel that its slot can execute (the slot's own and those
of its channel's banks) by rising number, then that of the additional interface; after all axes one for each stage. An axis
without a filter and without a slot has none for its setpoints.

They follow from the stored coefficients alone, by the recursions below, in doubles with every operation rounded; u is 2^-53,
M is 1 + 2^-20, O is 1 + 2^-18. What is a sum below is a sum over all cycles; what is called a bound is at least that, roundings
of its computation included. Upper bounds are stored as B (1 + 2^-41), rounded up to 40 significant bits, `gain_low` as
B (1 - 2^-41), rounded down likewise, so that computations that differ in their last bits agree: a checker demands B of its own
or more. Values that need no rounding (chains of pure delays) are stored as they are.

### Sections

With g = p + q, a section that is left alone moves by `e' = e + r, r' = r - b r - k e'`. Three walks follow these states: from
(1, 0), from (0, 1), and from (p, g - k p - b p), which an increment of 1 leaves. s is the largest power of two with s^2 <= k.
m is the first multiple of 16 cycles after which, in the scaled matrix of the first two walks,

    [ e1     s e2 ]
    [ r1/s     r2 ]

both rows have a sum of magnitudes of at most 2^-24; at most 2^21. The sums of |e| and |r| over the m cycles before that, scaled
alike, are F. With f = n/(1 - n), n = 2^-23, each element of F becomes larger by the sum of its row times f O: that bounds
all later cycles. Then, with w = 12 u times the sum of each row, and c the sum of each column, each element becomes larger
by its w c: what roundings of the walks may have hidden. Times O, and scaled back (er divided by s, re times s), these are ee, er,
re, rr: the sums of |e| and of |r| from the state (1, 0) are ee and re, from (0, 1) er and rr. Further

    change    = (sum of |r[n+1] - r[n]| of walk 2 + 2 (w_r c_r + re |e2| + rr |r2|)) O
    excess    = (sum of |e| of walk 3 + w_e/s W + ee |e3| + er |r3|) O          W = s sum of |e| + sum of |r| of walk 3
    following = (sum of |r| of walk 3 + w_r W + re |e3| + rr |r3|) O
    passed    = |1 + p| + following;  |p| + following where the constant part is blocked

with e1 ... r3 the states after m cycles. The section is certain if the walk ended, and both w are at most 2^-25: then m cycles shrink
the scaled states to 2^-23, roundings included. Where 2^21 cycles do not suffice, or a w exceeds 2^-20, the poles alone give the
sums. With R of `radius_high`, of this section, t = 1 - R, h the smaller of k and 4 - k - 2b, f = (h + b)^2/4, v = 2^-48 (h + f), and the largest
powers of two y and z with y^2 <= h - f - v and z^2 <= k:

    U = 1/(t max(t, y))  where h - f > v;   1/h  where f - h > v and b <= 1;   1/t^2  else
    ee = 1 + rr      er = U O      re = k U O      rr = (1/t + 2 z U) O

Without an end they take the place of F, in scaled form, and the rest is as above. With such a w all is theirs: change = 2 rr,
excess = ee |p| + er r, following = re |p| + rr r, r = |g - k p - b p| + 4 u (|g| + (k + b) |p|). If R is 1, all four are 2^200.

`radius_high` is R with |1 - b| <= R^2 and |2 - k - b| R <= R^2 + 1 - b for all sections, decided without rounding, or 0 where k = b = 1.

### Response

The chain's filters follow a unit step through the kernel: increments b_j, value 1 - S_n, whatever the order of filters and kernel.
With the value as an excess over its final value (a pure delay begins with the negative of the final value before it):

    de = p d + r     e = e + de     r = r + (g d - k e - b de)     d = d + de, excess = excess + e     (blocked: d = de, excess = e)
    out = share y + direct x, for increments and excesses                                        (y: behind sections or delay)

What is left of the sums of |excess| and |d| after a filter, from X and D before it and the states now, section by section:

    X = X + ee |e| + er |r| + excess D  (blocked: without X)      D = re |e| + rr |r| + passed D      out = share y + direct x

and a delay adds the magnitudes that it holds. N is the first multiple of 64 above the kernel's tail count where D <= 2^-44 gain and
X <= 2^-44 distance, the sums of |d| and |excess| so far; at most 2^22. If it does not end, or a section is not certain, bit 0 of
`flags` is set, and `rest_cycles` is 0; if a section is not certain, so are the fields about rounding, states and `limit_error`.

    gain_low, gain_high = gain - Ed,  gain + Ed + M D           Ed: errors of the run, below; both sums are compensated
    distance_high       = distance + Ex + M X                   0 where the final value is not 1
    overshoot_high      = (largest excess or 0 + Ex + M X) / final value;   0 where that is 0

A response that ended, but whose Ed is more than 2^-31 of the gain (chains of band-passes that let next to nothing through,
sections with poles next to -1), is run again for the same N cycles with a second part in each number, its loss: that of a sum is
the losses of both and what rounding takes from the sum, exactly; that of c x is c times the loss of x, the loss of c times x, and what
rounding takes from the product. g has the loss of p + q, direct that of 1 - share, and b_j that of its difference. gain, distance and
the largest excess are those of value plus loss, D and X those of both parts' magnitudes. With Ld, Lx the errors below for sizes of
losses, beginning with 0 and u B: Ed = 8 (Ld + 8 u Ed), Ex = 8 (Lx + 8 u Ex). All other fields are those of the first run.

### Rounding

The *size* of a signal is the most it reaches for every unit of the largest increment: the sum of its magnitudes in a response
(`_increment`); or of the largest distance from rest: the sum of the magnitudes of its changes from one cycle to the next
(`_position`; that of e is the increment size of de). D, DE, E, R are those of d, de, e, r of a section. What is left is added:
l to the first, 2 l + |last value| to the second, where l is D for d, `re|e| + rr|r| + (|p| + following) D` for de, without |p| for r, and what X gains for e.
They are taken from the run that the runtime makes: for FIR kernels and guards, which act last, the one without a kernel.

Each operation errs by u times the size of its result. Going backwards from the end of the chain, y is what an error of the sum
there does to the result, and z what one of the increment does; sizes S of the sum and d of the increment are known from
going forwards (S + E of all sections; `share y + direct x`; behind a delay of C cycles the path C, or 2 for positions, adds to
direct's part). The error is u M times the sum of, for each section in falling order (y, z after it, times share in its filter):

    S y + (D + DE) z                                      S with this section's E; not where the constant part is blocked
    (|p| D + DE) (y rr + z (1 + change))                  de; |p| counts 2^53 more where it is below 2^-44
    E (y (ee - 1) + z re)                                 e
    (4 |g| D + 3 k E + 2 b DE + R) (y er + z rr)          r; |g| counts 2^53 more where it is below 2^-62
    then  z = y excess + passed z                         y is 0 for all but the last section where the constant part is blocked

of each share other than 0 and 1 `(4 share + 2^-9) S_y + (4 direct + 2^-9) S_x` times y and the same of increments times z, with the sizes
behind the sections and before the filter; of a delay `(4 share + 5 direct + 2^-8)` times (path + S) y + d z. Before the filter
y = share y + direct y (blocked: direct y alone), z = z + direct z; a delay multiplies both by share + direct. To all that, with
T = M sum of |S_j|, B = M sum of |b_j|, c = 1, or 2 for positions, and h the product of the filters' gains (share times each section's `passed`, and direct):

    no kernel            c z
    kernel before        c (T y + B z + K h + T y + (1 + 2 B) z)          sum and increment begin with c T and c B
    kernel behind        c z + K o + (S + T o)                            z begins with T; o: size of the output's increment
    K = (10 tails + 16) T + 2^-60

u M times this is the whole, E_v or E_x. The errors of a run are the same with y = 1, z = 0 for Ex and y = 0, z = 1 for Ed,
beginning with T and B, plus u M B z, and at last 4 u times the sum itself. `state_...` is M times the largest E or R of any section.

### Standstill

    rest_cycles = 1 + delays + (2 tails + 16 with a kernel) + the sum over all sections of  m ceil((54 + 501 + l1 + l2 + l3)/23) + 6

with l1 the whole number above log2 of the larger of s E and R (position sizes), l2 of 1/s, l3 of the larger row of the scaled ee ... rr; 0 at least.

### Changes

Not stored, and to be checked with `gain_high` g of the chain without a kernel: for each fade of F cycles that a slot's channel has,
from any kernel A of the slot to the one that it leads to, L = g sum of |S_A - S_B| fulfils the inequalities of "Channels, banks and fades", within 2^-30.
)";

}  // namespace axisc::docs
