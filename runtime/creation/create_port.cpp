#include "runtime/creation/building.hpp"
#include "runtime/double_bits.hpp"
#include "runtime/lane.hpp"
#include "runtime/limits.hpp"

#include <limits>

namespace axisc::runtime {
namespace {

ChainKind chain_kind(Shape const& shape) {
  if (shape.step_count != 1) return ChainKind::any;
  if (shape.steps[0].kind == OperationKind::slot) return ChainKind::slot;
  if (shape.steps[0].kind != OperationKind::passing) return ChainKind::any;
  switch (shape.steps[0].section_count) {
    case 1: return ChainKind::sections_1;
    case 2: return ChainKind::sections_2;
    case 4: return ChainKind::sections_4;
    case 6: return ChainKind::sections_6;
    default: return ChainKind::any;
  }
}

constexpr double unlimited = std::numeric_limits<double>::infinity();

PortLayout const& layout_of(Layout const& layout, PortKind port) {
  switch (port) {
    case PortKind::setpoint: return layout.setpoint;
    case PortKind::additional_interface: return layout.additional_interface;
    default: return layout.velocity;
  }
}

/// The step of a line, which may be shorter than that of its group.
Shape::Step step_of(ImageView const& view, PortKind port, uint32_t line, uint32_t step) {
  return shape_of(view, line_at(view, port, line)).steps[step];
}

class PortBuilder {
 public:
  PortBuilder(ImageView const& view, PortKind port, uint32_t lanes, Layout const& layout, Memory memory)
      : view_(view),
        port_(port),
        lanes_(lanes),
        kernels_(memory.part<Kernel>(layout.kernels)),
        filters_(memory.part<Filter>(layout.filters)),
        slots_(memory.part<Slot>(layout.slots)),
        slot_switches_(memory.part<SlotSwitch>(layout.slot_switches)) {
    PortLayout const& own = layout_of(layout, port);
    batches_ = memory.part<Batch>(own.batches);
    lines_ = memory.part<LineChain>(own.lines);
    group_lines_ = memory.part<uint32_t>(own.lanes);
    batch_states_ = memory.part<BatchState>(own.batch_states);
    pieces_ = memory.part<double const*>(own.pieces);
    constants_ = memory.part<double>(own.constants);
    operation_states_ = memory.part<OperationState>(own.operation_states);
    slot_groups_ = memory.part<SlotGroup>(own.slot_groups);
    lane_tails_ = memory.part<double>(own.lane_tails);
    states_ = memory.part<double>(own.states);
  }

  LinePort build() {
    Grouping grouping(view_, port_, lanes_);
    Group group{};
    Group before{};
    while (grouping.next(group)) {
      bool const continues = batch_count_ > 0 && same_layout(before, group);
      if (!continues) begin_batch(group);
      add_group(group, continues ? &before : nullptr);
      before = group;
    }
    return {
        .port = {.batches = batches_, .batch_count = batch_count_, .line_count = count_lines(view_, port_)},
        .lines = lines_};
  }

 private:
  void begin_batch(Group const& group) {
    Batch& batch = batches_[batch_count_++];
    batch = {.width = group.width,
             .group_count = 0,
             .used_in_last = 0,
             .operation_count = group.shape.step_count,
             .state_stride = state_stride(group),
             .consecutive = 1,
             .kind = chain_kind(group.shape),
             .operations = {},
             .state = batch_states_++,
             .states = states_,
             .constants = pieces_,
             .lines = group_lines_};
    *batch.state = {.never_reset = 0};
    uint32_t first_state = GroupParts::operations;
    for (uint32_t i = 0; i < batch.operation_count; ++i) {
      Shape::Step const& step = group.shape.steps[i];
      *operation_states_ = {.position = 0, .group = 0, .section = 0};
      batch.operations[i] = {.kind = step.kind,
                             .section_count = step.section_count,
                             .delay_cycles = step.delay_cycles,
                             .first_state = first_state,
                             .slots = nullptr,
                             .state = operation_states_++};
      first_state += state_size(step);
      if (step.kind == OperationKind::slot) batch.operations[i].slots = slot_groups_;
    }
  }

  void add_group(Group const& group, Group const* before) {
    Batch& batch = batches_[batch_count_ - 1];
    for (uint32_t lane = 0; lane < group.width; ++lane) {
      bool const follows = group_lines_ == batch.lines || group.lines[lane] == group_lines_[-1] + 1;
      if (!follows) batch.consecutive = 0;
      *group_lines_++ = group.lines[lane];
    }
    for (uint32_t i = 0; i < batch.state_stride; ++i) states_[i] = 0;
    for (uint32_t lane = 0; lane < group.width; ++lane) {
      states_[GroupParts::largest_increment * group.width + lane] = unlimited;
    }
    for (uint32_t i = 0; i < group.shape.step_count; ++i) {
      clear_sections(batch.operations[i], group.width);
      if (group.shape.steps[i].kind == OperationKind::slot) {
        build_slot_group(batch, group, i);
        *pieces_ = nullptr;
      } else if (before != nullptr && same_constants(view_, port_, *before, group, i)) {
        *pieces_ = *(pieces_ - batch.operation_count);
      } else {
        *pieces_ = constants_;
        constants_ += write_constants(group, i);
      }
      ++pieces_;
    }
    for (uint32_t lane = 0; lane < group.width; ++lane) finish_lane(batch, group, lane);
    states_ += batch.state_stride;
    batch.group_count += 1;
    batch.used_in_last = group.used;
  }

  void clear_sections(Operation const& operation, uint32_t width) {
    for (uint32_t i = 0; i < operation.section_count; ++i) {
      double* const r = states_ + static_cast<size_t>(operation.first_state + 2 * i + 1) * width;
      for (uint32_t lane = 0; lane < width; ++lane) r[lane] = r_at_rest;
    }
  }

  /// Doubles used so far. Sections that a lane does not have stay zero: they change nothing.
  uint64_t write_constants(Group const& group, uint32_t index) {
    Shape::Step const& step = group.shape.steps[index];
    uint64_t const size = whole_lines(uint64_t{constants_size(step)} * group.width);
    for (uint64_t i = 0; i < size; ++i) constants_[i] = 0;
    for (uint32_t lane = 0; lane < group.width; ++lane) {
      uint32_t const line = group.lines[lane];
      uint32_t row = 0;
      auto const put = [&](double smallest, double value) {
        constants_[(row++) * group.width + lane] = unless_below(smallest, value);
      };
      Shape::Step const own = step_of(view_, port_, line, index);
      uint32_t const first = line_at(view_, port_, line).first_filter + own.first_filter;
      if (step.kind != OperationKind::passing) {
        Record<record::filter> const filter = view_.filters[first];
        put(smallest_coefficient, filter[field::filter::share]);
        put(smallest_coefficient, filter[field::filter::direct]);
        put(smallest_rest, filter[field::filter::direct_low]);
      }
      for (uint32_t i = 0; i < own.filter_count; ++i) {
        Record<record::filter> const filter = view_.filters[first + i];
        for (uint32_t k = 0; k < filter[field::filter::section_count]; ++k) {
          Record<record::coefficients> const section =
              view_.coefficients[filter[field::filter::first_section] + k];
          put(smallest_numerator, section[field::coefficients::p]);
          put(smallest_coefficient, section[field::coefficients::p] + section[field::coefficients::q]);
          put(smallest_coefficient, section[field::coefficients::k]);
          put(smallest_coefficient, section[field::coefficients::b]);
        }
      }
    }
    return size;
  }

  void build_slot_group(Batch const& batch, Group const& group, uint32_t index) {
    Shape::Step const& step = group.shape.steps[index];
    uint64_t const tails = uint64_t{padded_tails(step.block_count)} * group.width;
    uint32_t const last = (step.block_count * block_cycles - 1) * group.width;
    for (uint64_t i = 0; i < 2 * tails; ++i) lane_tails_[i] = 0;
    SlotGroup& slots = *slot_groups_++;
    slots = {.mode = SlotMode::direct,
             .gathers = 0,
             .block = 0,
             .phase = 0,
             .ramp_phase = 0,
             .fading = 0,
             .block_count = step.block_count,
             .next_ahead = 0,
             .used = group.used,
             .reserved = 0,
             .common = nullptr,
             .to = lane_tails_ + last,
             .from = lane_tails_ + tails + last,
             .kernel = {},
             .before = {},
             .fade_position = {},
             .fade_length = {}};
    lane_tails_ += 2 * tails;
    for (uint32_t lane = 0; lane < group.width; ++lane) {
      uint32_t const number = step_of(view_, port_, group.lines[lane], index).slot;
      Record<record::slot> const record = view_.slots[number];
      uint32_t const kernel = record[field::slot::kernel];
      uint32_t const on = record[field::slot::on_at_start];
      Kernel const* const pass = kernels_ + view_.kernels.count;
      Kernel const* const listed = kernel == AXIM_NONE ? pass : kernels_ + kernel;
      uint32_t const history = record[field::slot::history];
      Slot const slot{
          .group = &slots,
          .parts = states_ + static_cast<size_t>(batch.operations[index].first_state) * group.width,
          .state = slot_switches_ + number,
          .listed = listed,
          .width = group.width,
          .lane = lane,
          .history_length = history > 0 ? history : 1,
          .family = record[field::slot::family],
          .on_at_start = on,
          .reserved = 0};
      slots.kernel[lane] = pass;
      slots.before[lane] = pass;
      switch_slot(slot, on != 0 ? listed : pass, 0);
      reset_slot(slot);
      if (lane >= group.used) continue;
      *slot.state = {.on = on};
      slots_[number] = slot;
    }
    start_at_rest(slots, group.width);
  }

  /// Lanes without a line of their own run along, and count as reset.
  void finish_lane(Batch const& batch, Group const& group, uint32_t lane) {
    uint32_t const line = group.lines[lane];
    if (lane >= group.used) {
      states_[GroupParts::reset_done * batch.width + lane] = std::bit_cast<double>(all_set);
      return;
    }
    Line const image_line = line_at(view_, port_, line);
    lines_[line] = {.batch = batch_count_ - 1,
                    .group = batch.group_count,
                    .lane = lane,
                    .first_filter = image_line.first_filter,
                    .filter_count = image_line.filter_count,
                    .reserved = 0,
                    .before = image_line.before == AXIM_NONE ? nullptr : slots_ + image_line.before,
                    .behind = image_line.behind == AXIM_NONE ? nullptr : slots_ + image_line.behind};
    place_filters(image_line);
    // An axis without a filter on its additional interface has nothing to reset there.
    if (port_ == PortKind::additional_interface && image_line.filter_count == 0) {
      states_[GroupParts::reset_done * batch.width + lane] = std::bit_cast<double>(all_set);
    } else {
      batch.state->never_reset += 1;
    }
  }

  void place_filters(Line const& line) {
    for (uint32_t i = 0; i < line.filter_count; ++i) {
      filters_[line.first_filter + i] = {.kind = FilterKind::pass_through,
                                         .operation = 0,
                                         .first_section = 0,
                                         .section_count = 0,
                                         .delay_cycles = 0};
    }
    Shape const shape = shape_of(view_, line);
    for (uint32_t step = 0; step < shape.step_count; ++step) {
      place_filters_of_step(line, shape.steps[step], step);
    }
  }

  void place_filters_of_step(Line const& line, Shape::Step const& step, uint32_t operation) {
    uint32_t section = 0;
    for (uint32_t i = 0; i < step.filter_count; ++i) {
      uint32_t const number = line.first_filter + step.first_filter + i;
      uint32_t const sections = view_.filters[number][field::filter::section_count];
      if (sections == 0 && step.kind != OperationKind::delay) continue;
      filters_[number] = {.kind = kind_of(step.kind),
                          .operation = operation,
                          .first_section = section,
                          .section_count = sections,
                          .delay_cycles = step.delay_cycles};
      section += sections;
    }
  }

  static FilterKind kind_of(OperationKind kind) {
    switch (kind) {
      case OperationKind::passing: return FilterKind::passing;
      case OperationKind::shared: return FilterKind::shared;
      case OperationKind::blocking: return FilterKind::blocking;
      case OperationKind::delay: return FilterKind::delay;
      default: return FilterKind::pass_through;
    }
  }

  ImageView const& view_;
  PortKind port_;
  uint32_t lanes_;
  Kernel const* kernels_;
  Filter* filters_;
  Slot* slots_;
  SlotSwitch* slot_switches_;
  // Parts of the memory that are used up one after the other.
  Batch* batches_ = nullptr;
  LineChain* lines_ = nullptr;
  uint32_t* group_lines_ = nullptr;
  BatchState* batch_states_ = nullptr;
  double const** pieces_ = nullptr;
  double* constants_ = nullptr;
  OperationState* operation_states_ = nullptr;
  SlotGroup* slot_groups_ = nullptr;
  double* lane_tails_ = nullptr;
  double* states_ = nullptr;
  uint32_t batch_count_ = 0;
};

bool same_filter(Record<record::filter> a, Record<record::filter> b) {
  return a[field::filter::first_section] == b[field::filter::first_section] &&
         a[field::filter::section_count] == b[field::filter::section_count] &&
         a[field::filter::share] == b[field::filter::share] &&
         a[field::filter::direct] == b[field::filter::direct] &&
         a[field::filter::direct_low] == b[field::filter::direct_low];
}

}  // namespace

uint32_t state_stride(Group const& group) {
  uint32_t per_lane = GroupParts::operations;
  for (uint32_t i = 0; i < group.shape.step_count; ++i) per_lane += state_size(group.shape.steps[i]);
  return static_cast<uint32_t>(whole_lines(uint64_t{per_lane} * group.width));
}

bool same_constants(ImageView const& view, PortKind port, Group const& a, Group const& b, uint32_t step) {
  for (uint32_t lane = 0; lane < a.width; ++lane) {
    Shape::Step const one = step_of(view, port, a.lines[lane], step);
    Shape::Step const other = step_of(view, port, b.lines[lane], step);
    if (one.filter_count != other.filter_count) return false;
    uint32_t const first_of_one = line_at(view, port, a.lines[lane]).first_filter + one.first_filter;
    uint32_t const first_of_other = line_at(view, port, b.lines[lane]).first_filter + other.first_filter;
    for (uint32_t i = 0; i < one.filter_count; ++i) {
      if (!same_filter(view.filters[first_of_one + i], view.filters[first_of_other + i])) return false;
    }
  }
  return true;
}

LinePort build_port(ImageView const& view, PortKind port, uint32_t lanes, Layout const& layout,
                    Memory memory) {
  return PortBuilder(view, port, lanes, layout, memory).build();
}

}  // namespace axisc::runtime
