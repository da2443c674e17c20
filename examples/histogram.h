/* Durations by powers of two, in fixed memory. histogram_add costs some nanoseconds and may be called in the
 * cycle. */
#ifndef AXISRT_EXAMPLES_HISTOGRAM_H
#define AXISRT_EXAMPLES_HISTOGRAM_H

#include <stdint.h>

enum { histogram_classes = 32 };

typedef struct histogram {
  uint64_t counts[histogram_classes]; /* class i: below 2^i ns, class 0: nothing */
  uint64_t total;
  int64_t worst_ns;
} histogram;

void histogram_add(histogram* h, int64_t duration_ns);
/* Smallest power of two in ns below which `share` (0 to 1) of all durations are. */
int64_t histogram_quantile(const histogram* h, double share);
void histogram_print(const histogram* h, const char* name);

#endif
