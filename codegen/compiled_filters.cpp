#include "codegen/compiled_filters.hpp"

#include <algorithm>
#include <utility>

namespace axisc::codegen {

std::size_t CompiledFilters::index_of(design::FilterSpecification const& specification) {
  auto const known = std::find_if(filters_.begin(), filters_.end(), [&](CompiledFilter const& filter) {
    return filter.specification == specification;
  });
  if (known != filters_.end()) return static_cast<std::size_t>(known - filters_.begin());

  design::FilterDesign design = design::design_filter(specification, cycle_time_, design::Precision::exact);
  FilterProof const proof = prove_filter(design);
  SelfTest self_test = make_self_test(design);
  filters_.push_back({.specification = specification,
                      .design = std::move(design),
                      .proof = proof,
                      .self_test = std::move(self_test)});
  return filters_.size() - 1;
}

CompiledFilter const& CompiledFilters::filter(design::FilterSpecification const& specification) {
  return filters_[index_of(specification)];
}

CompiledFilter CompiledFilters::oscillator(design::OscillatorSpecification const& specification) const {
  CompiledFilter compiled;
  compiled.design = design::design_oscillator(specification, cycle_time_, design::Precision::exact);
  compiled.proof = prove_filter(compiled.design);
  compiled.self_test = make_self_test(compiled.design);
  return compiled;
}

ChainProof CompiledFilters::chain(std::span<validator::ConfiguredFilter const> configured) {
  if (configured.empty()) return {};
  std::vector<std::size_t> indices;
  indices.reserve(configured.size());
  for (validator::ConfiguredFilter const& filter : configured) {
    indices.push_back(index_of(filter.specification));
  }
  if (indices.size() == 1) {
    FilterProof const& proof = filters_[indices.front()].proof;
    return {.peak_gain = proof.peak_gain, .delay_cycles = proof.group_delay};
  }

  auto const [entry, is_new] = chains_.try_emplace(indices);
  if (is_new) {
    std::vector<design::FilterDesign> designs;
    designs.reserve(indices.size());
    for (std::size_t const index : indices) designs.push_back(filters_[index].design);
    entry->second = prove_chain(designs);
  }
  return entry->second;
}

}  // namespace axisc::codegen
