// Damaged images are refused by axisrt_c, or executed without a fault (the sanitizers watch); what axisrt
// accepts it accepts, and computes the same.
#include "support/catch.hpp"
#include "tests/runtime/bounds/bounded_image.hpp"
#include "tests/runtime/c99/motion.hpp"
#include "tests/runtime/c99/random_image.hpp"
#include "tests/runtime/mutation.hpp"

#include <string>
#include <vector>

using namespace axisc::test;

namespace {

void poke_hostile(Random& random, Bytes& bytes) {
  std::size_t const at = random.below(static_cast<std::uint32_t>(bytes.size()));
  constexpr std::uint32_t numbers[] = {0, 1, 2, 0xFFFFFFFF, 0x7FFFFFFF, 0x80000000, 0x7FF00000, 3, 64, 1024};
  if (random.chance(2) && at / 4 * 4 + 4 <= bytes.size()) {
    poke(bytes, at / 4 * 4, numbers[random.below(std::size(numbers))], 4);
  } else {
    bytes[at] ^= static_cast<std::uint8_t>(1U << random.below(8));
  }
}

void execute(CRuntime& runtime) {
  std::uint32_t const axes = axisrt_c_axis_count(runtime.runtime);
  std::vector<double> out(axes);
  for (std::uint32_t axis = 0; axis < axes; ++axis) {
    axisrt_c_reset(runtime.runtime, axis, 1e9);
    axisrt_c_reset_interface(runtime.runtime, axis, -1e9);
    axisrt_c_reset_velocity(runtime.runtime, axis, 1, 2, 3);
  }
  for (double const in : {1e9, -0x1p53, 0x1p53, 0.0, 1e-300}) {
    std::vector<double> const setpoints(axes, in);
    axisrt_c_step(runtime.runtime, setpoints.data(), out.data(), nullptr);
    axisrt_c_step_interface(runtime.runtime, setpoints.data(), out.data(), nullptr);
    axisrt_c_step_velocity(runtime.runtime, setpoints.data(), setpoints.data(), nullptr, out.data(), nullptr,
                           nullptr);
    for (std::uint32_t group = 0; group < axisrt_c_group_count(runtime.runtime); ++group) {
      for (int action = AXISRT_C_SET; action <= AXISRT_C_GUARD_OFF; ++action) {
        axisrt_c_command(runtime.runtime, group, static_cast<axisrt_c_action>(action),
                         axisrt_c_bank_count(runtime.runtime, group) - 1);
      }
    }
  }
}

struct Answers {
  int accepted = 0, refused = 0;
};

Answers damage(std::uint32_t images, int times) {
  Answers answers;
  for (std::uint32_t seed = 0; seed < images; ++seed) {
    Bytes const whole = seed == 0   ? write_image(complete_image())
                        : seed == 1 ? write_image(channel_image())
                                    : write_image(random_image(8 * seed + 3));
    Random random(seed);
    for (int i = 0; i < times; ++i) {
      Bytes bytes = whole;
      for (std::uint32_t k = 0; k <= random.below(3); ++k) poke_hostile(random, bytes);
      repair_checksums(bytes);
      INFO("image " << seed << ", damage " << i);
      TestRuntime const checked(bytes, static_cast<std::uint32_t>(peek(bytes, 32, 4)), AXISRT_LEVEL_PORTABLE);
      if (checked.status == AXISRT_OK) {
        Twins twins(bytes);
        move(random, twins, 20);
        REQUIRE(twins.difference == "");
      }
      CRuntime runtime(bytes);
      (runtime.runtime != nullptr ? answers.accepted : answers.refused) += 1;
      if (runtime.runtime != nullptr) execute(runtime);
    }
  }
  return answers;
}

}  // namespace

TEST_CASE("axisrt_c refuses damaged images or executes them without a fault") {
  Answers const answers = damage(6, 100);
  CHECK(answers.accepted > 20);
  CHECK(answers.refused > 20);
}

TEST_CASE("axisrt_c refuses damaged images or executes them, many of them", "[.long]") {
  Answers const answers = damage(300, 1000);
  WARN(answers.accepted << " executed, " << answers.refused << " refused");
}

TEST_CASE("axisrt_c names what is wrong with an image") {
  auto const status = [](Bytes const& bytes) { return CRuntime(bytes).status; };
  Bytes const good = write_image(channel_image());
  CHECK(status(good) == AXISRT_C_OK);
  CHECK(status({}) == AXISRT_C_TOO_SHORT);
  CHECK(status({good.begin(), good.begin() + 100}) == AXISRT_C_TOO_SHORT);
  CHECK(status({good.begin(), good.end() - 1}) == AXISRT_C_TOO_SHORT);
  Bytes longer = good;
  longer.push_back(0);
  CHECK(status(longer) == AXISRT_C_WRONG_SIZE);
  Bytes changed = good;
  changed[0] = 'a';
  CHECK(status(changed) == AXISRT_C_WRONG_MAGIC);
  changed = good;
  changed[4] = 2;
  CHECK(status(changed) == AXISRT_C_WRONG_VERSION);
  for (std::size_t const at : {40U, 200U, static_cast<unsigned>(good.size() - 1)}) {
    changed = good;
    changed[at] ^= 1U;
    CHECK(status(changed) == AXISRT_C_WRONG_CHECKSUM);
  }
}

TEST_CASE("axisrt_c accepts what a later minor version may add, and a signature") {
  ImageRecord image = channel_image();
  image.format_minor = 3;
  image.longer_records = 16;
  image.foreign = ForeignSection{.kind = 99, .flags = 1, .content = Bytes(80, 7)};
  CHECK(CRuntime(write_image(image)).status == AXISRT_C_OK);
  image.foreign->flags = 0;
  CHECK(CRuntime(write_image(image)).status == AXISRT_C_UNKNOWN_KIND);
  Bytes is_signed = write_image(channel_image());
  for (char const letter : std::string("AXSG\1")) is_signed.push_back(static_cast<std::uint8_t>(letter));
  is_signed.resize(is_signed.size() + 75);
  CHECK(CRuntime(is_signed).status == AXISRT_C_OK);
}

TEST_CASE("axisrt and axisrt_c accept any flags of the sections that they know") {
  Bytes const image = with_bounds(channel_image());
  auto const sections = static_cast<std::uint32_t>(peek(image, 28, 4));
  REQUIRE(entry_offset(image, bounds_kind) != 0);
  for (std::uint32_t section = 0; section < sections; ++section) {
    std::size_t const entry = static_cast<std::size_t>(peek(image, 8, 4)) + std::size_t{32} * section;
    for (std::uint32_t const flags : {0U, 1U, 3U, 0x80000000U}) {
      Bytes changed = image;
      poke(changed, entry + 4, flags, 4);
      repair_checksums(changed);
      INFO("kind " << peek(changed, entry, 4) << ", flags " << flags);
      CHECK(verify(changed) == AXISRT_OK);
      CHECK(CRuntime(changed).status == AXISRT_C_OK);
    }
  }
}

TEST_CASE("axisrt and axisrt_c skip unknown sections whose flags are 1, and no others") {
  ImageRecord image = channel_image();
  for (std::uint32_t const flags : {0U, 1U, 2U, 3U, 0x80000001U}) {
    image.foreign = ForeignSection{.kind = 99, .flags = flags, .content = Bytes(80, 7)};
    Bytes const bytes = write_image(image);
    INFO(flags);
    CHECK(verify(bytes) == (flags == 1 ? AXISRT_OK : AXISRT_UNKNOWN_KIND));
    CHECK(CRuntime(bytes).status == (flags == 1 ? AXISRT_C_OK : AXISRT_C_UNKNOWN_KIND));
  }
}

TEST_CASE("memory of axisrt_c that is too small or misaligned is refused") {
  Bytes const image = write_image(channel_image());
  std::size_t size = 0;
  REQUIRE(axisrt_c_memory_size(image.data(), image.size(), &size) == AXISRT_C_OK);
  AlignedMemory memory(size + 1);
  axisrt_c* runtime = nullptr;
  CHECK(axisrt_c_create(image.data(), image.size(), memory.data(), size - 1, &runtime) ==
        AXISRT_C_MEMORY_TOO_SMALL);
  CHECK(axisrt_c_create(image.data(), image.size(), memory.data() + 1, size, &runtime) ==
        AXISRT_C_MISALIGNED);
  CHECK(axisrt_c_create(image.data(), image.size(), nullptr, size, &runtime) == AXISRT_C_MEMORY_TOO_SMALL);
  CHECK(runtime == nullptr);
  CHECK(axisrt_c_create(image.data(), image.size(), memory.data(), size, &runtime) == AXISRT_C_OK);
}

TEST_CASE("axisrt_c has the numbers of axisrt's statuses, and refuses null pointers") {
  STATIC_REQUIRE(int{AXISRT_C_TOO_SHORT} == AXISRT_TOO_SHORT);
  STATIC_REQUIRE(int{AXISRT_C_WRONG_MAGIC} == AXISRT_WRONG_MAGIC);
  STATIC_REQUIRE(int{AXISRT_C_WRONG_VERSION} == AXISRT_WRONG_VERSION);
  STATIC_REQUIRE(int{AXISRT_C_WRONG_SIZE} == AXISRT_WRONG_SIZE);
  STATIC_REQUIRE(int{AXISRT_C_WRONG_CHECKSUM} == AXISRT_WRONG_CHECKSUM);
  STATIC_REQUIRE(int{AXISRT_C_OUT_OF_BOUNDS} == AXISRT_OUT_OF_BOUNDS);
  STATIC_REQUIRE(int{AXISRT_C_OVERLAP} == AXISRT_OVERLAP);
  STATIC_REQUIRE(int{AXISRT_C_NOT_FINITE} == AXISRT_NOT_FINITE);
  STATIC_REQUIRE(int{AXISRT_C_UNSTABLE} == AXISRT_UNSTABLE);
  STATIC_REQUIRE(int{AXISRT_C_KERNEL_TOO_LONG} == AXISRT_KERNEL_TOO_LONG);
  STATIC_REQUIRE(int{AXISRT_C_UNKNOWN_KIND} == AXISRT_UNKNOWN_KIND);
  STATIC_REQUIRE(int{AXISRT_C_INCONSISTENT_CYCLE} == AXISRT_INCONSISTENT_CYCLE);
  STATIC_REQUIRE(int{AXISRT_C_MISALIGNED} == AXISRT_MISALIGNED);
  STATIC_REQUIRE(int{AXISRT_C_SELF_TEST_FAILED} == AXISRT_SELF_TEST_FAILED);
  STATIC_REQUIRE(int{AXISRT_C_MEMORY_TOO_SMALL} == AXISRT_MEMORY_TOO_SMALL);
  STATIC_REQUIRE(int{AXISRT_C_BAD_ARGUMENT} == AXISRT_BAD_ARGUMENT);
  STATIC_REQUIRE(int{AXISRT_C_BAD_INPUT} == AXISRT_BAD_INPUT);
  STATIC_REQUIRE(int{AXISRT_C_NOT_RESET} == AXISRT_NOT_RESET);
  STATIC_REQUIRE(int{AXISRT_C_IMPLAUSIBLE} == AXISRT_IMPLAUSIBLE);
  STATIC_REQUIRE(int{AXISRT_C_BUSY} == AXISRT_BUSY);
  STATIC_REQUIRE(int{AXISRT_C_NO_BANK} == AXISRT_NO_BANK);
  STATIC_REQUIRE(int{AXISRT_C_NEEDS_STANDSTILL} == AXISRT_NEEDS_STANDSTILL);
  double x = 0;
  CHECK(axisrt_c_reset(nullptr, 0, 0) == AXISRT_C_BAD_ARGUMENT);
  CHECK(axisrt_c_step(nullptr, &x, &x, nullptr) == AXISRT_C_BAD_ARGUMENT);
  CHECK(axisrt_c_command(nullptr, 0, AXISRT_C_OFF, 0) == AXISRT_C_BAD_ARGUMENT);
  CHECK(axisrt_c_axis_count(nullptr) == 0);
  CRuntime const runtime(write_image(channel_image()));
  CHECK(axisrt_c_reset(runtime.runtime, 3, 0) == AXISRT_C_BAD_ARGUMENT);
  CHECK(axisrt_c_command(runtime.runtime, 1, AXISRT_C_OFF, 0) == AXISRT_C_BAD_ARGUMENT);
  CHECK(axisrt_c_command(runtime.runtime, 0, AXISRT_C_ON, 6) == AXISRT_C_NO_BANK);
  CHECK(axisrt_c_step(runtime.runtime, nullptr, &x, nullptr) == AXISRT_C_BAD_ARGUMENT);
}

TEST_CASE("axisrt_c notices a processor that does not compute what the image demands") {
  ImageRecord image = complete_image();
  image.axes[0].filters[0].samples[3].output += 1e-9;
  CHECK(CRuntime(write_image(image)).status == AXISRT_C_SELF_TEST_FAILED);
  image = channel_image();
  image.kernels[1].samples[2].output += 1e-9;
  CHECK(CRuntime(write_image(image)).status == AXISRT_C_SELF_TEST_FAILED);
}
