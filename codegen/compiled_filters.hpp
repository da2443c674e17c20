// Every distinct filter of a machine is designed, proved and given its self-test once, however many axes use
// it.
#pragma once

#include "codegen/proof.hpp"
#include "codegen/self_test.hpp"
#include "design/filter_design.hpp"
#include "design/oscillator.hpp"
#include "validator/machine.hpp"

#include <cstddef>
#include <map>
#include <span>
#include <vector>

namespace axisc::codegen {

struct CompiledFilter {
  design::FilterSpecification specification;
  design::FilterDesign design;
  FilterProof proof;
  SelfTest self_test;
};

class CompiledFilters {
 public:
  explicit CompiledFilters(design::CycleTime cycle_time) : cycle_time_(cycle_time) {}

  /// Valid until the next call. Cost: some milliseconds for a new specification, else a search.
  [[nodiscard]] CompiledFilter const& filter(design::FilterSpecification const& specification);
  /// Not kept: stages rarely share an oscillator.
  [[nodiscard]] CompiledFilter oscillator(design::OscillatorSpecification const& specification) const;
  /// Figures of filters in series; {1, 0} for none.
  [[nodiscard]] ChainProof chain(std::span<validator::ConfiguredFilter const> configured);

 private:
  [[nodiscard]] std::size_t index_of(design::FilterSpecification const& specification);

  design::CycleTime cycle_time_;
  std::vector<CompiledFilter> filters_;
  std::map<std::vector<std::size_t>, ChainProof> chains_;
};

}  // namespace axisc::codegen
