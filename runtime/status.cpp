#include "axisrt.h"

const char* axisrt_status_text(axisrt_status status) {
  switch (status) {
    case AXISRT_OK: return "No error.";
    case AXISRT_TOO_SHORT: return "The image is shorter than its header says.";
    case AXISRT_WRONG_MAGIC: return "These bytes are not an image.";
    case AXISRT_WRONG_VERSION: return "The image has another major version of the format.";
    case AXISRT_WRONG_SIZE: return "Bytes follow the image that are not a whole signature.";
    case AXISRT_WRONG_CHECKSUM: return "The image was changed or damaged after it was written.";
    case AXISRT_OUT_OF_BOUNDS: return "An offset, a count or a value in the image is outside its range.";
    case AXISRT_OVERLAP: return "Sections of the image overlap or are not aligned.";
    case AXISRT_NOT_FINITE: return "A number in the image is not finite.";
    case AXISRT_UNSTABLE: return "A filter section in the image is not stable.";
    case AXISRT_KERNEL_TOO_LONG: return "A delay in the image is longer than the format allows.";
    case AXISRT_UNKNOWN_KIND: return "The image contains a kind of content that this runtime does not know.";
    case AXISRT_INCONSISTENT_CYCLE: return "The image's cycle time is not between 1 ns and 1 s.";
    case AXISRT_MISALIGNED: return "The image or the memory is not aligned to 64 bytes.";
    case AXISRT_BOUND_FAILED: return "The image claims a bound that does not follow from its coefficients.";
    case AXISRT_OTHER_CYCLE_TIME: return "The image was made for another NC cycle time.";
    case AXISRT_SELF_TEST_FAILED: return "This processor does not compute what the image demands.";
    case AXISRT_MEMORY_TOO_SMALL: return "The memory is smaller than axisrt_memory_size demands.";
    case AXISRT_NO_LEVEL:
      return "This processor or this build does not have the instruction set that was asked for.";
    case AXISRT_UNSIGNED: return "The image is not signed, and this controller demands a signature.";
    case AXISRT_WRONG_SIGNATURE:
      return "The image was changed after it was signed, or signed with another key.";
    case AXISRT_BAD_ARGUMENT:
      return "An argument is null, out of range, of unknown size, or memory that is in use.";
    case AXISRT_OTHER_AXES: return "The image is for another machine: its axes differ.";
    case AXISRT_OLDER_IMAGE: return "The image is older than the active one.";
    case AXISRT_OTHER_IMAGE: return "The image is not the one that was recorded.";
    case AXISRT_BAD_RECORDING: return "This is not a recording, or it has another version or is damaged.";
    case AXISRT_BAD_INPUT: return "A position is not finite or beyond 2^53.";
    case AXISRT_NOT_RESET: return "The axis was never reset to a position.";
    case AXISRT_IMPLAUSIBLE: return "An output moved farther in one cycle than the axis' limits allow.";
    case AXISRT_BUSY: return "A filter of the group is still changing over.";
    case AXISRT_NO_BANK: return "The image has no kernels for these filter parameters.";
    case AXISRT_NOT_WARM: return "The new filters have not followed the motion for long enough.";
    case AXISRT_NEEDS_STANDSTILL: return "These filters can only be changed at standstill.";
  }
  return "Unknown status.";
}

const char* axisrt_status_name(axisrt_status status) {
  switch (status) {
    case AXISRT_OK: return "AXISRT_OK";
    case AXISRT_TOO_SHORT: return "AXISRT_TOO_SHORT";
    case AXISRT_WRONG_MAGIC: return "AXISRT_WRONG_MAGIC";
    case AXISRT_WRONG_VERSION: return "AXISRT_WRONG_VERSION";
    case AXISRT_WRONG_SIZE: return "AXISRT_WRONG_SIZE";
    case AXISRT_WRONG_CHECKSUM: return "AXISRT_WRONG_CHECKSUM";
    case AXISRT_OUT_OF_BOUNDS: return "AXISRT_OUT_OF_BOUNDS";
    case AXISRT_OVERLAP: return "AXISRT_OVERLAP";
    case AXISRT_NOT_FINITE: return "AXISRT_NOT_FINITE";
    case AXISRT_UNSTABLE: return "AXISRT_UNSTABLE";
    case AXISRT_KERNEL_TOO_LONG: return "AXISRT_KERNEL_TOO_LONG";
    case AXISRT_UNKNOWN_KIND: return "AXISRT_UNKNOWN_KIND";
    case AXISRT_INCONSISTENT_CYCLE: return "AXISRT_INCONSISTENT_CYCLE";
    case AXISRT_MISALIGNED: return "AXISRT_MISALIGNED";
    case AXISRT_BOUND_FAILED: return "AXISRT_BOUND_FAILED";
    case AXISRT_OTHER_CYCLE_TIME: return "AXISRT_OTHER_CYCLE_TIME";
    case AXISRT_SELF_TEST_FAILED: return "AXISRT_SELF_TEST_FAILED";
    case AXISRT_MEMORY_TOO_SMALL: return "AXISRT_MEMORY_TOO_SMALL";
    case AXISRT_BAD_ARGUMENT: return "AXISRT_BAD_ARGUMENT";
    case AXISRT_NO_LEVEL: return "AXISRT_NO_LEVEL";
    case AXISRT_OTHER_AXES: return "AXISRT_OTHER_AXES";
    case AXISRT_OLDER_IMAGE: return "AXISRT_OLDER_IMAGE";
    case AXISRT_OTHER_IMAGE: return "AXISRT_OTHER_IMAGE";
    case AXISRT_BAD_RECORDING: return "AXISRT_BAD_RECORDING";
    case AXISRT_UNSIGNED: return "AXISRT_UNSIGNED";
    case AXISRT_WRONG_SIGNATURE: return "AXISRT_WRONG_SIGNATURE";
    case AXISRT_BAD_INPUT: return "AXISRT_BAD_INPUT";
    case AXISRT_NOT_RESET: return "AXISRT_NOT_RESET";
    case AXISRT_IMPLAUSIBLE: return "AXISRT_IMPLAUSIBLE";
    case AXISRT_BUSY: return "AXISRT_BUSY";
    case AXISRT_NO_BANK: return "AXISRT_NO_BANK";
    case AXISRT_NEEDS_STANDSTILL: return "AXISRT_NEEDS_STANDSTILL";
    case AXISRT_NOT_WARM: return "AXISRT_NOT_WARM";
  }
  return "unknown";
}
