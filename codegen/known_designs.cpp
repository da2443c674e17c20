#include "codegen/known_designs.hpp"

#include "design/kernels/kernel_analysis.hpp"

#include <bit>
#include <cmath>
#include <utility>

namespace axisc::codegen {
namespace {

using Key = std::vector<std::uint64_t>;

std::uint64_t bits(double number) {
  return std::bit_cast<std::uint64_t>(number);
}

void append(Key& key, design::FilterSpecification const& s) {
  key.insert(key.end(),
             {static_cast<std::uint64_t>(s.type), static_cast<std::uint64_t>(s.prototype), s.order,
              bits(s.frequency.value), bits(s.quality), bits(s.time_constant.value), bits(s.share_percent),
              static_cast<std::uint64_t>(s.reading), static_cast<std::uint64_t>(s.cycle_time)});
}

KnownDesigns::Filter proved(design::FilterDesign design) {
  FilterProof const proof = prove_filter(design);
  return std::make_shared<CompiledFilter const>(std::move(design), proof);
}

KernelProof prove(design::KernelDesign const& design) {
  constexpr double settled_within = 1e-9;
  design::StepFigures const step = design::step_figures(design, settled_within);
  KernelProof proof{.peak_gain = step.peak_gain_bound, .overshoot = step.overshoot, .tail_gain = 0};
  for (double const tail : design.tail_sums) proof.tail_gain += std::abs(tail);
  // Of up to 200 sums, in a guard of 960.
  double const rounding = design.tail_sums.size() <= design::longest_kernel_order ? 0x1p-45 : 0x1p-43;
  proof.tail_gain *= 1 + rounding;
  return proof;
}

}  // namespace

KnownDesigns::Filter KnownDesigns::filter(design::FilterSpecification const& specification,
                                          design::CycleTime cycle_time) {
  Key key{cycle_time.nanoseconds};
  append(key, specification);
  return filters_.get(key, [&] {
    return proved(design::design_filter(specification, cycle_time, design::Precision::exact));
  });
}

KnownDesigns::Filter KnownDesigns::oscillator(design::OscillatorSpecification const& specification,
                                              design::CycleTime cycle_time) {
  Key const key{cycle_time.nanoseconds, bits(specification.frequency.value), bits(specification.damping)};
  return oscillators_.get(key, [&] {
    return proved(design::design_oscillator(specification, cycle_time, design::Precision::exact));
  });
}

KnownDesigns::Kernel KnownDesigns::kernel(design::KernelSpecification const& specification,
                                          design::CycleTime cycle_time) {
  Key const key{cycle_time.nanoseconds,
                static_cast<std::uint64_t>(specification.type),
                specification.order,
                bits(specification.frequency.value),
                bits(specification.quality),
                bits(specification.share_percent),
                static_cast<std::uint64_t>(specification.reading),
                static_cast<std::uint64_t>(specification.cycle_time)};
  return kernels_.get(key, [&] {
    design::KernelDesign design = design::design_kernel(specification, cycle_time);
    KernelProof const proof = prove(design);
    return std::make_shared<CompiledKernel const>(std::move(design), proof);
  });
}

ChainProof KnownDesigns::chain(std::span<design::FilterSpecification const> specifications,
                               design::CycleTime cycle_time) {
  if (specifications.size() == 1) {
    FilterProof const proof = filter(specifications.front(), cycle_time)->proof;
    return {.peak_gain = proof.peak_gain, .delay_cycles = proof.group_delay};
  }
  Key key{cycle_time.nanoseconds};
  for (design::FilterSpecification const& specification : specifications) append(key, specification);
  return *chains_.get(key, [&] {
    std::vector<design::FilterDesign> designs;
    designs.reserve(specifications.size());
    for (design::FilterSpecification const& specification : specifications) {
      designs.push_back(filter(specification, cycle_time)->design);
    }
    return std::make_shared<ChainProof const>(prove_chain(designs));
  });
}

}  // namespace axisc::codegen
