#include "runtime/comparison.hpp"

#include "runtime/lane.hpp"

#include <bit>

namespace axisc::runtime {
namespace {

bool same_name(Axis const& a, Axis const& b) {
  if (a.name_size == 0 || b.name_size == 0) return true;  // stripped
  return a.name_size == b.name_size && a.name_digest == b.name_digest;
}

bool same_number(double a, double b) {
  return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
}

bool same_control(Control const& a, Control const& b) {
  return a.first_stage == b.first_stage && a.stage_count == b.stage_count && a.axis == b.axis &&
         a.source == b.source && same_number(a.limit, b.limit) && same_number(a.scale, b.scale);
}

bool same_stage(Stage const& a, Stage const& b) {
  return a.mode == b.mode && a.axis == b.axis && same_number(a.weight, b.weight);
}

bool same_section(SectionCoefficients const& a, SectionCoefficients const& b) {
  return same_number(a.p, b.p) && same_number(a.g, b.g) && same_number(a.k, b.k) && same_number(a.b, b.b);
}

bool has_share(Filter const& filter) {
  return filter.kind != FilterKind::pass_through && filter.kind != FilterKind::passing;
}

/// A filter with the lane that executes it.
struct PlacedFilter {
  Lane const& lane;
  Filter const& filter;
};

bool same_filter(PlacedFilter const& a, PlacedFilter const& b) {
  bool const same_kind = a.filter.kind == b.filter.kind && a.filter.section_count == b.filter.section_count &&
                         a.filter.delay_cycles == b.filter.delay_cycles;
  if (!same_kind) return false;
  for (uint32_t i = 0; i < a.filter.section_count; ++i) {
    if (!same_section(a.lane.section(a.filter, i), b.lane.section(b.filter, i))) return false;
  }
  for (uint32_t part = 0; part < 3 && has_share(a.filter); ++part) {
    if (!same_number(a.lane.share(a.filter, part), b.lane.share(b.filter, part))) return false;
  }
  return true;
}

/// Filters of line `index` of the velocity side.
bool same_filters(axisrt const& a, axisrt const& b, uint32_t index) {
  LineChain const& line_a = a.velocity.lines[index];
  LineChain const& line_b = b.velocity.lines[index];
  if (line_a.filter_count != line_b.filter_count) return false;
  Lane const lane_a(a.velocity, line_a);
  Lane const lane_b(b.velocity, line_b);
  for (uint32_t i = 0; i < line_a.filter_count; ++i) {
    PlacedFilter const one{.lane = lane_a, .filter = a.filters[line_a.first_filter + i]};
    PlacedFilter const other{.lane = lane_b, .filter = b.filters[line_b.first_filter + i]};
    if (!same_filter(one, other)) return false;
  }
  return true;
}

}  // namespace

bool same_axes(axisrt const& a, axisrt const& b) {
  if (a.axis_count != b.axis_count) return false;
  for (uint32_t i = 0; i < a.axis_count; ++i) {
    if (a.axes[i].number != b.axes[i].number || a.axes[i].type != b.axes[i].type) return false;
    if (!same_name(a.axes[i], b.axes[i])) return false;
  }
  return true;
}

bool same_controls(axisrt const& a, axisrt const& b) {
  if (a.control_count != b.control_count || a.stage_count != b.stage_count) return false;
  for (uint32_t i = 0; i < a.control_count; ++i) {
    if (!same_control(a.controls[i], b.controls[i])) return false;
  }
  for (uint32_t i = 0; i < a.stage_count; ++i) {
    if (!same_stage(a.stages[i], b.stages[i]) || !same_filters(a, b, i)) return false;
  }
  return true;
}

}  // namespace axisc::runtime
