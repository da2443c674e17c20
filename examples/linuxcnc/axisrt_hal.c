/* The filters of a coefficient image as a HAL component of LinuxCNC:
 *
 *   loadrt axisrt image=mill.axim period=1000000
 *   addf axisrt.update servo-thread
 *
 * period is the cycle time in ns of the thread that calls axisrt.update; it has to be that of the image.
 *
 * Pins, N being an axis of the image:
 *   axisrt.N.in       float in   command position, in units of the machine
 *   axisrt.N.out      float out  filtered command position; `in` itself while not enabled or at fault
 *   axisrt.N.enable   bit in     on the rising edge filters begin at rest at `in`; true unless linked
 *   axisrt.N.status   u32 out    an axisrt_status, 0 when all is well
 *   axisrt.N.settled  bit out    the filtered position is within P-AXIS-00351 of the command
 *   axisrt.filter-on  bit in     #FILTER ON and OFF, on its edges
 *   axisrt.command-status u32 out  of the latest edge, repeated while filters change over or must stand still
 *   axisrt.fault      bit out    nothing is filtered: the thread's period is not the image's
 * Parameters:
 *   axisrt.N.scale    float rw   units of the list per unit of the machine: 10000: mm, degrees; 254000: inch;
 *                                the filters begin at rest again when it changes
 */
#include "axisrt.h"
#include "hal.h"
#include "rtapi.h"
#include "rtapi_app.h"

#include <errno.h>
#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

MODULE_AUTHOR("The axisc authors");
MODULE_DESCRIPTION("Filters of a coefficient image that axisc compiled");
MODULE_LICENSE("MIT");

static char* image = "";
RTAPI_MP_STRING(image, "path of the coefficient image");
static long period = 0;
RTAPI_MP_LONG(period, "cycle time in ns of the thread that calls axisrt.update");

typedef struct axis_pins {
  hal_float_t* in;
  hal_float_t* out;
  hal_bit_t* enable;
  hal_u32_t* status;
  hal_bit_t* settled;
  hal_float_t scale;
  double used_scale; /* at the latest reset */
  int was_enabled;
} axis_pins;

typedef struct component {
  hal_bit_t* filter_on;
  hal_u32_t* command_status;
  hal_bit_t* fault;
  axis_pins* axes;
  double* setpoints;
  uint8_t* statuses;
  axisrt* runtime;
  uint32_t axis_count;
  uint32_t group_count;
  uint32_t next_group; /* to which the latest edge has not been told yet */
  int is_on;           /* as the latest edge wants it */
  int checked;         /* the thread's period was compared */
} component;

static int component_id = -1;
static component* self = NULL;
static void* image_bytes = NULL;
static void* memory = NULL;

static int report(const char* what, axisrt_status status) {
  rtapi_print_msg(RTAPI_MSG_ERR, "axisrt: %s: %s (%s)\n", what, axisrt_status_text(status),
                  axisrt_status_name(status));
  return -EINVAL;
}

static void* aligned_memory(size_t size) {
  return aligned_alloc(AXISRT_ALIGNMENT, (size + AXISRT_ALIGNMENT - 1) / AXISRT_ALIGNMENT * AXISRT_ALIGNMENT);
}

/* Size of the file at `image`, whose bytes are then at image_bytes; 0 if it cannot be read. */
static size_t load_image(void) {
  FILE* const file = fopen(image, "rb");
  long size = -1;
  size_t got = 0;
  if (file == NULL) {
    rtapi_print_msg(RTAPI_MSG_ERR, "axisrt: image=%s cannot be read: %s\n", image, strerror(errno));
    return 0;
  }
  if (fseek(file, 0, SEEK_END) == 0) size = ftell(file);
  if (size > 0 && fseek(file, 0, SEEK_SET) == 0) {
    image_bytes = aligned_memory((size_t)size);
    if (image_bytes != NULL) got = fread(image_bytes, 1, (size_t)size, file);
  }
  fclose(file);
  if (got == 0) rtapi_print_msg(RTAPI_MSG_ERR, "axisrt: image=%s is empty or cannot be read\n", image);
  return got;
}

static int create_runtime(void) {
  axisrt_config config = {0};
  size_t alignment = 0;
  axisrt_status status = AXISRT_OK;
  if (*image == '\0' || period <= 0 || period > 1000000000L) {
    rtapi_print_msg(RTAPI_MSG_ERR, "axisrt: image=FILE and period=NANOSECONDS of the thread are needed\n");
    return -EINVAL;
  }
  config.size = sizeof config;
  config.image_size = load_image();
  if (config.image_size == 0) return -ENOENT;
  config.image = image_bytes;
  config.cycle_time_ns = (uint32_t)period;
  status = axisrt_memory_size(&config, &config.memory_size, &alignment);
  if (status != AXISRT_OK) return report(image, status);
  memory = aligned_memory(config.memory_size);
  if (memory == NULL) return -ENOMEM;
  config.memory = memory;
  status = axisrt_create(&config, &self->runtime);
  if (status != AXISRT_OK) return report(image, status);
  self->axis_count = axisrt_axis_count(self->runtime);
  self->group_count = axisrt_group_count(self->runtime);
  self->next_group = self->group_count;
  return 0;
}

static int make_axis_pins(axis_pins* axis, int number) {
  int failed = hal_pin_float_newf(HAL_IN, &axis->in, component_id, "axisrt.%d.in", number);
  failed |= hal_pin_float_newf(HAL_OUT, &axis->out, component_id, "axisrt.%d.out", number);
  failed |= hal_pin_bit_newf(HAL_IN, &axis->enable, component_id, "axisrt.%d.enable", number);
  failed |= hal_pin_u32_newf(HAL_OUT, &axis->status, component_id, "axisrt.%d.status", number);
  failed |= hal_pin_bit_newf(HAL_OUT, &axis->settled, component_id, "axisrt.%d.settled", number);
  failed |= hal_param_float_newf(HAL_RW, &axis->scale, component_id, "axisrt.%d.scale", number);
  if (failed != 0) return failed;
  *axis->enable = 1;
  axis->scale = 10000.0;
  return 0;
}

static int make_pins(void) {
  uint32_t i = 0;
  int failed = 0;
  self->axes = hal_malloc((long)(self->axis_count * sizeof *self->axes));
  self->setpoints = hal_malloc((long)(self->axis_count * sizeof *self->setpoints));
  self->statuses = hal_malloc((long)(self->axis_count * sizeof *self->statuses));
  if (self->axes == NULL || self->setpoints == NULL || self->statuses == NULL) return -ENOMEM;
  memset(self->axes, 0, self->axis_count * sizeof *self->axes);
  for (i = 0; i < self->axis_count && failed == 0; ++i) failed = make_axis_pins(&self->axes[i], (int)i);
  failed |= hal_pin_bit_newf(HAL_IN, &self->filter_on, component_id, "axisrt.filter-on");
  failed |= hal_pin_u32_newf(HAL_OUT, &self->command_status, component_id, "axisrt.command-status");
  failed |= hal_pin_bit_newf(HAL_OUT, &self->fault, component_id, "axisrt.fault");
  return failed;
}

/* Tells each group of the edge, one after the other; a busy one is asked again in the next cycle. */
static void command_groups(void) {
  axisrt_filter_command command = {0};
  if ((*self->filter_on != 0) != self->is_on) {
    self->is_on = *self->filter_on != 0;
    self->next_group = 0;
    *self->command_status = AXISRT_OK;
  }
  command.size = sizeof command;
  command.action = self->is_on ? AXISRT_ACTION_ON : AXISRT_ACTION_OFF;
  while (self->next_group < self->group_count) {
    axisrt_status const status = axisrt_command(self->runtime, self->next_group, &command);
    *self->command_status = (hal_u32_t)status;
    if (status == AXISRT_BUSY || status == AXISRT_NEEDS_STANDSTILL) return;
    if (status != AXISRT_OK) {
      report("axisrt.filter-on", status);
      self->next_group = self->group_count;
      return;
    }
    ++self->next_group;
  }
}

static void pass_through(void) {
  uint32_t i = 0;
  for (i = 0; i < self->axis_count; ++i) *self->axes[i].out = *self->axes[i].in;
}

static void update(void* unused, long real_period) {
  uint32_t i = 0;
  (void)unused;
  if (!self->checked) {
    self->checked = 1;
    if (real_period != period) {
      rtapi_print_msg(
          RTAPI_MSG_ERR,
          "axisrt: the thread's period is %ld ns, the image's cycle time %ld ns: nothing is filtered\n",
          real_period, period);
      *self->fault = 1;
    }
  }
  if (*self->fault != 0) {
    pass_through();
    return;
  }
  command_groups();
  for (i = 0; i < self->axis_count; ++i) {
    axis_pins* const axis = &self->axes[i];
    int const has_scale = axis->scale > 0.0 && axis->scale <= DBL_MAX;
    int const is_enabled = *axis->enable != 0 && has_scale;
    int const begins = is_enabled && (!axis->was_enabled || axis->scale != axis->used_scale);
    *axis->status = has_scale ? AXISRT_OK : AXISRT_BAD_ARGUMENT;
    self->setpoints[i] = is_enabled ? *axis->in * axis->scale : 0.0;
    if (begins) axisrt_reset(self->runtime, i, self->setpoints[i]);
    axis->used_scale = axis->scale;
    axis->was_enabled = is_enabled;
  }
  axisrt_step(self->runtime, self->setpoints, self->setpoints, self->statuses);
  for (i = 0; i < self->axis_count; ++i) {
    axis_pins* const axis = &self->axes[i];
    axisrt_axis_state state;
    if (!axis->was_enabled) {
      *axis->out = *axis->in;
      *axis->settled = 1;
      continue;
    }
    *axis->out = self->setpoints[i] / axis->used_scale;
    *axis->status = self->statuses[i];
    if (axisrt_get_axis_state(self->runtime, i, &state) == AXISRT_OK) *axis->settled = state.settled != 0;
  }
}

static int start(void) {
  int failed = 0;
  self = hal_malloc(sizeof *self);
  if (self == NULL) return -ENOMEM;
  memset(self, 0, sizeof *self);
  failed = create_runtime();
  if (failed == 0) failed = make_pins();
  if (failed == 0) failed = hal_export_funct("axisrt.update", update, NULL, 1, 0, component_id);
  return failed;
}

void rtapi_app_exit(void) {
  if (component_id >= 0) hal_exit(component_id);
  component_id = -1;
  free(memory);
  free(image_bytes);
  memory = NULL;
  image_bytes = NULL;
}

int rtapi_app_main(void) {
  int failed = 0;
  component_id = hal_init("axisrt");
  if (component_id < 0) return component_id;
  failed = start();
  if (failed != 0) {
    rtapi_app_exit();
    return failed;
  }
  hal_ready(component_id);
  return 0;
}
