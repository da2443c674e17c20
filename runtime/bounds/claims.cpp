#include "runtime/bounds/claims.hpp"

namespace axisc::runtime::bounds {
namespace {

bool is_same_key(BoundRecord const& a, BoundRecord const& b) {
  return a.axis == b.axis && a.port == b.port && a.kernel == b.kernel && a.stage == b.stage;
}

/// 0 claims nothing where nothing can be claimed.
bool is_true(double claimed, double computed, bool is_certain) {
  return is_certain ? claimed >= computed : claimed == 0;
}

}  // namespace

Claim failing_claim(BoundRecord const& claimed, BoundRecord const& computed) {
  // Chains without sections have no states, and their roundings may be 0.
  bool const is_certain = (computed.flags & axim_bound_majorant) == 0 || computed.state_increment > 0;
  bool const rests = computed.rest_cycles > 0;
  if (!is_same_key(claimed, computed)) return Claim::key;
  if (claimed.flags != computed.flags) return Claim::flags;
  if (claimed.cycles != computed.cycles) return Claim::cycles;
  if (!(claimed.gain_low <= computed.gain_low)) return Claim::gain_low;
  if (!(claimed.gain_high >= computed.gain_high)) return Claim::gain_high;
  if (!(claimed.overshoot_high >= computed.overshoot_high)) return Claim::overshoot_high;
  if (!(claimed.distance_high >= computed.distance_high)) return Claim::distance_high;
  if (!(claimed.radius_high >= computed.radius_high)) return Claim::radius_high;
  if (!is_true(claimed.rounding_increment, computed.rounding_increment, is_certain)) {
    return Claim::rounding_increment;
  }
  if (!is_true(claimed.rounding_position, computed.rounding_position, is_certain)) {
    return Claim::rounding_position;
  }
  if (!is_true(claimed.state_increment, computed.state_increment, is_certain)) return Claim::state_increment;
  if (!is_true(claimed.state_position, computed.state_position, is_certain)) return Claim::state_position;
  bool const rest_holds = rests ? claimed.rest_cycles >= computed.rest_cycles : claimed.rest_cycles == 0;
  if (!rest_holds) return Claim::rest_cycles;
  if (!is_true(claimed.limit_error, computed.limit_error, is_certain)) return Claim::limit_error;
  return Claim::none;
}

char const* name_of(Claim claim) {
  switch (claim) {
    case Claim::none: return "none";
    case Claim::key: return "key";
    case Claim::flags: return "flags";
    case Claim::cycles: return "cycles";
    case Claim::gain_low: return "gain_low";
    case Claim::gain_high: return "gain_high";
    case Claim::overshoot_high: return "overshoot_high";
    case Claim::distance_high: return "distance_high";
    case Claim::radius_high: return "radius_high";
    case Claim::rounding_increment: return "rounding_increment";
    case Claim::rounding_position: return "rounding_position";
    case Claim::state_increment: return "state_increment";
    case Claim::state_position: return "state_position";
    case Claim::rest_cycles: return "rest_cycles";
    case Claim::limit_error: return "limit_error";
  }
  return "none";
}

}  // namespace axisc::runtime::bounds
