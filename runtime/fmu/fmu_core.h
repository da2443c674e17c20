/* What FMUs of every FMI version do: the filters of one machine, executed cycle by cycle.
 *
 * Variables are numbers: value references as in modelDescription.xml, booleans 0 and 1, enumerations their
 * values. All calls for one instance come from one thread. One block of memory for an instance, and one
 * for each state that is kept; with -DAXISC_FMU_STATIC=N these are N static blocks, and no memory is
 * allocated. */
#ifndef FMU_CORE_H
#define FMU_CORE_H

#include "axisrt_c.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Value references: 0 is the time, 16 (axis + 1) + kind an axis' variable, 16 (axes + 1) + 2 channel + 0
 * or 1 a channel's command and its status. */
enum {
  FMU_SETPOINT,
  FMU_FILTERED,
  FMU_SETTLED,
  FMU_STATUS,
  FMU_RESET,
  FMU_INTERFACE,
  FMU_INTERFACE_FILTERED
};
enum {
  FMU_V_SET = FMU_INTERFACE_FILTERED + 1,
  FMU_V_MOTOR,
  FMU_V_DIRECT,
  FMU_V_ADD,
  FMU_INCREMENTS,
  FMU_KINDS
};

/* Values of a channel's command; a bank follows OFF, or where the channel has guards GUARD_OFF. */
enum { FMU_AS_AT_START, FMU_OFF, FMU_GUARD_OFF };

/* Bits: a caller may take several. */
enum { FMU_REAL = 1, FMU_BOOLEAN = 2, FMU_ENUMERATION = 4 };
typedef enum fmu_phase { FMU_INSTANTIATED, FMU_INITIALIZING, FMU_STEPPING, FMU_TERMINATED } fmu_phase;

/* With the numbers of the FMI. */
typedef enum fmu_result { FMU_OK = 0, FMU_DISCARD = 2, FMU_ERROR = 3 } fmu_result;

typedef struct fmu fmu;
struct fmu {
  const char* message; /* why the latest call failed */
  void* environment;   /* the importer's, and its logger: for the functions of a version */
  void (*logger)(void);
  char* name;
  fmu_phase phase;
  int is_settled; /* while initializing: outputs belong to the inputs */
  double time, period;
  uint32_t axis_count, channel_count;
  double* value[FMU_KINDS]; /* of each axis */
  double *was_reset, *command, *command_done, *command_status;
  uint8_t *status, *interface_status, *velocity_status;
  size_t size; /* of the whole block, which begins here */
  void* runtime_memory;
  size_t runtime_size;
  axisrt_c* runtime;
};

/* Null where there is no memory, where the token is another machine's, or where the runtime refuses the
 * image: *why then says so. */
fmu* fmu_instantiate(const char* token, const char* name, const char** why);
void fmu_free(fmu* m);

/* ERROR where there is no such variable, or none of these types. */
fmu_result fmu_get(fmu* m, uint32_t reference, int types, double* value);
fmu_result fmu_set(fmu* m, uint32_t reference, int types, double value);

/* The phases in their order; exit puts every axis into the steady state at its setpoint. */
fmu_result fmu_enter_initialization(fmu* m, double start);
fmu_result fmu_exit_initialization(fmu* m);
fmu_result fmu_terminate(fmu* m);
fmu_result fmu_reset(fmu* m);

/* As many NC cycles as the step has, all with the present inputs. DISCARD, and nothing has changed, if it
 * is not a whole number of them within 1e-6. */
fmu_result fmu_step(fmu* m, double time, double step);

/* A copy of the instance, which only this instance takes back. *state: null, or a copy that is
 * overwritten. */
fmu_result fmu_keep_state(fmu* m, void** state);
fmu_result fmu_restore_state(fmu* m, const void* state);
void fmu_free_state(void* state);

#ifdef __cplusplus
}
#endif
#endif
