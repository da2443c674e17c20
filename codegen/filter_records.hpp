// Records of standard filters, with their sections and self-tests.
#pragma once

#include "codegen/image_tables.hpp"
#include "codegen/known_designs.hpp"
#include "configuration/machine/machine.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace axisc::codegen {

class FilterRecords {
 public:
  FilterRecords(ImageTables& tables, KnownDesigns& designs, design::CycleTime cycle_time, bool strip)
      : tables_(tables), designs_(designs), cycle_time_(cycle_time), strip_(strip) {}

  /// The filters of one chain, in their order.
  Range add(std::uint32_t axis, std::uint32_t port, std::span<machine::ConfiguredFilter const> configured);
  /// The oscillator that begins a stage of Improved Position Control; the stage's filters follow.
  void add(std::uint32_t axis, design::OscillatorSpecification const& oscillator);

 private:
  struct Place {
    std::uint32_t axis, port, index;
  };
  [[nodiscard]] Record<records::filter> append(Place place, CompiledFilter const& compiled);
  [[nodiscard]] Range place_sections(std::vector<design::IncrementSection> const& sections);

  ImageTables& tables_;
  KnownDesigns& designs_;
  design::CycleTime cycle_time_;
  bool strip_;
  SharedRuns<std::vector<design::IncrementSection>> section_runs_;
};

}  // namespace axisc::codegen
