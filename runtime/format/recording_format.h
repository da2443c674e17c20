/* A recording as axisrt_recorder_dump writes it: words of eight bytes, little-endian. C and C++.
 *
 *   word 0   bytes "AXRD", then version major and minor, 16 bits each
 *   word 1   axisrt_level; number of axes << 32
 *   word 2   cycle time in ns; CRC-32C of the image's payload << 32
 *   word 3   words of the state before the first entry
 *   word 4   words of the entries
 *   word 5   number of entries
 *   word 6   CRC-32C of everything after word 7; CRC-32C of words 0 to 7 with this half 0 << 32
 *   word 7   0
 *   state    as the runtime of this level orders it
 *   entries  oldest first
 *
 * An entry is a word, kind | flags << 8 | status << 16 | axis or group << 32, and the data of its kind; n is
 * the number of axes, s = (n + 7) / 8 words hold a status byte for each axis:
 *   step, step_interface   n inputs, n outputs, s
 *   step_velocity          n v_set, n v_motor, n v_direct, n v_add, n increments, s
 *   reset, reset_interface, rebase   1 number
 *   reset_velocity         v_set, v_motor, v_direct
 *   command                action | keywords << 32, order, share, fcut, quality
 */
#ifndef AXISRT_RECORDING_FORMAT_H
#define AXISRT_RECORDING_FORMAT_H

enum {
  axrd_major = 1,
  axrd_minor = 0,
  axrd_header_words = 8,

  axrd_step = 1,
  axrd_step_interface = 2,
  axrd_step_velocity = 3,
  axrd_reset = 4,
  axrd_reset_interface = 5,
  axrd_reset_velocity = 6,
  axrd_rebase = 7,
  axrd_command = 8,

  axrd_command_words = 5,

  /* Flags: which arrays the caller passed; the words of missing ones are 0. */
  axrd_has_status = 1,
  axrd_has_v_direct = 2,
  axrd_has_increments = 4
};

#endif
