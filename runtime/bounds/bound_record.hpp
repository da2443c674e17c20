// The records of the section `bounds`: which there are, and what they claim.
#pragma once

#include "runtime/bounds/response.hpp"
#include "runtime/verification/image_view.hpp"

#include <stdint.h>

namespace axisc::runtime::bounds {

/// The fields of a record, in its order.
struct BoundRecord {
  uint32_t axis, port, kernel, flags, cycles, stage;
  double gain_low, gain_high;
  double overshoot_high;
  double distance_high;
  double radius_high;
  double rounding_increment, rounding_position;
  double state_increment, state_position;
  uint64_t rest_cycles;
  double limit_error;
};

/// A chain that a record is about.
struct BoundKey {
  uint32_t axis, port, kernel, stage;
};

/// As the image stores it.
[[nodiscard]] BoundRecord stored_record(Record<record::bound> record);

/// First filter of a chain in the filters section, and how many they are.
struct FilterRange {
  uint32_t first, count;
};
[[nodiscard]] FilterRange filters_of(ImageView const& view, BoundKey const& key);
/// The kernel of an axis acts before its filters (HSC), not after them.
[[nodiscard]] bool has_kernel_before(ImageView const& view, uint32_t axis);

/// The keys of an image in the order of its records: by axis, the setpoint chain without a kernel, then with
/// each kernel that its slot can execute in ascending order, then that of the interface; after all axes the
/// stages. Chains without a filter and without a slot have no record. Expects an accepted image.
class BoundKeys {
 public:
  explicit BoundKeys(ImageView const& view, uint32_t first_axis = 0) : view_(view), axis_(first_axis) {}
  /// False at the end. Cost: the banks of the axis' group, once for each of its kernels.
  bool next(BoundKey& key);

 private:
  bool next_of_axis(BoundKey& key);
  [[nodiscard]] uint32_t next_kernel(uint32_t slot, uint32_t after) const;

  ImageView const& view_;
  uint32_t axis_;
  uint32_t phase_ = 0;           ///< 0: no kernel, 1: kernels, 2: interface
  uint32_t kernel_ = AXIM_NONE;  ///< of the last key
  uint32_t stage_ = 0;
};

/// Makes a record of one chain that of an equal chain elsewhere.
void set_place(ImageView const& view, BoundKey const& key, BoundRecord& record);

/// Computes records one after the other; what records of one chain have in common is computed once.
class BoundComputation {
 public:
  explicit BoundComputation(ImageView const& view) : view_(view) {}
  /// Cost: N cycles of the chain for each record, some 10 ns per section and cycle.
  void compute(BoundKey const& key, BoundRecord& record);
  /// What its filters are without a kernel.
  [[nodiscard]] Chain const& chain() const { return chain_; }

 private:
  void read_filters(BoundKey const& key);
  void add_response(KernelPart const& kernel, Response const& run, BoundRecord& record);
  void add_arithmetic(KernelPart const& kernel, Response const& run, BoundRecord& record) const;

  ImageView const& view_;
  BoundKey key_{AXIM_NONE, 0, 0, 0};  ///< of `chain_`
  Chain chain_;
  Response alone_;
  Response joint_;
  Response repeated_;
};

/// The largest increment of a setpoint within P-AXIS-00212, in position units per cycle.
[[nodiscard]] double limit_of_axis(ImageView const& view, uint32_t axis);

}  // namespace axisc::runtime::bounds
