#include "runtime/self_test.hpp"

#include "runtime/control_word.hpp"
#include "runtime/lane.hpp"
#include "runtime/limits.hpp"

namespace axisc::runtime {
namespace {

/// Distance from |value| to the next larger double.
double ulp(double value) {
  uint64_t const bits = magnitude_bits(value);
  return std::bit_cast<double>(bits + 1) - std::bit_cast<double>(bits);
}

/// Samples of a sequence, and how far an output may be off.
class Samples {
 public:
  Samples(ImageView const& view, uint32_t first, uint32_t count) : view_(view), first_(first), count_(count) {
    double largest = 0;
    for (uint32_t i = 0; i < count; ++i) {
      if (magnitude(input(i)) > largest) largest = magnitude(input(i));
    }
    tolerance_ = 2 * ulp(largest);
  }
  [[nodiscard]] uint32_t count() const { return count_; }
  [[nodiscard]] double input(uint32_t i) const { return view_.self_tests[first_ + i][field::sample::input]; }
  [[nodiscard]] bool accepts(uint32_t i, double output) const {
    return is_within(output - view_.self_tests[first_ + i][field::sample::output], tolerance_);
  }

 private:
  ImageView const& view_;
  uint32_t first_;
  uint32_t count_;
  double tolerance_ = 0;
};

/// Base, sum and d of each lane.
struct Signals {
  double values[3 * most_lanes];
};

/// Runs an operation of a batch's first group on the samples, in the lanes from `first_lane` to `last_lane`.
bool passes(Instructions const& instructions, Batch const& batch, uint32_t operation, uint32_t first_lane,
            uint32_t last_lane, Samples const& samples) {
  uint32_t const width = batch.width;
  double previous = 0;
  bool passed = true;
  for (uint32_t i = 0; i < samples.count(); ++i) {
    Signals signals{};
    for (uint32_t lane = first_lane; lane <= last_lane; ++lane) {
      signals.values[lane] = samples.input(i);
      signals.values[2 * width + lane] = samples.input(i) - previous;
    }
    previous = samples.input(i);
    instructions.run_operation(batch, operation, 0, signals.values);
    for (uint32_t lane = first_lane; lane <= last_lane; ++lane) {
      passed = passed && samples.accepts(i, signals.values[lane] + signals.values[width + lane]);
    }
  }
  return passed;
}

void clear_states(Batch const& batch) {
  for (uint32_t i = 0; i < batch.operation_count; ++i) {
    Operation const& operation = batch.operations[i];
    *operation.state = {.position = 0, .group = 0, .section = 0};
    uint32_t const size = operation.kind == OperationKind::delay ? 3 * (operation.delay_cycles + 1)
                                                                 : 2 * operation.section_count;
    for (uint32_t group = 0; group < batch.group_count; ++group) {
      double* const states = batch.states + static_cast<size_t>(group) * batch.state_stride +
                             static_cast<size_t>(operation.first_state) * batch.width;
      bool const has_sections = operation.kind != OperationKind::delay;
      for (uint32_t k = 0; k < size * batch.width; ++k) {
        states[k] = has_sections && k / batch.width % 2 == 1 ? r_at_rest : 0;
      }
    }
  }
}

/// The group of a line as a batch of its own, whose operation has the sections of one filter alone.
struct Excerpt {
  Batch batch;
  double const* constants[most_operations];
};

void cut_out(LinePort const& port, LineChain const& line, Filter const& filter, Excerpt& excerpt) {
  Batch const& whole = port.port.batches[line.batch];
  excerpt.batch = whole;
  excerpt.batch.group_count = 1;
  excerpt.batch.states = whole.states + static_cast<size_t>(line.group) * whole.state_stride;
  excerpt.batch.constants = excerpt.constants;
  for (uint32_t i = 0; i < whole.operation_count; ++i) {
    excerpt.constants[i] = whole.constants[static_cast<size_t>(line.group) * whole.operation_count + i];
  }
  if (filter.kind != FilterKind::passing) return;
  Operation& operation = excerpt.batch.operations[filter.operation];
  operation.section_count = filter.section_count;
  operation.first_state += 2 * filter.first_section;
  excerpt.constants[filter.operation] += static_cast<size_t>(4) * filter.first_section * whole.width;
}

bool passes_unchanged(Samples const& samples) {
  bool passed = true;
  for (uint32_t i = 0; i < samples.count(); ++i) passed = passed && samples.accepts(i, samples.input(i));
  return passed;
}

bool test_filters(ImageView const& view, axisrt const& runtime, LinePort const& port) {
  for (uint32_t i = 0; i < port.port.line_count; ++i) {
    LineChain const& line = port.lines[i];
    for (uint32_t k = line.first_filter; k < line.first_filter + line.filter_count; ++k) {
      Filter const& filter = runtime.filters[k];
      Samples const samples(view, view.filters[k][field::filter::first_sample],
                            view.filters[k][field::filter::sample_count]);
      if (filter.kind == FilterKind::pass_through) {
        if (!passes_unchanged(samples)) return false;
        continue;
      }
      Excerpt excerpt{};
      cut_out(port, line, filter, excerpt);
      clear_states(excerpt.batch);
      bool const passed =
          passes(*runtime.instructions, excerpt.batch, filter.operation, line.lane, line.lane, samples);
      clear_states(excerpt.batch);
      if (!passed) return false;
    }
  }
  return true;
}

/// Every lane of the slot's group works with the kernel.
void put_into_all_lanes(Slot const& slot, Kernel const* kernel, Kernel const** replaced) {
  for (uint32_t lane = 0; lane < slot.width; ++lane) {
    Slot one = slot;
    one.lane = lane;
    if (replaced != nullptr) replaced[lane] = slot.group->kernel[lane];
    switch_slot(one, kernel, 0);
    reset_slot(one);
  }
  start_at_rest(*slot.group, slot.width);
}

bool test_kernel(axisrt const& runtime, LineChain const& line, Slot const& slot, Kernel const* kernel,
                 Samples const& samples) {
  Kernel const* replaced[most_lanes] = {};
  put_into_all_lanes(slot, kernel, replaced);
  Excerpt excerpt{};
  cut_out(runtime.setpoint, line, Filter{}, excerpt);
  uint32_t operation = 0;
  while (excerpt.batch.operations[operation].kind != OperationKind::slot) ++operation;
  excerpt.batch.operations[operation].slots += line.group;
  bool const passed = passes(*runtime.instructions, excerpt.batch, operation, 0, slot.width - 1, samples);
  for (uint32_t lane = 0; lane < slot.width; ++lane) {
    Slot one = slot;
    one.lane = lane;
    switch_slot(one, replaced[lane], 0);
    reset_slot(one);
  }
  start_at_rest(*slot.group, slot.width);
  return passed;
}

bool can_execute(Slot const* slot, Kernel const& kernel) {
  return slot != nullptr && slot->group->block_count >= kernel.block_count;
}

/// The kernels, each on the first slot whose group has a history that is long enough; none where no slot
/// executes it.
bool test_kernels(ImageView const& view, axisrt const& runtime) {
  for (uint32_t i = 0; i < view.kernels.count; ++i) {
    Samples const samples(view, view.kernels[i][field::kernel::first_sample],
                          view.kernels[i][field::kernel::sample_count]);
    Kernel const* const kernel = runtime.kernels + i;
    for (uint32_t axis = 0; axis < runtime.axis_count && samples.count() > 0; ++axis) {
      LineChain const& line = runtime.setpoint.lines[axis];
      Slot const* const slot = line.before != nullptr ? line.before : line.behind;
      if (!can_execute(slot, *kernel)) continue;
      if (!test_kernel(runtime, line, *slot, kernel, samples)) return false;
      break;
    }
  }
  return true;
}

}  // namespace

axisrt_status run_self_tests(ImageView const& view, axisrt const& runtime) {
  PlainArithmetic const arithmetic;
  bool const passed = test_filters(view, runtime, runtime.setpoint) &&
                      test_filters(view, runtime, runtime.additional_interface) &&
                      test_filters(view, runtime, runtime.velocity) && test_kernels(view, runtime);
  return passed ? AXISRT_OK : AXISRT_SELF_TEST_FAILED;
}

}  // namespace axisc::runtime
