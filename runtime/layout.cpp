#include "runtime/layout.hpp"

#include "runtime/runtime_object.hpp"

namespace axisc::runtime {
namespace {

/// Hands out memory from the beginning to the end.
class Reservation {
 public:
  template <class T>
  uint64_t take(uint64_t count) {
    static_assert(alignof(T) <= AXISRT_ALIGNMENT);
    uint64_t const offset = end_;
    uint64_t const bytes = count * sizeof(T);
    end_ += (bytes + AXISRT_ALIGNMENT - 1) / AXISRT_ALIGNMENT * AXISRT_ALIGNMENT;
    return offset;
  }
  [[nodiscard]] uint64_t end() const { return end_; }

 private:
  uint64_t end_ = 0;
};

}  // namespace

Amounts count_amounts(ImageView const& view) {
  Amounts amounts{
      .axes = view.axes.count, .filters = view.filters.count, .sections = view.coefficients.count};
  for (uint32_t i = 0; i < view.filters.count; ++i) {
    amounts.section_states += view.filters[i][field::filter::section_count];
    amounts.ring_signals += view.filters[i][field::filter::delay_cycles];
  }
  return amounts;
}

Layout lay_out(Amounts const& amounts) {
  Reservation memory;
  Layout layout;
  layout.object = memory.take<axisrt>(1);
  layout.axes = memory.take<Axis>(amounts.axes);
  layout.setpoint_chains = memory.take<Chain>(amounts.axes);
  layout.interface_chains = memory.take<Chain>(amounts.axes);
  layout.filters = memory.take<Filter>(amounts.filters);
  layout.sections = memory.take<Section>(amounts.sections);
  layout.setpoint_states = memory.take<ChainState>(amounts.axes);
  layout.interface_states = memory.take<ChainState>(amounts.axes);
  layout.section_states = memory.take<SectionState>(amounts.section_states);
  layout.ring_positions = memory.take<uint32_t>(amounts.filters);
  layout.ring_signals = memory.take<Signal>(amounts.ring_signals);
  layout.size = memory.end();
  return layout;
}

}  // namespace axisc::runtime
