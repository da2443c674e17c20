// What one run has designed serves all its machines, and changes none of their images.
#include "codegen/known_designs.hpp"

#include "codegen/image_writer.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <set>
#include <thread>
#include <vector>

namespace axisc::codegen::known_designs_test {
namespace {

using design::FilterSpecification;
using design::FilterType;

constexpr design::CycleTime cycle_time{1'000'000};

FilterSpecification lowpass(double frequency) {
  return {.type = FilterType::lowpass, .order = 2, .frequency = {frequency}};
}

}  // namespace

TEST_CASE("a specification is designed once for each cycle time", "[known-designs]") {
  KnownDesigns designs;
  auto const first = designs.filter(lowpass(30), cycle_time);
  CHECK(designs.filter(lowpass(30), cycle_time) == first);
  CHECK(designs.filter(lowpass(31), cycle_time) != first);
  auto const slower = designs.filter(lowpass(30), {2'000'000});
  CHECK(slower != first);
  CHECK_FALSE(slower->design.sections == first->design.sections);

  design::KernelSpecification const average{.type = design::KernelType::moving_average, .order = 20};
  CHECK(designs.kernel(average, cycle_time) == designs.kernel(average, cycle_time));
  CHECK(designs.oscillator({.frequency = {40}, .damping = 0.1}, cycle_time) !=
        designs.oscillator({.frequency = {40}, .damping = 0.2}, cycle_time));
}

TEST_CASE("numbers that compare equal and are not the same keep their own design", "[known-designs]") {
  KnownDesigns designs;
  FilterSpecification plain = lowpass(30);
  plain.share_percent = 0.0;
  FilterSpecification negative = plain;
  negative.share_percent = -0.0;
  CHECK(designs.filter(plain, cycle_time) != designs.filter(negative, cycle_time));
}

TEST_CASE("a chain has the figures of its filters in series", "[known-designs]") {
  KnownDesigns designs;
  std::vector<FilterSpecification> const one{lowpass(30)};
  CHECK(designs.chain(one, cycle_time).delay_cycles == designs.filter(one[0], cycle_time)->proof.group_delay);
  std::vector<FilterSpecification> const two{lowpass(30), lowpass(80)};
  std::vector<design::FilterDesign> const filters{designs.filter(two[0], cycle_time)->design,
                                                  designs.filter(two[1], cycle_time)->design};
  CHECK(designs.chain(two, cycle_time).peak_gain == prove_chain(filters).peak_gain);
  CHECK(designs.chain(two, cycle_time).delay_cycles > designs.chain(one, cycle_time).delay_cycles);
}

TEST_CASE("not more filters are kept than are worth it, and all are designed", "[known-designs]") {
  KnownDesigns designs;
  std::weak_ptr<CompiledFilter const> const first = designs.filter(lowpass(30), cycle_time);
  CHECK_FALSE(first.expired());
  // Delays are designed in no time.
  auto const delay = [&designs](std::uint32_t number) {
    design::KernelSpecification const specification{
        .type = design::KernelType::time_delay, .order = 1, .share_percent = 1 + number / 100.0};
    return designs.kernel(specification, cycle_time);
  };
  std::weak_ptr<CompiledKernel const> const forgotten = delay(0);
  for (std::uint32_t number = 0; number < 5000; ++number) {
    REQUIRE(delay(number)->design.tail_sums.front() == (1 + number / 100.0) / 100);
  }
  CHECK(forgotten.expired());
  CHECK(delay(0)->design.tail_sums.front() == 0.01);
  CHECK_FALSE(first.expired());
}

TEST_CASE("threads that ask at once get one design", "[known-designs]") {
  KnownDesigns designs;
  std::vector<KnownDesigns::Filter> found(8);
  std::vector<std::thread> threads;
  for (auto& place : found) {
    threads.emplace_back([&designs, &place] { place = designs.filter(lowpass(42), cycle_time); });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(std::set<KnownDesigns::Filter>(found.begin(), found.end()).size() == 1);
}

TEST_CASE("an image does not tell what was compiled before it", "[known-designs]") {
  std::vector<machine::Machine> machines;
  test::Random random(20261121);
  for (int i = 0; i < 6; ++i) machines.push_back(test::random_kernel_machine(random, 0.01));
  machines.push_back(test::kernel_machine());
  KnownDesigns forwards, backwards;
  std::vector<std::vector<std::byte>> images;
  for (auto const& machine : machines) images.push_back(write_image(machine, {}, forwards));
  for (std::size_t i = machines.size(); i-- > 0;) CHECK(write_image(machines[i], {}, backwards) == images[i]);
  for (std::size_t i = 0; i < machines.size(); ++i) CHECK(write_image(machines[i], {}) == images[i]);
}

}  // namespace axisc::codegen::known_designs_test
