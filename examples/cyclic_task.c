/* A real-time task with a cycle of 1 ms: filters moving setpoints and shows how late it woke and what the
 * filters cost.
 *
 *   cyclic_task IMAGE [CYCLES [PRIORITY]]
 *
 * On a kernel with PREEMPT_RT and the right to do so (root, or limits for memlock and rtprio) its memory is
 * locked and its scheduling is SCHED_FIFO; without, it says so and runs all the same.
 */
#define _POSIX_C_SOURCE 200809L
#include "axisrt.h"
#include "histogram.h"
#include "image_file.h"

#include <errno.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>

enum { cycle_time_ns = 1000000, most_axes = 64 };

typedef struct task {
  axisrt* runtime;
  histogram latency; /* from the planned to the real beginning of a cycle */
  histogram cost;    /* of axisrt_step */
  uint64_t overruns; /* cycles that ended after the next one began */
  axisrt_status worst;
} task;

static int64_t since(const struct timespec* from, const struct timespec* to) {
  return (int64_t)(to->tv_sec - from->tv_sec) * 1000000000 + (to->tv_nsec - from->tv_nsec);
}

static void advance(struct timespec* time, long nanoseconds) {
  time->tv_nsec += nanoseconds;
  if (time->tv_nsec < 1000000000) return;
  time->tv_nsec -= 1000000000;
  ++time->tv_sec;
}

/* Before the cycle begins: afterwards nothing may wait for the disk or for other tasks. */
static void become_real_time(int priority) {
  struct sched_param scheduling;
  memset(&scheduling, 0, sizeof scheduling);
  scheduling.sched_priority = priority;
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) fprintf(stderr, "memory is not locked: %s\n", strerror(errno));
  if (sched_setscheduler(0, SCHED_FIFO, &scheduling) != 0)
    fprintf(stderr, "no real-time scheduling: %s\n", strerror(errno));
}

static void run(task* t, int cycles) {
  double in[most_axes] = {0};
  double out[most_axes] = {0};
  uint8_t status[most_axes] = {0};
  const uint32_t axes = axisrt_axis_count(t->runtime);
  struct timespec planned;
  struct timespec woken;
  struct timespec done;
  uint32_t axis = 0;
  int cycle = 0;
  clock_gettime(CLOCK_MONOTONIC, &planned);
  for (cycle = 0; cycle < cycles; ++cycle) {
    advance(&planned, cycle_time_ns);
    /* Absolute times: a late cycle does not shift those that follow. */
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &planned, NULL) == EINTR) {
    }
    clock_gettime(CLOCK_MONOTONIC, &woken);
    for (axis = 0; axis < axes; ++axis) in[axis] = 10.0 * cycle * (axis + 1);
    axisrt_status const happened = axisrt_step(t->runtime, in, out, status);
    clock_gettime(CLOCK_MONOTONIC, &done);
    if (happened > t->worst) t->worst = happened;
    histogram_add(&t->latency, since(&planned, &woken));
    histogram_add(&t->cost, since(&woken, &done));
    if (since(&planned, &done) > cycle_time_ns) ++t->overruns;
  }
}

static axisrt_status create(task* t, const image_file* image, void** memory) {
  axisrt_config config = {0};
  size_t alignment = 0;
  uint32_t axis = 0;
  axisrt_status status = AXISRT_OK;
  config.size = sizeof config;
  config.cycle_time_ns = cycle_time_ns;
  config.image = image->bytes;
  config.image_size = image->size;
  status = axisrt_memory_size(&config, &config.memory_size, &alignment);
  if (status != AXISRT_OK) return status;
  *memory = aligned_memory(config.memory_size);
  config.memory = *memory;
  status = axisrt_create(&config, &t->runtime);
  if (status != AXISRT_OK) return status;
  if (axisrt_axis_count(t->runtime) > most_axes) return AXISRT_BAD_ARGUMENT;
  for (axis = 0; axis < axisrt_axis_count(t->runtime); ++axis) axisrt_reset(t->runtime, axis, 0.0);
  return AXISRT_OK;
}

int main(int argc, char* argv[]) {
  static task t;
  image_file image = {NULL, 0};
  void* memory = NULL;
  axisrt_status status = AXISRT_BAD_ARGUMENT;
  if (argc < 2) {
    fprintf(stderr, "usage: cyclic_task IMAGE [CYCLES [PRIORITY]]\n");
    return 2;
  }
  if (load_image_file(argv[1], &image)) status = create(&t, &image, &memory);
  if (status == AXISRT_OK) {
    become_real_time(argc > 3 ? atoi(argv[3]) : 80);
    run(&t, argc > 2 ? atoi(argv[2]) : 10000);
    histogram_print(&t.latency, "latency");
    histogram_print(&t.cost, "cost of a step");
    printf("overruns: %llu\n", (unsigned long long)t.overruns);
    status = t.worst;
  }
  if (status != AXISRT_OK)
    fprintf(stderr, "%s: %s\n", axisrt_status_name(status), axisrt_status_text(status));
  free(memory);
  free(image.bytes);
  return status == AXISRT_OK ? 0 : 1;
}
