// The designs of a run so far. The machines of a fleet have most of their filters in common, and a design
// depends on nothing but its specification and the cycle time, so each is designed, proved and given its
// self-test once.
#pragma once

#include "codegen/compiled_design.hpp"
#include "design/filter_specification.hpp"
#include "design/oscillator.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace axisc::codegen {

/// Results by a key of numbers, bit for bit. Several threads may ask. If two ask at once for a missing
/// result, both compute it, and both get the one that was stored first. Some thousand results are kept, then
/// all are forgotten.
template <typename Result>
class SharedResults {
 public:
  using Key = std::vector<std::uint64_t>;

  /// `make()` gives the result of a new key, as a shared pointer.
  template <typename Make>
  [[nodiscard]] std::shared_ptr<Result const> get(Key const& key, Make make) {
    {
      std::lock_guard const lock(mutex_);
      auto const known = results_.find(key);
      if (known != results_.end()) return known->second;
    }
    std::shared_ptr<Result const> made = make();
    std::lock_guard const lock(mutex_);
    // Where every machine has filters of its own, there is nothing to gain by keeping them.
    if (results_.size() >= most_results && !results_.contains(key)) results_.clear();
    return results_.try_emplace(key, std::move(made)).first->second;
  }

 private:
  static constexpr std::size_t most_results = 4096;

  std::mutex mutex_;
  std::map<Key, std::shared_ptr<Result const>> results_;
};

class KnownDesigns {
 public:
  using Filter = std::shared_ptr<CompiledFilter const>;
  using Kernel = std::shared_ptr<CompiledKernel const>;

  /// Cost: some milliseconds for a new specification, else a search.
  [[nodiscard]] Filter filter(design::FilterSpecification const& specification, design::CycleTime cycle_time);
  [[nodiscard]] Filter oscillator(design::OscillatorSpecification const& specification,
                                  design::CycleTime cycle_time);
  /// For a kernel that changes the signal. Values that its type ignores must have their defaults, otherwise
  /// equal kernels are designed twice.
  [[nodiscard]] Kernel kernel(design::KernelSpecification const& specification, design::CycleTime cycle_time);
  /// Figures of filters in series, at least one.
  [[nodiscard]] ChainProof chain(std::span<design::FilterSpecification const> specifications,
                                 design::CycleTime cycle_time);

 private:
  SharedResults<CompiledFilter> filters_;
  SharedResults<CompiledFilter> oscillators_;
  SharedResults<CompiledKernel> kernels_;
  SharedResults<ChainProof> chains_;
};

}  // namespace axisc::codegen
