#include "runtime/creation/shape.hpp"

namespace axisc::runtime {
namespace {

/// Slots are in ascending order of their axes.
uint32_t slot_of_axis(ImageView const& view, uint32_t axis) {
  uint32_t begin = 0;
  uint32_t end = view.slots.count;
  while (begin < end) {
    uint32_t const middle = begin + (end - begin) / 2;
    if (view.slots[middle][field::slot::axis] < axis) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  bool const found = begin < view.slots.count && view.slots[begin][field::slot::axis] == axis;
  return found ? begin : AXIM_NONE;
}

OperationKind kind_of(Record<record::filter> filter) {
  if (filter[field::filter::realisation] == axim_realisation_delay) return OperationKind::delay;
  if (filter[field::filter::blocks_constant] != 0) return OperationKind::blocking;
  bool const whole = filter[field::filter::share] == 1 && filter[field::filter::direct] == 0;
  return whole ? OperationKind::passing : OperationKind::shared;
}

bool passes_through(Record<record::filter> filter) {
  uint32_t const realisation = filter[field::filter::realisation];
  return realisation == axim_realisation_pass_through ||
         (realisation == axim_realisation_delay && filter[field::filter::delay_cycles] == 0);
}

void add_slot(ImageView const& view, uint32_t slot, Shape& shape) {
  uint32_t const history = view.slots[slot][field::slot::history];
  shape.steps[shape.step_count++] = {.kind = OperationKind::slot,
                                     .section_count = 0,
                                     .delay_cycles = 0,
                                     .block_count = blocks_of(history > 0 ? history : 1),
                                     .first_filter = 0,
                                     .filter_count = 0,
                                     .slot = slot};
}

void add_filter(ImageView const& view, Line const& line, uint32_t index, Shape& shape) {
  Record<record::filter> const filter = view.filters[line.first_filter + index];
  if (passes_through(filter)) return;
  OperationKind const kind = kind_of(filter);
  Shape::Step* const last = shape.step_count > 0 ? shape.steps + shape.step_count - 1 : nullptr;
  if (kind == OperationKind::passing && last != nullptr && last->kind == kind) {
    last->section_count += filter[field::filter::section_count];
    last->filter_count = index + 1 - last->first_filter;
    return;
  }
  shape.steps[shape.step_count++] = {
      .kind = kind,
      .section_count = filter[field::filter::section_count],
      .delay_cycles = kind == OperationKind::delay ? filter[field::filter::delay_cycles] : 0,
      .block_count = 0,
      .first_filter = index,
      .filter_count = 1,
      .slot = AXIM_NONE};
}

void widen(Shape& shape, Shape const& by) {
  for (uint32_t i = 0; i < shape.step_count; ++i) {
    Shape::Step& step = shape.steps[i];
    Shape::Step const& other = by.steps[i];
    if (step.section_count < other.section_count) step.section_count = other.section_count;
    if (step.block_count < other.block_count) step.block_count = other.block_count;
  }
}

/// The narrowest group that this many lines fill without a wider one that is mostly empty. One or two lines
/// with a linear-phase filter are faster one by one.
uint32_t width_for(uint32_t lines, uint32_t lanes, bool has_slot) {
  if (lines == 1 || (lines == 2 && has_slot)) return 1;
  uint32_t width = 2;
  while (width < lines) width *= 2;
  return width < lanes ? width : lanes;
}

}  // namespace

uint32_t count_lines(ImageView const& view, PortKind port) {
  return port == PortKind::velocity ? view.stages.count : view.axes.count;
}

Line line_at(ImageView const& view, PortKind port, uint32_t index) {
  Line line{.first_filter = 0, .filter_count = 0, .before = AXIM_NONE, .behind = AXIM_NONE};
  if (port == PortKind::velocity) {
    line.first_filter = view.stages[index][field::stage::first_filter];
    line.filter_count = view.stages[index][field::stage::filter_count];
  } else if (port == PortKind::additional_interface) {
    line.first_filter = view.axes[index][field::axis::first_interface_filter];
    line.filter_count = view.axes[index][field::axis::interface_filter_count];
  } else {
    line.first_filter = view.axes[index][field::axis::first_filter];
    line.filter_count = view.axes[index][field::axis::filter_count];
    uint32_t const slot = slot_of_axis(view, index);
    if (slot != AXIM_NONE) {
      bool const hsc = view.slots[slot][field::slot::family] == axim_family_hsc;
      (hsc ? line.before : line.behind) = slot;
    }
  }
  return line;
}

Shape shape_of(ImageView const& view, Line const& line) {
  Shape shape{};
  if (line.before != AXIM_NONE) add_slot(view, line.before, shape);
  for (uint32_t i = 0; i < line.filter_count; ++i) add_filter(view, line, i, shape);
  if (line.behind != AXIM_NONE) add_slot(view, line.behind, shape);
  return shape;
}

uint32_t state_size(Shape::Step const& step) {
  switch (step.kind) {
    case OperationKind::delay: return 3 * (step.delay_cycles + 1);
    case OperationKind::slot: return SlotParts::history + step.block_count * block_cycles;
    default: return 2 * step.section_count;
  }
}

uint32_t constants_size(Shape::Step const& step) {
  switch (step.kind) {
    case OperationKind::passing: return 4 * step.section_count;
    case OperationKind::slot: return 0;
    default: return 3 + 4 * step.section_count;
  }
}

bool same_layout(Group const& a, Group const& b) {
  if (a.width != b.width || a.shape.step_count != b.shape.step_count) return false;
  if (a.used < a.width) return false;  // only the last group of a batch has lanes without a line
  for (uint32_t i = 0; i < a.shape.step_count; ++i) {
    Shape::Step const& one = a.shape.steps[i];
    Shape::Step const& other = b.shape.steps[i];
    if (one.kind != other.kind || one.section_count != other.section_count ||
        one.delay_cycles != other.delay_cycles || one.block_count != other.block_count) {
      return false;
    }
  }
  return true;
}

Grouping::Grouping(ImageView const& view, PortKind port, uint32_t lanes)
    : view_(view), port_(port), lanes_(lanes), line_count_(count_lines(view, port)) {
  for (uint32_t line = 0; line < line_count_; ++line) count_line(line);
  position_ = kind_count_ > 0 ? kinds_[0].first_line : 0;
}

Grouping::Key Grouping::key_of(uint32_t line) const {
  Shape const shape = shape_of(view_, line_at(view_, port_, line));
  Key key{.steps = 0, .sections = 0};
  constexpr uint32_t bits_of_step = 10;
  constexpr uint32_t bits_of_sections = 13;
  for (uint32_t i = 0; i < shape.step_count; ++i) {
    Shape::Step const& step = shape.steps[i];
    uint64_t const kind = static_cast<uint64_t>(step.kind) + 1;
    // Sections that change nothing exist for H(1) = 1 only.
    uint64_t const equal = step.kind == OperationKind::blocking ? step.section_count : step.delay_cycles;
    key.steps |= (kind << 7U | equal) << (bits_of_step * i);
    uint64_t const length = step.section_count * 32U + step.block_count;
    key.sections |= (((1U << bits_of_sections) - 1) - length) << (bits_of_sections * i);
  }
  return key;
}

bool Grouping::less(Key const& a, Key const& b) {
  return a.steps != b.steps ? a.steps < b.steps : a.sections < b.sections;
}

uint32_t Grouping::place_of(Key const& key) const {
  uint32_t begin = 0;
  uint32_t end = kind_count_;
  while (begin < end) {
    uint32_t const middle = begin + (end - begin) / 2;
    if (less(kinds_[middle].key, key)) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return begin;
}

bool Grouping::is_kind(uint32_t place, Key const& key) const {
  return place < kind_count_ && !less(key, kinds_[place].key);
}

void Grouping::count_line(uint32_t line) {
  Key const key = key_of(line);
  uint32_t const place = place_of(key);
  if (is_kind(place, key)) {
    kinds_[place].left += 1;
  } else if (kind_count_ == most_shapes) {
    alone_ += 1;
  } else {
    for (uint32_t i = kind_count_; i > place; --i) kinds_[i] = kinds_[i - 1];
    kinds_[place] = {.key = key, .first_line = line, .left = 1};
    kind_count_ += 1;
  }
}

/// A line of the present kind, or of the next one.
bool Grouping::next_line(uint32_t& line) {
  while (present_ < kind_count_ && kinds_[present_].left == 0) {
    present_ += 1;
    position_ = present_ < kind_count_ ? kinds_[present_].first_line : 0;
  }
  if (present_ == kind_count_) return next_alone(line);
  Kind& kind = kinds_[present_];
  for (;; ++position_) {
    Key const key = key_of(position_);
    if (key.steps == kind.key.steps && key.sections == kind.key.sections) break;
  }
  kind.left -= 1;
  line = position_++;
  return true;
}

bool Grouping::next_alone(uint32_t& line) {
  if (alone_ == 0) return false;
  alone_ -= 1;
  for (;; ++position_) {
    Key const key = key_of(position_);
    if (!is_kind(place_of(key), key)) break;
  }
  line = position_++;
  return true;
}

uint32_t Grouping::left_of_steps(uint64_t steps) const {
  uint32_t left = 0;
  for (uint32_t i = present_; i < kind_count_; ++i) left += kinds_[i].key.steps == steps ? kinds_[i].left : 0;
  return left;
}

bool Grouping::next(Group& group) {
  uint32_t line = 0;
  if (!next_line(line)) return false;
  if (left_of_steps_ == 0) {
    left_of_steps_ = 1 + (present_ < kind_count_ ? left_of_steps(kinds_[present_].key.steps) : 0);
  }
  group.shape = shape_of(view_, line_at(view_, port_, line));
  bool has_slot = false;
  for (uint32_t i = 0; i < group.shape.step_count; ++i) {
    has_slot = has_slot || group.shape.steps[i].kind == OperationKind::slot;
  }
  group.width = width_for(left_of_steps_, lanes_, has_slot);
  group.used = left_of_steps_ < group.width ? left_of_steps_ : group.width;
  for (uint32_t& one : group.lines) one = line;
  for (uint32_t lane = 1; lane < group.used; ++lane) {
    if (!next_line(group.lines[lane])) break;
    widen(group.shape, shape_of(view_, line_at(view_, port_, group.lines[lane])));
  }
  left_of_steps_ -= group.used;
  return true;
}

}  // namespace axisc::runtime
