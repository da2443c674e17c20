#include "axisrt.h"
#include "runtime/runtime_object.hpp"

uint32_t axisrt_abi_version(void) {
  return AXISRT_ABI_VERSION;
}

uint32_t axisrt_axis_count(axisrt const* runtime) {
  return runtime == nullptr ? 0 : runtime->axis_count;
}

uint32_t axisrt_cycle_time_ns(axisrt const* runtime) {
  return runtime == nullptr ? 0 : runtime->cycle_time_ns;
}

uint32_t axisrt_image_version(axisrt const* runtime) {
  return runtime == nullptr ? 0 : runtime->image_version;
}

uint32_t axisrt_level_of(axisrt const* runtime) {
  return runtime == nullptr ? 0 : runtime->instructions->level;
}

char const* axisrt_axis_name(axisrt const* runtime, uint32_t axis, size_t* length) {
  bool const exists = runtime != nullptr && axis < runtime->axis_count && runtime->axes[axis].name_size > 0;
  if (length != nullptr) *length = exists ? runtime->axes[axis].name_size : 0;
  return exists ? reinterpret_cast<char const*>(runtime->names + runtime->axes[axis].name_offset) : "";
}

int axisrt_has_interface(axisrt const* runtime, uint32_t axis) {
  if (runtime == nullptr || axis >= runtime->axis_count) return 0;
  return runtime->additional_interface.lines[axis].filter_count > 0 ? 1 : 0;
}

int axisrt_has_position_control(axisrt const* runtime, uint32_t axis) {
  if (runtime == nullptr) return 0;
  for (uint32_t i = 0; i < runtime->control_count; ++i) {
    if (runtime->controls[i].axis == axis) return 1;
  }
  return 0;
}

uint32_t axisrt_group_count(axisrt const* runtime) {
  return runtime == nullptr ? 0 : runtime->channel_count;
}

char const* axisrt_group_name(axisrt const* runtime, uint32_t group, size_t* length) {
  bool const exists =
      runtime != nullptr && group < runtime->channel_count && runtime->channels[group].name_size > 0;
  if (length != nullptr) *length = exists ? runtime->channels[group].name_size : 0;
  return exists ? reinterpret_cast<char const*>(runtime->names + runtime->channels[group].name_offset) : "";
}
