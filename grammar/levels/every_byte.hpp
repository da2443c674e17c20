// Vectors of equal bytes, to compare with and to add.
#pragma once

namespace axisc::grammar {

/// For each ASCII character as many as the widest vector has. Filled in a source of its own: where compilers know the bytes,
/// they build such a vector anew for every line, in three instructions, instead of comparing with memory in one.
struct EveryByte {
  constexpr EveryByte() {
    for (unsigned byte = 0; byte < 128; ++byte) {
      for (unsigned char& each : of[byte]) each = static_cast<unsigned char>(byte);
    }
  }
  alignas(32) unsigned char of[128][32] = {};
};
extern EveryByte const every_byte;

}  // namespace axisc::grammar
