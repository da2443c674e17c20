#include "bench/runtime/load.hpp"

#include "axisrt.h"
#include "codegen/aligned_bytes.hpp"
#include "runtime/format/crc32c.hpp"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cstdio>

namespace axisc::bench {
namespace {

template <class Call>
double best_rate(std::size_t bytes, Call const& call) {
  constexpr int repetitions = 15;
  constexpr int calls = 8;
  double best = 0;
  for (int i = 0; i < repetitions; ++i) {
    auto const begin = std::chrono::steady_clock::now();
    for (int k = 0; k < calls; ++k) call();
    std::chrono::duration<double> const time = std::chrono::steady_clock::now() - begin;
    best = std::max(best, static_cast<double>(bytes) * calls / time.count() * 1e-9);
  }
  return best;
}

}  // namespace

void report_load(std::span<std::byte const> image) {
  codegen::AlignedBytes const bytes(image);
  double const checksum =
      best_rate(bytes.size(), [&] { benchmark::DoNotOptimize(axim_crc32c(bytes.data(), bytes.size())); });
  // Pieces below the size from which the processor's own instruction is used.
  double const portable = best_rate(bytes.size(), [&] {
    constexpr std::size_t piece = 1000;
    uint32_t crc = 0;
    for (std::size_t i = 0; i < bytes.size(); i += piece) {
      crc = axim_crc32c(bytes.data() + i, std::min(piece, bytes.size() - i), crc);
    }
    benchmark::DoNotOptimize(crc);
  });
  double const verify =
      best_rate(bytes.size(), [&] { benchmark::DoNotOptimize(axisrt_verify(bytes.data(), bytes.size())); });
  std::printf("\nimage of %.2f MiB: checksum %.2f GB/s, portable %.2f GB/s, verify %.2f GB/s\n",
              static_cast<double>(bytes.size()) / (1 << 20), checksum, portable, verify);
}

}  // namespace axisc::bench
