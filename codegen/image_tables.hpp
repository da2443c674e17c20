// The sections of an image while its records are added.
#pragma once

#include "codegen/image_fields.hpp"
#include "codegen/image_layout.hpp"
#include "codegen/self_test.hpp"
#include "codegen/shared_runs.hpp"

#include <vector>

namespace axisc::codegen {

struct ImageTables {
  SectionTable<records::axis> axes{sections::axes};
  SectionTable<records::filter> filters{sections::filters};
  SectionTable<records::coefficients> coefficients{sections::coefficients};
  SectionTable<records::kernel> kernels{sections::kernels};
  SectionTable<records::tail> tails{sections::tails};
  SectionTable<records::slot> slots{sections::slots};
  SectionTable<records::group> groups{sections::groups};
  SectionTable<records::member> members{sections::members};
  SectionTable<records::bank> banks{sections::banks};
  SectionTable<records::choice> choices{sections::choices};
  SectionTable<records::control> controls{sections::controls};
  SectionTable<records::stage> stages{sections::stages};
  TextPool names;
  SectionTable<records::sample> self_tests{sections::self_tests};
  SectionTable<records::list> lists{sections::lists};
  SectionTable<records::value> values{sections::values};
  SectionTable<records::bound> bounds{sections::bounds};
  SharedRuns<SelfTest> sample_runs;

  /// The samples' place; equal self-tests are stored once.
  [[nodiscard]] Range place_samples(SelfTest const& test);
  /// All sections by rising kind. Kernels, channels and position control only where there are any; names,
  /// self-tests and source map not in a stripped image; bounds where they are asked for.
  [[nodiscard]] std::vector<SectionContent const*> contents(bool strip, bool with_bounds) const;
};

}  // namespace axisc::codegen
