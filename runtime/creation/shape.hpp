// Which lines an image has, what their chains do, and in which groups they are executed side by side.
#pragma once

#include "runtime/batch.hpp"
#include "runtime/verification/image_view.hpp"

#include <stdint.h>

namespace axisc::runtime {

/// A port's lines: axes for setpoint and interface, stages for velocity. The numbers are the image's.
enum class PortKind : uint32_t {
  setpoint = axim_port_setpoint,
  additional_interface = axim_port_interface,
  velocity = axim_port_velocity
};

/// A signal and its chain in the image.
struct Line {
  uint32_t first_filter;
  uint32_t filter_count;
  uint32_t before;  ///< HSC slot in the image, or AXIM_NONE
  uint32_t behind;  ///< FIR slot in the image, or AXIM_NONE
};

[[nodiscard]] uint32_t count_lines(ImageView const& view, PortKind port);
[[nodiscard]] Line line_at(ImageView const& view, PortKind port, uint32_t index);

/// The steps of a chain; parts that pass the signal unchanged are left out.
struct Shape {
  struct Step {
    OperationKind kind;
    uint32_t section_count;
    uint32_t delay_cycles;
    uint32_t block_count;   ///< of a slot's history
    uint32_t first_filter;  ///< of the line's filters, for sections and delays: which begins here
    uint32_t filter_count;
    uint32_t slot;  ///< in the image
  };
  Step steps[most_operations];
  uint32_t step_count;
};

[[nodiscard]] Shape shape_of(ImageView const& view, Line const& line);

/// Doubles per lane of a step in the state and in the constants of a group.
[[nodiscard]] uint32_t state_size(Shape::Step const& step);
[[nodiscard]] uint32_t constants_size(Shape::Step const& step);

/// Blocks of a history that holds this many increments and the block that is being filled; at least the two
/// that are applied in every cycle.
[[nodiscard]] constexpr uint32_t blocks_of(uint32_t tail_count) {
  return tail_count < 2 ? 2 : (tail_count + block_cycles - 2) / block_cycles + 1;
}

/// Lines that are executed side by side. The shape is the largest of theirs in every respect.
struct Group {
  uint32_t width;
  uint32_t used;  ///< lanes with a line of their own; the others repeat the first
  uint32_t lines[most_lanes];
  Shape shape;
};

[[nodiscard]] bool same_layout(Group const& a, Group const& b);

/// Gives the groups of a port, those of the same shape one after the other. Needs no memory but its own:
/// lines of the first `most_shapes` shapes are grouped, those of any further shape are alone. Costs at most a
/// pass over the lines for each of these shapes, whatever the image is.
class Grouping {
 public:
  Grouping(ImageView const& view, PortKind port, uint32_t lanes);
  /// False at the end.
  bool next(Group& group);

 private:
  struct Key {
    uint64_t steps;     ///< kinds, delays, blocking sections: only equal ones are in one group
    uint64_t sections;  ///< long chains first
  };
  struct Kind {
    Key key;
    uint32_t first_line;
    uint32_t left;  ///< lines that are not in a group yet
  };
  static constexpr uint32_t most_shapes = 32;

  [[nodiscard]] Key key_of(uint32_t line) const;
  [[nodiscard]] static bool less(Key const& a, Key const& b);
  /// The place of a key among the kinds, or where it would be.
  [[nodiscard]] uint32_t place_of(Key const& key) const;
  [[nodiscard]] bool is_kind(uint32_t place, Key const& key) const;
  void count_line(uint32_t line);
  bool next_line(uint32_t& line);
  bool next_alone(uint32_t& line);
  [[nodiscard]] uint32_t left_of_steps(uint64_t steps) const;

  ImageView const& view_;
  PortKind port_;
  uint32_t lanes_;
  uint32_t line_count_;
  Kind kinds_[most_shapes];  ///< in ascending order
  uint32_t kind_count_ = 0;
  uint32_t alone_ = 0;          ///< lines of further shapes that are left
  uint32_t present_ = 0;        ///< kind whose lines are handed out
  uint32_t position_ = 0;       ///< in the pass over the lines
  uint32_t left_of_steps_ = 0;  ///< lines with the steps of the latest group that are not in a group yet
};

}  // namespace axisc::runtime
