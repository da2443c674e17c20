#include "codegen/image_tables.hpp"

namespace axisc::codegen {

Range ImageTables::place_samples(SelfTest const& test) {
  return sample_runs.place(test, static_cast<std::uint32_t>(test.input.size()), self_tests.count(),
                           [&](std::uint32_t i) {
                             Record<records::sample> record = self_tests.append();
                             record.set(fields::sample::input, test.input[i]);
                             record.set(fields::sample::output, test.output[i]);
                           });
}

std::vector<SectionContent const*> ImageTables::contents(bool strip, bool with_bounds) const {
  std::vector<SectionContent const*> sections = {&axes.content(), &filters.content(),
                                                 &coefficients.content()};
  for (SectionContent const* section :
       {&kernels.content(), &tails.content(), &slots.content(), &groups.content(), &members.content(),
        &banks.content(), &choices.content(), &controls.content(), &stages.content()}) {
    if (section->count() > 0) sections.push_back(section);
  }
  if (!strip) {
    sections.insert(sections.end(),
                    {&names.content(), &self_tests.content(), &lists.content(), &values.content()});
  }
  if (with_bounds) sections.push_back(&bounds.content());
  return sections;
}

}  // namespace axisc::codegen
