/* fmu_core: see fmu_core.h. */
#include "fmu_core.h"

#include "machine.h"

#include <string.h>

/* ---- memory ------------------------------------------------------------------------------------ */

#ifdef AXISC_FMU_STATIC
/* Instances and states; instantiate and free from one thread. */
enum {
  BLOCK_SIZE = (int)sizeof(fmu) + machine_axis_count * (FMU_KINDS + 2) * 8 + machine_channel_count * 24 +
               machine_runtime_size + 64
};
static double blocks[AXISC_FMU_STATIC][(BLOCK_SIZE + 7) / 8];
static uint8_t is_taken[AXISC_FMU_STATIC];

static void* take_block(size_t size) {
  size_t i;
  for (i = 0; i < AXISC_FMU_STATIC && size <= sizeof blocks[0]; ++i) {
    if (is_taken[i]) continue;
    is_taken[i] = 1;
    memset(blocks[i], 0, sizeof blocks[i]);
    return blocks[i];
  }
  return NULL;
}

static void give_back(void* block) {
  size_t i;
  for (i = 0; i < AXISC_FMU_STATIC; ++i) {
    if (block == (void*)blocks[i]) is_taken[i] = 0;
  }
}
#else
#include <stdlib.h>

static void* take_block(size_t size) {
  return calloc(1, size);
}

static void give_back(void* block) {
  free(block);
}
#endif

/* ---- an instance ------------------------------------------------------------------------------- */

static fmu_result fail(fmu* m, fmu_result result, const char* why) {
  m->message = why;
  return result;
}

static int is_same(const char* a, const char* b) {
  return a != NULL && strcmp(a, b) == 0;
}

/* Inputs and outputs as modelDescription.xml has them at the start, and a runtime that has executed
 * nothing. */
static int begin(fmu* m) {
  uint32_t i;
  int kind;
  for (kind = 0; kind < FMU_KINDS; ++kind) memset(m->value[kind], 0, m->axis_count * sizeof(double));
  for (i = 0; i < m->axis_count; ++i) m->was_reset[i] = 0;
  for (i = 0; i < m->channel_count; ++i) m->command[i] = m->command_done[i] = m->command_status[i] = 0;
  m->phase = FMU_INSTANTIATED;
  m->is_settled = 0;
  m->time = 0;
  return axisrt_c_create(machine_image, machine_image_size, m->runtime_memory, m->runtime_size,
                         &m->runtime) == AXISRT_C_OK;
}

static double* take_numbers(uint8_t** free_from, size_t count) {
  double* const numbers = (double*)(void*)*free_from;
  *free_from += count * sizeof *numbers;
  return numbers;
}

fmu* fmu_instantiate(const char* token, const char* name, const char** why) {
  size_t const axes = machine_axis_count, channels = machine_channel_count;
  size_t const name_size = name == NULL ? 1 : strlen(name) + 1;
  size_t const numbers = (axes * (FMU_KINDS + 1) + channels * 3) * sizeof(double);
  size_t const statuses = (axes * 3 + 7) / 8 * 8;
  size_t const own = (sizeof(fmu) + 7) / 8 * 8;
  size_t runtime = 0, size;
  uint8_t* free_from;
  fmu* m;
  int kind;
  *why = "this FMU is for another machine: the instantiation token is not that of its modelDescription.xml";
  if (!is_same(token, machine_token)) return NULL;
  *why = "the image within this FMU is damaged";
  if (axisrt_c_memory_size(machine_image, machine_image_size, &runtime) != AXISRT_C_OK) return NULL;
  *why = "there is no memory for another instance";
#ifdef AXISC_FMU_STATIC
  (void)name_size;
  size = own + numbers + statuses + runtime;
#else
  size = own + numbers + statuses + (runtime + 7) / 8 * 8 + name_size;
#endif
  m = (fmu*)take_block(size);
  if (m == NULL) return NULL;
  m->size = size;
  m->axis_count = (uint32_t)axes;
  m->channel_count = (uint32_t)channels;
  m->period = machine_cycle_time_ns * 1e-9;
  free_from = (uint8_t*)m + own;
  for (kind = 0; kind < FMU_KINDS; ++kind) m->value[kind] = take_numbers(&free_from, axes);
  m->was_reset = take_numbers(&free_from, axes);
  m->command = take_numbers(&free_from, channels);
  m->command_done = take_numbers(&free_from, channels);
  m->command_status = take_numbers(&free_from, channels);
  m->status = free_from;
  m->interface_status = m->status + axes;
  m->velocity_status = m->interface_status + axes;
  m->runtime_memory = m->status + statuses;
  m->runtime_size = runtime;
#ifndef AXISC_FMU_STATIC
  m->name = (char*)m->runtime_memory + (runtime + 7) / 8 * 8;
  if (name != NULL) memcpy(m->name, name, name_size);
#endif
  *why = "this processor does not compute what the image demands";
  if (begin(m)) return m;
  give_back(m);
  return NULL;
}

void fmu_free(fmu* m) {
  give_back(m);
}

/* ---- the cycle --------------------------------------------------------------------------------- */

/* A number that cannot be used leaves the axis as it is; the next cycle's status says so. */
static void reset_axis(fmu* m, uint32_t i) {
  axisrt_c_reset(m->runtime, i, m->value[FMU_SETPOINT][i]);
  axisrt_c_reset_interface(m->runtime, i, m->value[FMU_INTERFACE][i]);
  axisrt_c_reset_velocity(m->runtime, i, m->value[FMU_V_SET][i], m->value[FMU_V_MOTOR][i],
                          m->value[FMU_V_DIRECT][i]);
}

static int has_guards(const fmu* m, uint32_t channel) {
  uint32_t const banks = axisrt_c_bank_count(m->runtime, channel);
  axisrt_c_bank_parameters bank;
  uint32_t i;
  for (i = 0; i < banks; ++i) {
    if (axisrt_c_get_bank(m->runtime, channel, i, &bank) == AXISRT_C_OK && (bank.keywords & 32u) != 0)
      return 1;
  }
  return 0;
}

static uint32_t first_bank(const fmu* m, uint32_t channel) {
  return has_guards(m, channel) ? FMU_GUARD_OFF + 1 : FMU_GUARD_OFF;
}

/* A command that has to wait is tried again in the next cycle. */
static void command(fmu* m, uint32_t channel) {
  uint32_t const wanted = (uint32_t)m->command[channel], first = first_bank(m, channel);
  axisrt_c_action action = AXISRT_C_ON;
  axisrt_c_status status;
  if (wanted < first) {
    action = wanted == FMU_AS_AT_START ? AXISRT_C_PROGRAM_END
             : wanted == FMU_OFF       ? AXISRT_C_OFF
                                       : AXISRT_C_GUARD_OFF;
  }
  status = axisrt_c_command(m->runtime, channel, action, wanted < first ? 0 : wanted - first);
  m->command_status[channel] = (double)status;
  if (status == AXISRT_C_OK) m->command_done[channel] = m->command[channel];
}

static void step_ports(fmu* m) {
  axisrt_c_axis_state state;
  uint32_t i;
  axisrt_c_step(m->runtime, m->value[FMU_SETPOINT], m->value[FMU_FILTERED], m->status);
  axisrt_c_step_interface(m->runtime, m->value[FMU_INTERFACE], m->value[FMU_INTERFACE_FILTERED],
                          m->interface_status);
  axisrt_c_step_velocity(m->runtime, m->value[FMU_V_SET], m->value[FMU_V_MOTOR], m->value[FMU_V_DIRECT],
                         m->value[FMU_V_ADD], m->value[FMU_INCREMENTS], m->velocity_status);
  for (i = 0; i < m->axis_count; ++i) {
    uint8_t worst = m->status[i];
    if (axisrt_c_has_interface(m->runtime, i) && m->interface_status[i] > worst)
      worst = m->interface_status[i];
    if (m->velocity_status[i] > worst) worst = m->velocity_status[i];
    m->value[FMU_STATUS][i] = worst;
    axisrt_c_get_axis_state(m->runtime, i, &state);
    m->value[FMU_SETTLED][i] = state.settled;
  }
}

static void cycle(fmu* m) {
  uint32_t i;
  for (i = 0; i < m->channel_count; ++i) {
    if (m->command[i] != m->command_done[i])
      command(m, i);
    else
      m->command_status[i] = AXISRT_C_OK; /* one that waited may have been taken back */
  }
  for (i = 0; i < m->axis_count; ++i) {
    if (m->value[FMU_RESET][i] != 0 && m->was_reset[i] == 0) reset_axis(m, i);
    m->was_reset[i] = m->value[FMU_RESET][i];
  }
  step_ports(m);
}

/* Outputs of the steady state at the inputs. They take a cycle, which the runtime must not keep:
 * afterwards it is made anew, and again in the steady state. */
static void settle(fmu* m) {
  uint32_t i;
  for (i = 0; i < m->axis_count; ++i) reset_axis(m, i);
  step_ports(m);
  axisrt_c_create(machine_image, machine_image_size, m->runtime_memory, m->runtime_size, &m->runtime);
  for (i = 0; i < m->axis_count; ++i) {
    reset_axis(m, i);
    m->was_reset[i] = m->value[FMU_RESET][i];
  }
  m->is_settled = 1;
}

fmu_result fmu_step(fmu* m, double time, double step) {
  double const cycles = step / m->period;
  uint32_t count, i;
  if (m->phase != FMU_STEPPING) return fail(m, FMU_ERROR, "a step is possible after initialization only");
  if (!(cycles > 0.5 && cycles < 4e9)) return fail(m, FMU_DISCARD, "a step takes at least one NC cycle");
  count = (uint32_t)(cycles + 0.5);
  if (!(cycles - count < 1e-6 && count - cycles < 1e-6))
    return fail(m, FMU_DISCARD,
                "a step takes a whole number of NC cycles: stepSize of the description times 1, 2, 3");
  for (i = 0; i < count; ++i) cycle(m);
  m->time = time + step;
  return FMU_OK;
}

/* ---- variables --------------------------------------------------------------------------------- */

static int type_of_kind(const fmu* m, uint32_t axis, uint32_t kind) {
  if (kind >= FMU_KINDS) return 0;
  if (kind >= FMU_V_SET) return axisrt_c_has_position_control(m->runtime, axis) ? FMU_REAL : 0;
  if (kind >= FMU_INTERFACE) return axisrt_c_has_interface(m->runtime, axis) ? FMU_REAL : 0;
  if (kind == FMU_STATUS) return FMU_ENUMERATION;
  return kind == FMU_SETTLED || kind == FMU_RESET ? FMU_BOOLEAN : FMU_REAL;
}

/* 0: no variable of this machine. */
static int type_of(const fmu* m, uint32_t reference) {
  uint32_t const block = reference / 16;
  if (reference == 0) return FMU_REAL;
  if (block == 0) return 0;
  if (block <= m->axis_count) return type_of_kind(m, block - 1, reference % 16);
  return (reference - 16 * (m->axis_count + 1)) / 2 < m->channel_count ? FMU_ENUMERATION : 0;
}

fmu_result fmu_get(fmu* m, uint32_t reference, int types, double* value) {
  uint32_t const block = reference / 16;
  uint32_t const of_channel = reference - 16 * (m->axis_count + 1);
  if ((type_of(m, reference) & types) == 0)
    return fail(m, FMU_ERROR, "this FMU has no variable of this type");
  if (m->phase == FMU_INITIALIZING && !m->is_settled) settle(m);
  if (block == 0) {
    *value = m->time;
  } else if (block <= m->axis_count) {
    *value = m->value[reference % 16][block - 1];
  } else {
    *value = (of_channel % 2 == 0 ? m->command : m->command_status)[of_channel / 2];
  }
  return FMU_OK;
}

static int is_input(uint32_t kind) {
  return kind == FMU_SETPOINT || kind == FMU_RESET || kind == FMU_INTERFACE || kind == FMU_V_SET ||
         kind == FMU_V_MOTOR || kind == FMU_V_DIRECT;
}

fmu_result fmu_set(fmu* m, uint32_t reference, int types, double value) {
  uint32_t const block = reference / 16;
  uint32_t const of_channel = reference - 16 * (m->axis_count + 1);
  if ((type_of(m, reference) & types) == 0)
    return fail(m, FMU_ERROR, "this FMU has no variable of this type");
  if (m->phase == FMU_TERMINATED) return fail(m, FMU_ERROR, "the simulation is terminated");
  m->is_settled = 0;
  if (block > 0 && block <= m->axis_count && is_input(reference % 16)) {
    m->value[reference % 16][block - 1] = value;
    return FMU_OK;
  }
  if (block <= m->axis_count || of_channel % 2 != 0) return fail(m, FMU_ERROR, "only inputs can be set");
  if (!(value >= 0 &&
        value < first_bank(m, of_channel / 2) + axisrt_c_bank_count(m->runtime, of_channel / 2)))
    return fail(m, FMU_ERROR, "the channel has no filter setting of this number");
  m->command[of_channel / 2] = value;
  return FMU_OK;
}

/* ---- phases and states ------------------------------------------------------------------------- */

fmu_result fmu_enter_initialization(fmu* m, double start) {
  if (m->phase != FMU_INSTANTIATED) return fail(m, FMU_ERROR, "the FMU is initialized already");
  m->time = start;
  m->phase = FMU_INITIALIZING;
  return FMU_OK;
}

fmu_result fmu_exit_initialization(fmu* m) {
  if (m->phase != FMU_INITIALIZING) return fail(m, FMU_ERROR, "the FMU is not in initialization mode");
  settle(m);
  m->phase = FMU_STEPPING;
  return FMU_OK;
}

fmu_result fmu_terminate(fmu* m) {
  if (m->phase != FMU_STEPPING) return fail(m, FMU_ERROR, "the FMU is not being simulated");
  m->phase = FMU_TERMINATED;
  return FMU_OK;
}

fmu_result fmu_reset(fmu* m) {
  return begin(m) ? FMU_OK : fail(m, FMU_ERROR, "the runtime cannot be made anew");
}

/* A state is the address of its instance, and a copy of it. */
fmu_result fmu_keep_state(fmu* m, void** state) {
  if (*state == NULL) *state = take_block(sizeof(double) + m->size);
  if (*state == NULL) return fail(m, FMU_ERROR, "there is no memory for a state");
  memcpy(*state, &m, sizeof m);
  memcpy((uint8_t*)*state + sizeof(double), m, m->size);
  return FMU_OK;
}

fmu_result fmu_restore_state(fmu* m, const void* state) {
  fmu* owner = NULL;
  if (state != NULL) memcpy(&owner, state, sizeof owner);
  if (owner != m) return fail(m, FMU_ERROR, "the state is not one of this instance");
  memcpy((void*)m, (const uint8_t*)state + sizeof(double), m->size);
  return FMU_OK;
}

void fmu_free_state(void* state) {
  if (state != NULL) give_back(state);
}
