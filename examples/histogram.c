#include "histogram.h"

#include <stdio.h>

void histogram_add(histogram* h, int64_t duration_ns) {
  int index = 0;
  int64_t rest = duration_ns > 0 ? duration_ns : 0;
  for (; rest > 0 && index < histogram_classes - 1; rest >>= 1) ++index;
  ++h->counts[index];
  ++h->total;
  if (duration_ns > h->worst_ns) h->worst_ns = duration_ns;
}

int64_t histogram_quantile(const histogram* h, double share) {
  uint64_t below = 0;
  int index = 0;
  for (index = 0; index < histogram_classes; ++index) {
    below += h->counts[index];
    if ((double)below >= share * (double)h->total) break;
  }
  return (int64_t)1 << index;
}

void histogram_print(const histogram* h, const char* name) {
  static const char bar[] = "##################################################";
  int index = 0;
  printf("%s: %llu cycles, 99.9 %% below %.3f us, worst %.3f us\n", name, (unsigned long long)h->total,
         (double)histogram_quantile(h, 0.999) / 1e3, (double)h->worst_ns / 1e3);
  for (index = 0; index < histogram_classes; ++index) {
    int length = 0;
    if (h->counts[index] == 0) continue;
    length = (int)((double)h->counts[index] * (double)(sizeof bar - 1) / (double)h->total);
    printf("  < %11.3f us %10llu %.*s\n", (double)((int64_t)1 << index) / 1e3,
           (unsigned long long)h->counts[index], length, bar);
  }
}
