/* axisrt_c: executes the filters of a coefficient image, in one C99 file that needs no library.
 *
 * The same filters as axisrt (axisrt.h) at level portable, bit for bit, for tools and controllers that take C
 * sources: FMUs, S-functions, PLC runtimes, small processors. Written from docs/image-format.md. It has no
 * instruction sets, change of image, recorder or signatures; and it checks of an image what it relies on:
 * `axisc inspect` and axisrt_verify check everything.
 *
 * The caller owns all memory; nothing here allocates, locks, does input or output, or recurses. All calls for
 * one runtime come from one task. Arrays have one entry per axis, in image order. The processor must round to
 * nearest; the caller's control word is not touched.
 * Positions are in the list's unit (0.1 um or 1e-4 degree), velocities in um/s or 1e-3 degree/s; |x| <= 2^53.
 * C99 and later, C++14 and later.
 */
#ifndef AXISRT_C_H
#define AXISRT_C_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The result of a call, with the numbers of axisrt_status. Of an axis' status in a cycle, 0 to 43. */
typedef enum axisrt_c_status {
  AXISRT_C_OK = 0,
  AXISRT_C_TOO_SHORT = 1,      /* fewer bytes than a header, or than the header's total size */
  AXISRT_C_WRONG_MAGIC = 2,    /* does not begin with "AXIM" */
  AXISRT_C_WRONG_VERSION = 3,  /* another major version of the format */
  AXISRT_C_WRONG_SIZE = 4,     /* bytes after the total size that are not a whole signature */
  AXISRT_C_WRONG_CHECKSUM = 5, /* header or payload was changed */
  AXISRT_C_OUT_OF_BOUNDS = 6,  /* an offset, count, index or value out of range; a section missing or twice */
  AXISRT_C_OVERLAP = 7,        /* sections overlap or are not aligned to 64 bytes */
  AXISRT_C_NOT_FINITE = 8,     /* a stored number is NaN or infinite */
  AXISRT_C_UNSTABLE = 9,       /* a section that need not settle, or with |p| or |q| above 64 */
  AXISRT_C_KERNEL_TOO_LONG = 10,    /* a delay or kernel longer than the format allows */
  AXISRT_C_UNKNOWN_KIND = 11,       /* a section that may not be skipped, or a filter, family or mode */
  AXISRT_C_INCONSISTENT_CYCLE = 12, /* cycle time zero or beyond 1 s */
  AXISRT_C_MISALIGNED = 13,         /* memory is not aligned to AXISRT_C_ALIGNMENT */
  AXISRT_C_SELF_TEST_FAILED = 21,   /* this processor does not compute what the image demands */
  AXISRT_C_MEMORY_TOO_SMALL = 22,
  AXISRT_C_BAD_ARGUMENT = 23, /* null pointer, or a number too large */
  /* The cycle; the step was executed nevertheless. */
  AXISRT_C_BAD_INPUT = 40,   /* NaN, infinite or beyond 2^53: the last good one was used instead */
  AXISRT_C_NOT_RESET = 41,   /* never reset: the output repeats the input (0 for a bad one) */
  AXISRT_C_IMPLAUSIBLE = 43, /* the output moved farther in this cycle than the lists allow, (P + 1/4) v */
  /* axisrt_c_command. Nothing was changed. */
  AXISRT_C_BUSY = 50,            /* a filter of the group still changes over; try again in the next cycle */
  AXISRT_C_NO_BANK = 51,         /* the group has no bank of this number */
  AXISRT_C_NEEDS_STANDSTILL = 52 /* no transition is gentle enough: only while the axes are at rest */
} axisrt_c_status;

typedef struct axisrt_c axisrt_c;

#define AXISRT_C_ALIGNMENT 8u /* of memory; an image may be anywhere */

/* Bytes that create needs for this image. Checks the image. Cost: one pass over the image and its records.
 * Not in the cycle. */
axisrt_c_status axisrt_c_memory_size(const void* image, size_t image_size, size_t* bytes);

/* Checks the image, copies what it needs into `memory` and runs the image's self-tests; the image is not
 * needed afterwards. On failure *runtime is null. A copy of the block's bytes, put back at the same address,
 * restores the state that it had. Cost: as memory_size, and the self-tests' cycles. Not in the cycle. */
axisrt_c_status axisrt_c_create(const void* image, size_t image_size, void* memory, size_t memory_size,
                                axisrt_c** runtime);

/* Properties; 0 for a null pointer or a number too large. The caller compares the cycle time with its own. */
uint32_t axisrt_c_cycle_time_ns(const axisrt_c* runtime);
uint32_t axisrt_c_axis_count(const axisrt_c* runtime);
int axisrt_c_has_interface(const axisrt_c* runtime, uint32_t axis);
int axisrt_c_has_position_control(const axisrt_c* runtime, uint32_t axis);
uint32_t axisrt_c_group_count(const axisrt_c* runtime);
uint32_t axisrt_c_bank_count(const axisrt_c* runtime, uint32_t group);

/* Puts the axis' setpoint filters into the steady state for `position`, those of its additional interface for
 * `value`, the stages of its Improved Position Control for these velocities. Before it the axis is not
 * filtered. BAD_INPUT, and nothing is changed, if a number is not finite or beyond 2^53. May be called in the
 * cycle. */
axisrt_c_status axisrt_c_reset(axisrt_c* runtime, uint32_t axis, double position);
axisrt_c_status axisrt_c_reset_interface(axisrt_c* runtime, uint32_t axis, double value);
axisrt_c_status axisrt_c_reset_velocity(axisrt_c* runtime, uint32_t axis, double v_set, double v_motor,
                                        double v_direct);

/* Shifts the origin of an axis by `offset` without any effect on the motion (modulo axes). NOT_RESET,
 * BAD_INPUT. */
axisrt_c_status axisrt_c_rebase(axisrt_c* runtime, uint32_t axis, double offset);

/* One NC cycle: setpoints, the additional interface. `in` may equal `out`; `status` may be null. Returns the
 * worst status. Cost: constant for an image, but for one kernel more for each axis that changes over. */
axisrt_c_status axisrt_c_step(axisrt_c* runtime, const double* in, double* out, uint8_t* status);
axisrt_c_status axisrt_c_step_interface(axisrt_c* runtime, const double* in, double* out, uint8_t* status);

/* One NC cycle of Improved Position Control. `v_direct` may be null: the motor's velocities are used then.
 * `increments` (v_add in drive increments) and `status` may be null. */
axisrt_c_status axisrt_c_step_velocity(axisrt_c* runtime, const double* v_set, const double* v_motor,
                                       const double* v_direct, double* v_add, double* increments,
                                       uint8_t* status);

/* #FILTER and #VIB GUARD. `bank` is the one whose parameters are in force after the command. */
typedef enum axisrt_c_action {
  AXISRT_C_SET = 0,         /* #FILTER [...]: for the filters that are on */
  AXISRT_C_ON = 1,          /* #FILTER ON [...], #VIB GUARD ON [...] */
  AXISRT_C_OFF = 2,         /* #FILTER OFF; ignores the bank */
  AXISRT_C_PROGRAM_END = 3, /* as at start-up; ignores the bank */
  AXISRT_C_GUARD_OFF = 4    /* #VIB GUARD OFF; ignores the bank */
} axisrt_c_action;

/* Switches the filters that the bank concerns on all axes of a group; between two cycles. Immediate at
 * standstill, otherwise all axes change over together in a fade. OK also where nothing changes; BUSY,
 * NO_BANK, NEEDS_STANDSTILL, BAD_ARGUMENT. */
axisrt_c_status axisrt_c_command(axisrt_c* runtime, uint32_t group, axisrt_c_action action, uint32_t bank);

/* Cycles after which a command of this group is no longer BUSY: what is left of its fade; 0 where one may be
 * given now, and for a null pointer or a number too large. */
uint32_t axisrt_c_busy_cycles(const axisrt_c* runtime, uint32_t group);

/* Parameters of a bank; those that are not set are 0. */
typedef struct axisrt_c_bank_parameters {
  uint32_t
      keywords; /* 1 ORDER or MODE, 2 SHARE, 4 FCUT or FREQ, 8 QUALITY or DAMPING, 16 HSC, 32 #VIB GUARD */
  uint32_t order;
  double share, frequency, quality; /* percent, Hz, - */
} axisrt_c_bank_parameters;
axisrt_c_status axisrt_c_get_bank(const axisrt_c* runtime, uint32_t group, uint32_t bank,
                                  axisrt_c_bank_parameters* parameters);

#define AXISRT_C_NO_KERNEL 0xFFFFFFFFu

typedef struct axisrt_c_axis_state {
  double unfiltered, filtered; /* setpoint (the last good one) and output */
  uint32_t kernel;     /* number in the image of the one in use, or beginning to be; NO_KERNEL: none */
  uint32_t fading;     /* 1 while one kernel changes over to another */
  uint32_t settled;    /* 1 if |unfiltered - filtered| is within P-AXIS-00351 */
  uint32_t reset_done; /* 1 if the axis was reset since create */
} axisrt_c_axis_state;
axisrt_c_status axisrt_c_get_axis_state(const axisrt_c* runtime, uint32_t axis, axisrt_c_axis_state* state);

#ifdef __cplusplus
}
#endif
#endif
