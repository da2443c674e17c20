/* axisrt: executes the filters of a coefficient image, one call per NC cycle.
 *
 * Life of a controller task:
 *   at start   axisrt_memory_size, axisrt_create (verifies the image, copies coefficients, runs self-tests)
 *   per axis   axisrt_reset to the axis' actual position, before its first step
 *   per cycle  axisrt_step, axisrt_step_interface, axisrt_step_velocity; or axisrt_run for a block of cycles
 *   between    axisrt_command, when the NC program switches filters
 *
 * The caller owns all memory; nothing here allocates, locks, does input or output, throws or recurses.
 * All calls for one runtime come from one task. Arrays have one entry per axis, in image order.
 * On x86-64 and Arm every call rounds to nearest and without traps, whatever the caller has set, and gives
 * the caller's control word back; other processors must be set so. Structures begin as zeros: a reserved
 * number that is not 0 is AXISRT_BAD_ARGUMENT.
 * Positions are in the list's unit (0.1 um or 1e-4 degree), |position| <= 2^53.
 *
 * Coefficient convention: H(z) = (b0 + b1 z^-1 + b2 z^-2) / (1 + a1 z^-1 + a2 z^-2), stored in increment form
 * (see docs/image-format.md).
 */
#ifndef AXISRT_H
#define AXISRT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
#if defined(__ELF__)
#pragma GCC visibility push(default) /* what a shared library shows */
#endif

/* The result of a call. 0 is success; values never change meaning. */
typedef enum axisrt_status {
  AXISRT_OK = 0,

  /* The image (axisrt_verify, axisrt_memory_size, axisrt_create). */
  AXISRT_TOO_SHORT = 1,      /* fewer bytes than a header, or than the header's total size */
  AXISRT_WRONG_MAGIC = 2,    /* does not begin with "AXIM" */
  AXISRT_WRONG_VERSION = 3,  /* another major version of the format */
  AXISRT_WRONG_SIZE = 4,     /* bytes after the total size that are not a whole signature */
  AXISRT_WRONG_CHECKSUM = 5, /* header or payload was changed */
  /* An offset, count, index or value out of range; a proof that cannot be true; a section missing or
   * twice. */
  AXISRT_OUT_OF_BOUNDS = 6,
  AXISRT_OVERLAP = 7,             /* sections overlap or are not aligned to 64 bytes */
  AXISRT_NOT_FINITE = 8,          /* a stored number is NaN or infinite */
  AXISRT_UNSTABLE = 9,            /* a section that need not settle, or with |p| or |q| above 64 */
  AXISRT_KERNEL_TOO_LONG = 10,    /* a delay or kernel longer than the format allows */
  AXISRT_UNKNOWN_KIND = 11,       /* a filter, port, axis type or mandatory section of unknown kind */
  AXISRT_INCONSISTENT_CYCLE = 12, /* cycle time zero or beyond 1 s */
  AXISRT_MISALIGNED = 13,         /* image or memory is not aligned to 64 bytes */
  AXISRT_BOUND_FAILED = 14,       /* axisrt_check_bounds: a claim is not true, or cannot be checked */

  /* axisrt_create. */
  AXISRT_OTHER_CYCLE_TIME = 20, /* the image was made for another NC cycle time */
  AXISRT_SELF_TEST_FAILED = 21, /* this processor does not compute what the image demands */
  AXISRT_MEMORY_TOO_SMALL = 22,
  /* Null pointer, axis number too large, structure of unknown size, reserved number that is not 0, or memory
   * that overlaps what the call still reads. */
  AXISRT_BAD_ARGUMENT = 23,
  AXISRT_NO_LEVEL = 24,        /* this processor, or this build, lacks the instruction set asked for */
  AXISRT_UNSIGNED = 25,        /* a signature is demanded, and the image has none */
  AXISRT_WRONG_SIGNATURE = 26, /* the image was changed after it was signed, or signed with another key */

  /* axisrt_prepare. */
  AXISRT_OTHER_AXES = 27,  /* of another machine: number, names, numbers or types of its axes differ */
  AXISRT_OLDER_IMAGE = 28, /* its version counter is lower than that of the image in use */

  /* axisrt_recorder_start, axisrt_restore. */
  AXISRT_OTHER_IMAGE = 29,   /* it is not the image that was recorded */
  AXISRT_BAD_RECORDING = 30, /* not a recording, of another version, or damaged */

  /* The cycle. Unless stated otherwise, the step was executed nevertheless. */
  AXISRT_BAD_INPUT = 40, /* NaN, infinite or beyond 2^53: the last good setpoint was used instead */
  /* The axis was never reset: its output repeats the input (0 for a bad one), nothing was filtered. */
  AXISRT_NOT_RESET = 41,
  /* The output moved farther in this cycle than the lists allow, |y[n] - y[n-1]| > (P + 1/4) v (see
   * axisrt_step). */
  AXISRT_IMPLAUSIBLE = 43,

  /* axisrt_command, axisrt_swap. Nothing was changed. */
  AXISRT_BUSY = 50,    /* a filter of the group is still changing over; try again in the next cycle */
  AXISRT_NO_BANK = 51, /* the image has no kernels for these parameters */
  AXISRT_NEEDS_STANDSTILL = 52, /* no transition is gentle enough: only while the axes are at rest */
  AXISRT_NOT_WARM = 53          /* axisrt_swap: the new filters have not seen enough of the motion yet */
} axisrt_status;

/* One sentence in English, for logs; never null. May be called anywhere. */
const char* axisrt_status_text(axisrt_status status);
/* The constant's own name, "AXISRT_OK". */
const char* axisrt_status_name(axisrt_status status);

/* Version of this interface; changes when a program must be rebuilt. */
#define AXISRT_ABI_VERSION 5u
uint32_t axisrt_abi_version(void);

#define AXISRT_ALIGNMENT 64u

/* Checks an image: never reads outside [image, image + size), needs no memory. `image` is aligned to 64
 * bytes. An accepted image can be created and stepped without any fault, whatever its origin. A signature
 * after the image is accepted and not checked: only a configuration names the key.
 * Returns AXISRT_OK, one of the image's statuses, or AXISRT_BAD_ARGUMENT for a null pointer.
 * Cost: one pass for the checksum, one over the content. Not in the cycle. */
axisrt_status axisrt_verify(const void* image, size_t size);

/* Computes the bounds of an image (its section `bounds`, docs/certificate.md) again from its coefficients and
 * compares them with what it claims: gains, overshoot, poles, rounding, states, cycles to rest, and the
 * changes of kernels. axisrt_verify only checks that they are possible. `record` receives the first record
 * that fails, or how many hold. A record that claims more than `most_cycles` cycles fails without being
 * computed, so that the caller decides about the time; 2^22 allows all.
 * Returns AXISRT_OK if every record holds, AXISRT_BOUND_FAILED (also for an image without that section),
 * AXISRT_BAD_ARGUMENT, or what axisrt_verify returns.
 * Cost: for each record its cycles, some 10 to 100 ns for each section; 16 KiB of stack. Not in the cycle. */
axisrt_status axisrt_check_bounds(const void* image, size_t size, uint32_t most_cycles, uint32_t* record);

/* Instruction sets. Each computes the same filters within the accuracy that axisrt_step states; only PORTABLE
 * gives the same bits on every processor (the others differ in the last place where they contract
 * multiplications and additions). */
typedef enum axisrt_level {
  AXISRT_LEVEL_AUTOMATIC = 0, /* the best one that this processor has */
  AXISRT_LEVEL_PORTABLE = 1,  /* one axis after the other, every operation rounded */
  AXISRT_LEVEL_X86_64_V2 = 2, /* SSE up to 4.2 */
  AXISRT_LEVEL_X86_64_V3 = 3, /* AVX2, FMA, BMI2 and their companions */
  AXISRT_LEVEL_X86_64_V4 = 4, /* AVX-512 F, BW, CD, DQ, VL */
  AXISRT_LEVEL_NEON = 16      /* AArch64 */
} axisrt_level;

typedef struct axisrt axisrt;

/* Checks the signature of an image with a key that the controller holds: 0 if it is right (what
 * crypto_sign_verify_detached of libsodium returns), anything else if not. `key_id`: the 8 bytes that `axisc
 * keygen` printed; they help to choose among several keys and prove nothing. `image`, `image_size`: the
 * signed bytes. `signature`: 64 bytes, Ed25519. `context`: verify_context of the configuration. Called before
 * anything after the header is read. */
typedef int (*axisrt_verify_signature)(void* context, const uint8_t* key_id, const void* image,
                                       size_t image_size, const uint8_t* signature);

typedef struct axisrt_config {
  uint32_t size;          /* sizeof(axisrt_config) */
  uint32_t cycle_time_ns; /* the controller's real NC cycle time; an image for another one is refused */
  const void* image;      /* aligned to 64 bytes; only read, and not needed after create, except for names */
  size_t image_size;      /* with the signature after it, where there is one */
  void* memory;           /* aligned to 64 bytes, apart from the image; the runtime's while it is used */
  size_t memory_size;
  uint32_t level;    /* an axisrt_level; axisrt_memory_size and axisrt_create get the same */
  uint32_t reserved; /* 0 */
  /* Null: signatures are ignored. Otherwise axisrt_memory_size and axisrt_create refuse an image without a
   * valid one. */
  axisrt_verify_signature verify_signature;
  void* verify_context; /* handed to verify_signature; may be null */
} axisrt_config;

/* Bytes that create needs for this image, and their alignment (AXISRT_ALIGNMENT); `memory`, `memory_size` and
 * `cycle_time_ns` of the configuration are not looked at. Verifies the image and returns what axisrt_verify
 * returns, or AXISRT_MEMORY_TOO_SMALL if this processor cannot address as much, AXISRT_UNSIGNED,
 * AXISRT_WRONG_SIGNATURE or AXISRT_NO_LEVEL for a number that is not a level (for one that this processor
 * lacks the answer is right, so that a program can plan another's memory). Cost: as axisrt_verify, and a pass
 * over the axes for each shape of chains, of which at most 32 count. Not in the cycle. */
axisrt_status axisrt_memory_size(const axisrt_config* config, size_t* bytes, size_t* alignment);

/* Checks the signature if one is demanded, verifies the image, compares the cycle time, copies the
 * coefficients and runs the self-tests. No axis may be stepped before it was reset. On failure *runtime is
 * null. Needs no counterpart: the memory is the caller's.
 * Returns what axisrt_verify returns, or one of the statuses of create. Cost: as axisrt_verify, the
 * coefficients, the self-tests' cycles. Not in the cycle. */
axisrt_status axisrt_create(const axisrt_config* config, axisrt** runtime);

/* Its properties; 0 for a null pointer or a wrong axis. Cost: constant. May be called in the cycle. */
uint32_t axisrt_axis_count(const axisrt* runtime);
uint32_t axisrt_cycle_time_ns(const axisrt* runtime);
/* The counter that the machine's maker gave the image (`axisc compile --image-version`). A signature does not
 * show whether an image is the newest one: a controller that must never go back stores the highest number
 * that it has run, and does not move with a lower one. */
uint32_t axisrt_image_version(const axisrt* runtime);
/* The axisrt_level that is executed: never AUTOMATIC. */
uint32_t axisrt_level_of(const axisrt* runtime);
/* Name in UTF-8, not terminated; length 0 for a stripped image or a wrong axis. Points into the image; never
 * null. */
const char* axisrt_axis_name(const axisrt* runtime, uint32_t axis, size_t* length);
/* 1 if the axis has a filter on its additional interface, else 0. */
int axisrt_has_interface(const axisrt* runtime, uint32_t axis);
/* 1 if the axis has an additive velocity (Improved Position Control of its own or of its gantry master), else
 * 0. */
int axisrt_has_position_control(const axisrt* runtime, uint32_t axis);
/* NC channels that have an axis with a FIR or HSC filter. */
uint32_t axisrt_group_count(const axisrt* runtime);
/* As axisrt_axis_name. */
const char* axisrt_group_name(const axisrt* runtime, uint32_t group, size_t* length);

/* Puts every setpoint filter into the steady state for `position`: the next output for that setpoint is the
 * steady output (for DC gain 1 the position itself, exactly). AXISRT_BAD_INPUT, and nothing is changed, if
 * the position is not finite or beyond 2^53. Cost: the axis' states. May be called in the cycle. */
axisrt_status axisrt_reset(axisrt* runtime, uint32_t axis, double position);

/* Puts the filters of the additional interface into the steady state for `value`; axisrt_reset does not.
 * Statuses and cost as axisrt_reset. An axis without a filter on its interface needs no reset. */
axisrt_status axisrt_reset_interface(axisrt* runtime, uint32_t axis, double value);

/* Shifts the origin of an axis by `offset` without any effect on the motion (modulo axes): setpoints and
 * outputs from now on are larger by `offset` (outputs of a chain whose DC gain is not 1, by that gain times
 * `offset`). Exact when the shifted positions are representable. AXISRT_NOT_RESET before a reset;
 * AXISRT_BAD_INPUT, and nothing is changed, if the offset or the shifted setpoint is not finite or beyond
 * 2^53. Cost: the axis' delays. May be called in the cycle. */
axisrt_status axisrt_rebase(axisrt* runtime, uint32_t axis, double offset);

/* One NC cycle. in[axis]: position setpoint; out[axis]: filtered setpoint, always finite for an axis that was
 * reset. `in` may equal `out`. `status` may be null, else status[axis] receives the status of that axis.
 * Returns the worst of them, or AXISRT_BAD_ARGUMENT for a null pointer.
 * Typical error against the exact filter, for characteristic frequencies from 1e-4/T to 0.4/T and ordinary
 * setpoints (moves, steps, sines, noise): at most
 *     ulp(max(|in|, |out|)) + 2^-42 D + 2^-40 d
 * D: the largest |out - in| since the last rest; for chains that block the constant part the largest distance
 * of `in` from there, or the largest |out|. d: the largest |in[n] - in[n-1]| since then; its term counts
 * where setpoints jump back and forth, and vanishes next to the others in a move. From 1e-6/T on and up to
 * 0.475/T the last terms are 2^-38 D + 2^-32 d. This is measured, not proved: setpoints whose last digits are
 * chosen so that all roundings push the same way exceed it, narrow filters of 1e-4/T by up to 13 times (5e-6
 * units at an amplitude of 1e6). The bound for every setpoint, from the section `bounds` of the image
 * (docs/certificate.md), is half an ulp of out, and rounding_increment times the largest move of a setpoint
 * in a cycle. At rest a chain with DC gain 1 ends at out == in, exactly and for good; after how many cycles,
 * rest_cycles says.
 * Cost: constant for a given image, whatever the values are; while kernels change over (axisrt_command), that
 * of one kernel more for each axis that does. */
axisrt_status axisrt_step(axisrt* runtime, const double* in, double* out, uint8_t* status);

/* A block of cycles: axisrt_step for one row of `in` after the other, without a command in between. `in`,
 * `out` and, unless it is null, `status` hold `values` entries, a row of all axes for each cycle. `in` may
 * equal `out`. Returns the worst status of all cycles, or AXISRT_BAD_ARGUMENT, and nothing is executed, for a
 * null pointer, for `values` that are not whole rows, and for arrays that overlap in part. 0 values are 0
 * cycles. Cost: that of the cycles. */
axisrt_status axisrt_run(axisrt* runtime, const double* in, double* out, size_t values, uint8_t* status);

/* The limit beyond which axisrt_step calls an output implausible, for axes whose list gives P-AXIS-00212 (v
 * per cycle): with P the largest gain_high of the axis' chain with any kernel that its slot can execute, from
 * the section `bounds`; without that section the largest product of peak gains of the chain and any kernel of
 * the image (as the image states them, upper bounds): an output that moves by more than (P + 1/4) v in one
 * cycle. Setpoints that stay within v never cause it, not in a change of kernels or of images either, where v
 * is not so small that the last digits of positions count (positions below 2^40 v); a reset does not count.
 * Images of axisc 0.2.0 and before may state too little for filters whose characteristic frequency is below
 * some millionths of 1/T. */

/* How far the filters of an axis take it away from its commanded path where its velocity changes by
 * `velocity` (um/s or 1e-3 degree/s) from one cycle to the next, as in a corner: the largest distance, in the
 * unit of positions, between the filtered setpoint and the setpoint of D cycles before, D being the chain's
 * group delay at 0 Hz. For a symmetric kernel of half width h alone: v sum of k b_k over k = 1..h.
 * Proportional to |velocity|, so that a path planner asks once for each kernel and multiplies.
 * Infinite for a chain that does not follow a ramp (it blocks the constant part).
 * AXISRT_BUSY while kernels change over or an image is replaced; AXISRT_BAD_INPUT for a velocity that is not
 * finite or beyond 2^53; AXISRT_BAD_ARGUMENT.
 * Cost: the step response twice: the kernel's tails; with sections, until they have settled (at most 2^22
 * cycles in all): not in the cycle then. */
axisrt_status axisrt_axis_error_bound(const axisrt* runtime, uint32_t axis, double velocity, double* bound);

/* One NC cycle of the additional interface; axes without a filter there pass through. */
axisrt_status axisrt_step_interface(axisrt* runtime, const double* in, double* out, uint8_t* status);

/* Velocities of all axes in um/s or 1e-3 degree/s. */
typedef struct axisrt_velocities {
  uint32_t size;         /* sizeof(axisrt_velocities) */
  uint32_t reserved;     /* 0 */
  const double* v_set;   /* commanded by the position controller */
  const double* v_motor; /* measured by the motor's encoder */
  /* Measured by the direct measuring system; null: the motor's are used. For a single axis without such a
   * system repeat the motor's velocity. */
  const double* v_direct;
} axisrt_velocities;

/* Puts the stages of an axis into the steady state for these velocities. To be called once before the first
 * axisrt_step_velocity of the axis; otherwise its additive velocity stays 0 and its status is
 * AXISRT_NOT_RESET. AXISRT_BAD_INPUT, and nothing is changed, for velocities that are not finite or beyond
 * 2^53. Cost: the axis' states. */
axisrt_status axisrt_reset_velocity(axisrt* runtime, uint32_t axis, double v_set, double v_motor,
                                    double v_direct);

/* One NC cycle of Improved Position Control (P-AXIS-00750 to 00758).
 * v_add[axis]: additive velocity in um/s or 1e-3 degree/s, within +-P-AXIS-00757/1000 * P-AXIS-00212; for a
 * gantry slave its master's; 0 for other axes. increments[axis] (may be null): v_add in drive increments, not
 * rounded, where the position control is
 *   in the drive   v_add v_reso_num/v_reso_denom per minute, second or NC cycle (P-AXIS-00205..00207)
 *   in the CNC     v_add 6e-5 multi_gain_z/multi_gain_n (P-AXIS-00129, 00128)
 *   not known      0
 * status as for axisrt_step; an invalid velocity is replaced by the last good one. The parameters may only be
 * changed (another image) at standstill. Cost: constant for a given image. */
axisrt_status axisrt_step_velocity(axisrt* runtime, const axisrt_velocities* in, double* v_add,
                                   double* increments, uint8_t* status);

/* The NC commands #FILTER and, with AXISRT_KEYWORD_GUARD, #VIB GUARD. */
typedef enum axisrt_action {
  /* #FILTER [...]: changes the parameters that it names, keeps those of earlier commands, and leaves the
   * switch as it is */
  AXISRT_ACTION_SET = 0,
  AXISRT_ACTION_ON =
      1, /* #FILTER ON [...]: the lists' values with these parameters; forgets earlier commands */
  AXISRT_ACTION_OFF = 2, /* #FILTER OFF: FIR and HSC filters, or #VIB GUARD OFF; other keywords are ignored */
  AXISRT_ACTION_PROGRAM_END = 3 /* the state of start-up: the lists' values; keywords are ignored */
} axisrt_action;

#define AXISRT_KEYWORD_ORDER 1u   /* ORDER, or ORDER_TIME through axisrt_order_of_time */
#define AXISRT_KEYWORD_SHARE 2u   /* SHARE in percent */
#define AXISRT_KEYWORD_FCUT 4u    /* FCUT in Hz */
#define AXISRT_KEYWORD_QUALITY 8u /* QUALITY */
#define AXISRT_KEYWORD_HSC 16u    /* [HSC]: the HSC filters, without other keywords */
#define AXISRT_KEYWORD_GUARD 32u  /* #VIB GUARD: ORDER, FCUT and QUALITY are its MODE, FREQ and DAMPING */

typedef struct axisrt_filter_command {
  uint32_t size;     /* sizeof(axisrt_filter_command) */
  uint32_t action;   /* an axisrt_action */
  uint32_t keywords; /* AXISRT_KEYWORD_... that the command names */
  uint32_t order;
  double share;
  double fcut;
  double quality;
} axisrt_filter_command;

/* Switches the FIR filters (with AXISRT_KEYWORD_HSC the HSC filters, with AXISRT_KEYWORD_GUARD the guards)
 * of all axes of a group to the kernels that the image holds for these parameters (those in force after the
 * command, AXISRT_ACTION_SET included; AXISRT_NO_BANK without them); nothing is computed here. To be called
 * between two cycles.
 *
 * While every axis of the group is at standstill (no increment of 2^-30 units or more for as many cycles as
 * its longest kernel remembers), the change is immediate, and no output moves by more than such increments
 * amount to. In motion all axes change over together in a fade y = A + w (B - A) over F cycles; F is stored
 * in the image. With setpoints within P-AXIS-00212 and P-AXIS-00008 (v and a per cycle) and P_A, P_B the peak
 * gains of the two chains, outputs of the fade keep
 *     |y[n] - y[n-1]|               <= max(P_A, P_B) v + v/4
 *     |y[n] - 2 y[n-1] + y[n-2]|    <= max(P_A, P_B) a + a/4
 * Returns AXISRT_OK (also where nothing changes), AXISRT_BUSY, AXISRT_NO_BANK, AXISRT_NEEDS_STANDSTILL, or
 * AXISRT_BAD_ARGUMENT. Cost: the group's banks, axes and the tails of their kernels; a cycle during a fade
 * and up to 16 cycles after it applies two kernels to the whole history of each axis. */
axisrt_status axisrt_command(axisrt* runtime, uint32_t group, const axisrt_filter_command* command);

/* Cycles after which a command of this group is no longer AXISRT_BUSY: what is left of its fade, or of a
 * change of image; 0 where one may be given now. 0 for a null pointer or a number too large. Cost: the
 * group's axes. */
uint32_t axisrt_busy_cycles(const axisrt* runtime, uint32_t group);

/* Sets of parameters that the image has for a group: at least one. 0 for a null pointer or a number too
 * large. */
uint32_t axisrt_bank_count(const axisrt* runtime, uint32_t group);
/* The command that names a set, as AXISRT_ACTION_ON with its keywords: what axisrt_command takes, and to
 * which any other parameters are AXISRT_NO_BANK. `command->size` is the caller's. AXISRT_BAD_ARGUMENT. */
axisrt_status axisrt_get_bank(const axisrt* runtime, uint32_t group, uint32_t bank,
                              axisrt_filter_command* command);

/* The order that ORDER_TIME (in us) means: floor(time/T + 0.5), 0 below one cycle. */
uint32_t axisrt_order_of_time(const axisrt* runtime, double time_us);

/* Change of image while the machine runs: prepare once, shadow in every cycle, swap, then step the new
 * runtime.
 *
 *   axisrt_prepare(active, &config, 0, &next);                 not in the cycle
 *   axisrt_step(active, ...); axisrt_shadow_step(next);        in every cycle, until
 *   axisrt_swap(next) == AXISRT_OK                             between two cycles; from then on
 *   axisrt_step(next, ...)                                     instead of `active`, which it steps along
 *   axisrt_swap_done(next)                                     then the memory of `active` is free again
 *
 * All outputs change over together, y = y_before + w (y_new - y_before), w = t^3 (10 - 15 t + 6 t^2), in F
 * cycles. With setpoints within P-AXIS-00212 and P-AXIS-00008 of both images (the lower ones; v and a per
 * cycle) and the peak gains P_A, P_B of the chains, the setpoint outputs keep
 *     |y[n] - y[n-1]|               <= max(P_A, P_B) v + v/4
 *     |y[n] - 2 y[n-1] + y[n-2]|    <= max(P_A, P_B) a + a/4 + a/64
 * At standstill, when the outputs of both runtimes have agreed for 64 cycles, the change may be immediate. */

/* Option of axisrt_prepare: accepts a lower version counter. */
#define AXISRT_ALLOW_OLDER 1u

/* Creates the runtime of another image of the same machine next to the one in use, in the steady state for
 * its latest setpoints, and plans the change. Does not read the image of `active`; the memory of `config`
 * must not touch that of `active` or of its recorder (AXISRT_BAD_ARGUMENT). Returns what axisrt_create
 * returns, AXISRT_OTHER_AXES, AXISRT_OLDER_IMAGE, or AXISRT_BUSY while `active` itself is still replacing
 * another. `prepared` may get commands; it begins with the lists' values. Prepare again after axisrt_rebase,
 * and after axisrt_reset of an axis that was reset before.
 * How far a chain takes its output from the setpoint is distance_high of the section `bounds`, or computed
 * where an image has none.
 * Cost: axisrt_create, and the step responses of all chains of both images (at most 2^21 cycles each). Not in
 * the cycle. */
axisrt_status axisrt_prepare(axisrt* active, const axisrt_config* config, uint32_t options,
                             axisrt** prepared);

/* One cycle of the prepared runtime, with the latest inputs of the active one. To be called after the active
 * one's steps. Cost: that of a cycle. */
axisrt_status axisrt_shadow_step(axisrt* prepared);

/* Makes the prepared runtime the one to be stepped. AXISRT_BUSY while kernels change over in one of the two;
 * AXISRT_NEEDS_STANDSTILL where Improved Position Control differs (its stages then begin with
 * axisrt_reset_velocity), where a chain does not pass the constant part, where limits are unknown, or where
 * the change would take more than 4096 cycles; AXISRT_NOT_WARM where fewer cycles were shadowed than the new
 * filters need. Cost: the axes. May be called in the cycle. */
axisrt_status axisrt_swap(axisrt* prepared);

/* 1 once the change is over. Commands are AXISRT_BUSY until then. Cost: constant. */
int axisrt_swap_done(const axisrt* runtime);

/* Recorder: inputs and outputs of a runtime in its last cycles, and the state before them, so that the cycles
 * can be executed again bit for bit on the same level (`axisc replay IMAGE DUMP`).
 *
 *   axisrt_recorder_size, axisrt_recorder_start                not in the cycle
 *   axisrt_step(runtime, ...), axisrt_command, axisrt_reset    as usual
 *   axisrt_recorder_stop                                       when something happened that is worth a look
 *   axisrt_recorder_dump                                       in any task, once it is stopped
 *
 * Cost: every cycle is written into a ring, and the one that falls out of the ring is executed once more by a
 * runtime of the recorder's own, which thereby keeps the state that the recording begins with. So every cycle
 * costs two to three times as much as without a recorder. */
typedef struct axisrt_recorder axisrt_recorder;

/* Bytes that axisrt_recorder_start needs for at least `cycles` cycles (and 256 words of commands and resets
 * in between); aligned to AXISRT_ALIGNMENT. `config`: image and signature check as for axisrt_create of
 * `runtime`; its cycle time and level are not looked at, a recorder has those of the runtime. Returns what
 * axisrt_memory_size returns. Not in the cycle. */
axisrt_status axisrt_recorder_size(const axisrt* runtime, const axisrt_config* config, uint32_t cycles,
                                   size_t* bytes);

/* Begins to record; `memory` of the configuration is the recorder's, until it was stopped and dumped.
 * AXISRT_BUSY where the runtime is recorded already, or was prepared and its change is not over
 * (axisrt_swap_done); the one that works may be recorded while another is prepared. AXISRT_OTHER_IMAGE unless
 * the image is the runtime's own, header included; AXISRT_BAD_ARGUMENT where the memory touches that of the
 * runtime (that of a prepared one is not known here); else what axisrt_create returns. A change of image ends
 * the recording (axisrt_swap). Cost: axisrt_create, and a copy of the state. Not in the cycle. */
axisrt_status axisrt_recorder_start(axisrt* runtime, const axisrt_config* config, uint32_t cycles,
                                    axisrt_recorder** recorder);

/* Ends the recording and keeps what was recorded. Does nothing for null or a second time. Cost: constant. May
 * be called in the cycle. */
void axisrt_recorder_stop(axisrt_recorder* recorder);

/* Writes the recording (runtime/format/recording_format.h describes the format). `needed` receives its size;
 * AXISRT_MEMORY_TOO_SMALL where `size` is less, or `bytes` null. Cost: the state and the ring. From any task
 * if the recorder is stopped, otherwise between two cycles. */
axisrt_status axisrt_recorder_dump(const axisrt_recorder* recorder, void* bytes, size_t size, size_t* needed);

/* Creates a runtime in the state with which a recording begins, at the recorded level, whatever the
 * configuration says. AXISRT_BAD_RECORDING, AXISRT_OTHER_IMAGE, or what axisrt_create returns
 * (AXISRT_NO_LEVEL where this processor cannot execute the level). The checksum guards a recording against
 * accidents; numbers that would lead outside the memory are refused, whatever their origin. Not in the
 * cycle. */
axisrt_status axisrt_restore(const axisrt_config* config, const void* dump, size_t size, axisrt** runtime);

#define AXISRT_MOST_FILTERS 4u
#define AXISRT_NO_KERNEL 0xFFFFFFFFu

typedef struct axisrt_axis_state {
  double unfiltered;                         /* the input setpoint (the last good one) */
  double filtered;                           /* the output */
  double filter_output[AXISRT_MOST_FILTERS]; /* output of each filter of the cascade, in order */
  uint32_t filters;                          /* how many of them there are */
  uint32_t filters_on;                       /* bit i: filter i of the cascade is on */
  uint32_t kernel;     /* number in the image of the one in use, or beginning to be; AXISRT_NO_KERNEL: none */
  uint32_t fading;     /* 1 while one kernel changes over to another */
  uint32_t settled;    /* 1 if |unfiltered - filtered| <= kenngr.filter_position_window */
  uint32_t reset_done; /* 1 if the axis was reset since create */
} axisrt_axis_state;

/* AXISRT_BAD_ARGUMENT for a null pointer or a wrong axis. Cost: constant. May be called in the cycle. */
axisrt_status axisrt_get_axis_state(const axisrt* runtime, uint32_t axis, axisrt_axis_state* state);

#if defined(__ELF__)
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
