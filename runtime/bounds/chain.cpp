#include "runtime/bounds/chain.hpp"

#include "runtime/bounds/outward.hpp"

namespace axisc::runtime::bounds {
namespace {

bool passes_unchanged(Record<record::filter> filter) {
  uint32_t const realisation = filter[field::filter::realisation];
  return realisation == axim_realisation_pass_through ||
         (realisation == axim_realisation_delay && filter[field::filter::delay_cycles] == 0);
}

}  // namespace

void clear(Chain& chain) {
  chain.filter_count = 0;
  chain.section_count = 0;
  chain.delay_cycles = 0;
  chain.final_value = 1;
  chain.is_certain = true;
}

void append(Chain& chain, FilterPart part, StoredSection const* sections) {
  part.first = chain.section_count;
  chain.filters[chain.filter_count++] = part;
  chain.delay_cycles += part.delay;
  if (part.blocks_constant) chain.final_value *= part.direct;
  for (uint32_t k = 0; k < part.count; ++k) {
    SectionBound& bound = chain.sections[chain.section_count++];
    bound = bound_section(sections[k].p, sections[k].q, sections[k].k, sections[k].b, part.blocks_constant);
    chain.is_certain = chain.is_certain && bound.shrinking != 0;
  }
}

void read_chain(ImageView const& view, uint32_t first, uint32_t count, Chain& chain) {
  clear(chain);
  for (uint32_t i = 0; i < count; ++i) {
    Record<record::filter> const filter = view.filters[first + i];
    if (passes_unchanged(filter)) continue;
    bool const delays = filter[field::filter::realisation] == axim_realisation_delay;
    StoredSection sections[axim_most_sections];
    for (uint32_t k = 0; k < filter[field::filter::section_count]; ++k) {
      Record<record::coefficients> const stored = view.coefficients[filter[field::filter::first_section] + k];
      sections[k] = {stored[field::coefficients::p], stored[field::coefficients::q],
                     stored[field::coefficients::k], stored[field::coefficients::b]};
    }
    append(chain,
           {.first = 0,
            .count = filter[field::filter::section_count],
            .delay = delays ? filter[field::filter::delay_cycles] : 0,
            .blocks_constant = filter[field::filter::blocks_constant] != 0,
            .share = filter[field::filter::share],
            .direct = filter[field::filter::direct]},
           sections);
  }
}

KernelPart read_kernel(ImageView const& view, uint32_t kernel, bool is_before) {
  KernelPart part{
      .tails = view.tails, .first = 0, .count = 0, .is_before = is_before, .tail_sum = 0, .tap_sum = 1};
  if (kernel == AXIM_NONE) return part;
  part.first = view.kernels[kernel][field::kernel::first_tail];
  part.count = view.kernels[kernel][field::kernel::tail_count];
  part.tap_sum = 0;
  for (uint32_t j = 0; j <= part.count; ++j) {
    part.tail_sum += magnitude(part.tail(j));
    part.tap_sum += magnitude(part.tap(j));
  }
  part.tail_sum *= second_order;
  part.tap_sum *= second_order;
  return part;
}

}  // namespace axisc::runtime::bounds
