#include "validator/rules/proved_chain.hpp"

#include "runtime/bounds/response.hpp"

#include <algorithm>
#include <memory>
#include <vector>

namespace axisc::validator::checks {
namespace {

namespace bounds = runtime::bounds;

/// Poles this far inside the unit circle come to rest in far less than bounds::longest_walk cycles, whatever
/// else is in the chain. Next to -1, where states are differences of large numbers, rounding counts for more.
constexpr double clear_reserve = 1e-4;
constexpr double clear_reserve_of_fast_poles = 1e-3;

bool is_clear(design::FilterDesign const& filter) {
  bool const has_fast_poles =
      std::any_of(filter.sections.begin(), filter.sections.end(),
                  [](design::IncrementSection const& section) { return section.k + section.b > 2; });
  return 1 - filter.pole_radius >= (has_fast_poles ? clear_reserve_of_fast_poles : clear_reserve);
}

void append(bounds::Chain& chain, design::FilterDesign const& filter) {
  if (filter.realisation == design::Realisation::pass_through) return;
  std::vector<bounds::StoredSection> sections;
  sections.reserve(filter.sections.size());
  for (auto const& [p, q, k, b] : filter.sections) sections.push_back({.p = p, .q = q, .k = k, .b = b});
  append(chain,
         {.first = 0,
          .count = static_cast<std::uint32_t>(sections.size()),
          .delay = filter.realisation == design::Realisation::delay ? filter.delay_cycles : 0,
          .blocks_constant = filter.blocks_constant,
          .share = filter.share.filtered,
          .direct = filter.share.direct},
         sections.data());
}

bool is_loadable(design::FilterDesign const& filter) {
  return std::all_of(filter.sections.begin(), filter.sections.end(), design::is_loadable);
}

}  // namespace

Proof proof_of(std::span<design::FilterDesign const> quick,
               std::span<design::FilterSpecification const> specifications, design::CycleTime cycle_time) {
  if (std::all_of(quick.begin(), quick.end(), is_clear)) return Proof::tight;
  auto const chain = std::make_unique<bounds::Chain>();
  clear(*chain);
  for (design::FilterSpecification const& specification : specifications) {
    auto const exact = design::design_filter(specification, cycle_time, design::Precision::exact);
    if (1 - exact.pole_radius < smallest_reserve || !is_loadable(exact)) return Proof::tight;
    append(*chain, exact);
  }
  if (!chain->is_certain) return Proof::uncertain;
  auto const response = std::make_unique<bounds::Response>();
  bounds::KernelPart const no_kernel{
      .tails = {}, .first = 0, .count = 0, .is_before = false, .tail_sum = 0, .tap_sum = 1};
  follow_response(*chain, no_kernel, *response);
  return response->ended ? Proof::tight : Proof::loose;
}

}  // namespace axisc::validator::checks
