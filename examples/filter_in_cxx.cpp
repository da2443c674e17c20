// The runtime in C++20: a step of 1000 units on every axis of an image, one line per NC cycle.
//
//   filter_in_cxx IMAGE [CYCLES]
#include "axisrt.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

void require(axisrt_status status) {
  if (status != AXISRT_OK) throw std::runtime_error(axisrt_status_text(status));
}

/// Bytes where the runtime wants them.
class AlignedMemory {
 public:
  explicit AlignedMemory(std::size_t size)
      : bytes_(static_cast<std::byte*>(::operator new (size, std::align_val_t{AXISRT_ALIGNMENT}))),
        size_(size) {}
  [[nodiscard]] std::byte* data() const { return bytes_.get(); }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  struct Release {
    void operator()(std::byte* bytes) const { ::operator delete (bytes, std::align_val_t{AXISRT_ALIGNMENT}); }
  };
  std::unique_ptr<std::byte, Release> bytes_;
  std::size_t size_;
};

AlignedMemory load(std::string const& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> const content{std::istreambuf_iterator<char>(file), {}};
  AlignedMemory memory(content.size());
  std::copy(content.begin(), content.end(), reinterpret_cast<char*>(memory.data()));
  return memory;
}

/// Image, memory and runtime belong together and live equally long.
class Filters {
 public:
  Filters(std::string const& path, std::uint32_t cycle_time_ns) : image_(load(path)) {
    axisrt_config config{};
    config.size = sizeof config;
    config.cycle_time_ns = cycle_time_ns;
    config.image = image_.data();
    config.image_size = image_.size();
    std::size_t alignment = 0;
    require(axisrt_memory_size(&config, &config.memory_size, &alignment));
    memory_ = std::make_unique<AlignedMemory>(config.memory_size);
    config.memory = memory_->data();
    require(axisrt_create(&config, &runtime_));
  }
  [[nodiscard]] std::uint32_t axes() const { return axisrt_axis_count(runtime_); }
  void reset(std::uint32_t axis, double position) { require(axisrt_reset(runtime_, axis, position)); }
  void step(std::span<double const> in, std::span<double> out) {
    require(axisrt_step(runtime_, in.data(), out.data(), nullptr));
  }

 private:
  AlignedMemory image_;
  std::unique_ptr<AlignedMemory> memory_;
  axisrt* runtime_ = nullptr;
};

void execute(std::string const& path, int cycles) {
  Filters filters(path, 1'000'000);
  for (std::uint32_t axis = 0; axis < filters.axes(); ++axis) filters.reset(axis, 0);
  std::vector<double> const in(filters.axes(), 1000.0);
  std::vector<double> out(in.size());
  for (int cycle = 0; cycle < cycles; ++cycle) {
    filters.step(in, out);
    std::printf("%d", cycle);
    for (double const position : out) std::printf(" %.17g", position);
    std::printf("\n");
  }
}

}  // namespace

int main(int argc, char* argv[]) {
  if (argc < 2) {
    std::fputs("usage: filter_in_cxx IMAGE [CYCLES]\n", stderr);
    return 2;
  }
  try {
    execute(argv[1], argc > 2 ? std::atoi(argv[2]) : 20);
    return 0;
  } catch (std::exception const& error) {
    std::fprintf(stderr, "%s: %s\n", argv[1], error.what());
    return 1;
  }
}
