// Images of every format version that ever landed. A committed image is never made anew: what is out in the
// field has to be read for good.
#include "codegen/image_writer.hpp"
#include "codegen/source_digest.hpp"
#include "image/image_contents.hpp"
#include "image/runtime_host.hpp"
#include "machines.hpp"
#include "naive_image.hpp"
#include "support/golden.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace axisc::codegen::golden_image_test {
namespace {

constexpr char const* whole_image = "tests/data/images/v1.0-sample.axim";
constexpr char const* stripped_image = "tests/data/images/v1.0-sample-stripped.axim";
constexpr char const* whole_channel = "tests/data/images/v1.1-channel.axim";
constexpr char const* stripped_channel = "tests/data/images/v1.1-channel-stripped.axim";

std::vector<std::byte> bytes_of(std::string const& path) {
  std::string const text = test::read_source_file(path);
  std::vector<std::byte> bytes(text.size());
  std::transform(text.begin(), text.end(), bytes.begin(),
                 [](char octet) { return static_cast<std::byte>(octet); });
  return bytes;
}

template <class Number>
Number number_at(std::vector<std::byte> const& image, std::size_t at) {
  Number number{};
  std::memcpy(&number, &image.at(at), sizeof number);
  return number;
}

/// A number of each record of a section that axisc 0.2.0 did not round upwards, or took from the unrounded
/// design.
struct ProofField {
  std::uint32_t section = 0;
  std::size_t offset = 0;
  double most_added = 0;
  double most_taken = 0;
};
constexpr std::array proof_fields = {
    ProofField{1, 64, 1e-11},         // peak gain of an axis
    ProofField{2, 104, 6e-8, 1e-15},  // pole radius of a filter, to the nearest
    ProofField{2, 136, 1e-11},        // its peak gain
    ProofField{4, 72, 1e-13},         // peak gain of a kernel
    ProofField{4, 88, 1e-11}};        // its tail gain

std::size_t table_end(std::vector<std::byte> const& image) {
  return 128 + 32 * std::size_t{number_at<std::uint32_t>(image, 28)};
}

void put_checksum(std::vector<std::byte>& image, std::size_t at, std::size_t begin, std::size_t end) {
  std::fill_n(image.begin() + static_cast<std::ptrdiff_t>(at), 4, std::byte{0});
  std::uint32_t const checksum = test::naive_crc32c(image, begin, end);
  std::memcpy(&image.at(at), &checksum, sizeof checksum);
}

/// `image` with the proofs of `other`, which are hardly larger.
void take_proofs(std::vector<std::byte>& image, std::vector<std::byte> const& other) {
  for (std::size_t entry = 128; entry < table_end(image); entry += 32) {
    auto const first = static_cast<std::size_t>(number_at<std::uint64_t>(image, entry + 8));
    std::size_t const size = number_at<std::uint32_t>(image, entry + 24);
    for (std::size_t i = 0; i < number_at<std::uint32_t>(image, entry + 28); ++i) {
      for (ProofField const& field : proof_fields) {
        if (field.section != number_at<std::uint32_t>(image, entry)) continue;
        std::size_t const at = first + i * size + field.offset;
        double const before = number_at<double>(image, at);
        double const now = number_at<double>(other, at);
        CAPTURE(field.section, field.offset, i, before, now);
        CHECK(now >= before - field.most_taken);
        CHECK(now <= before + field.most_added);
        std::memcpy(&image.at(at), &other.at(at), sizeof now);
      }
    }
  }
  put_checksum(image, 24, table_end(image), image.size());
}

/// `image` as if this version of the compiler had written it, in its minor version of the format.
std::vector<std::byte> with_version_of(std::vector<std::byte> image, std::vector<std::byte> const& other) {
  constexpr std::ptrdiff_t minor_version = 6;
  constexpr std::ptrdiff_t version = 80;
  std::copy_n(other.begin() + minor_version, 2, image.begin() + minor_version);
  std::copy_n(other.begin() + version, 16, image.begin() + version);
  if (image.size() == other.size()) take_proofs(image, other);
  put_checksum(image, 12, 0, table_end(image));
  return image;
}

void write_if_missing(char const* path, machine::Machine const& machine, ImageOptions const& options) {
  std::filesystem::path const file = std::filesystem::path(AXISC_SOURCE_DIR) / path;
  if (!test::update_golden() || std::filesystem::exists(file)) return;
  std::filesystem::create_directories(file.parent_path());
  std::vector<std::byte> const image = write_image(machine, options);
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<char const*>(image.data()), static_cast<std::streamsize>(image.size()));
}

}  // namespace

TEST_CASE("today's compiler still writes the images of format 1.0, but for version and proofs",
          "[image][golden]") {
  auto const [path, strip] =
      GENERATE(table<char const*, bool>({{whole_image, false}, {stripped_image, true}}));
  std::vector<std::byte> const golden = bytes_of(path);
  std::vector<std::byte> const today =
      write_image(test::sample_machine(), {.strip = strip, .image_version = 3});
  CHECK(golden.size() == today.size());
  bool const equal = with_version_of(golden, today) == today;
  CHECK(equal);
}

TEST_CASE("today's compiler still writes the images of format 1.1, but for the proofs", "[image][golden]") {
  auto const [path, strip] =
      GENERATE(table<char const*, bool>({{whole_channel, false}, {stripped_channel, true}}));
  ImageOptions const options{.strip = strip, .image_version = 4};
  write_if_missing(path, test::kernel_machine(), options);
  std::vector<std::byte> const golden = bytes_of(path);
  std::vector<std::byte> const today = write_image(test::kernel_machine(), options);
  CHECK(golden.size() == today.size());
  bool const equal = with_version_of(golden, today) == today;
  CHECK(equal);
}

TEST_CASE("an image of format 1.0 is read", "[image][golden]") {
  image::ImageContents const contents = test::contents_of(bytes_of(whole_image));
  CHECK(contents.format_major == 1);
  CHECK(contents.format_minor == 0);
  CHECK(contents.compiler_version == "0.1.0");
  CHECK(contents.cycle_time.nanoseconds == 1'000'000);
  CHECK(contents.image_version == 3);
  REQUIRE(contents.axes.size() == 4);
  CHECK(contents.axes[0].name == "X");
  CHECK(contents.axes[2].name == "Ä");
  CHECK(contents.axes[2].type == 2);
  CHECK(contents.axes[0].filters[0].specification.type == design::FilterType::bandstop);
  CHECK(contents.axes[0].filters[0].specification.frequency.value == 47);
  CHECK(contents.axes[0].values[1].name == "filter[0].order");
  CHECK(contents.axes[0].values[1].list == "axes/x.lis");
  CHECK(contents.lists[2].name == "axes/ä.lis");

  CHECK(test::contents_of(bytes_of(stripped_image)).axes[0].filters.size() == 2);
}

TEST_CASE("an image of format 1.0 runs", "[image][golden]") {
  image::RuntimeHost runtime = test::runtime_for(bytes_of(whole_image));
  REQUIRE(runtime.axis_count() == 4);
  CHECK(runtime.axis_name(1) == "Y");
  CHECK(runtime.reset_all(1e9) == AXISRT_OK);
  std::array<double, 4> const setpoints = {1e9, 1e9, 1e9, 1e9};
  std::array<double, 4> outputs{};
  CHECK(runtime.step(setpoints, outputs) == AXISRT_OK);
  CHECK(outputs[0] == 1e9);
  CHECK(outputs[1] == 0.875e9);
  CHECK(outputs[2] == 1e9);
  CHECK(outputs[3] == 1e9);
}

TEST_CASE("an image of format 1.1 is read", "[image][golden]") {
  image::ImageContents const contents = test::contents_of(bytes_of(whole_channel));
  CHECK(contents.format_minor == 1);
  CHECK(contents.image_version == 4);
  REQUIRE(contents.axes.size() == 5);
  CHECK(contents.kernels[0].specification.type == design::KernelType::gaussian);
  CHECK(contents.kernels[0].design.tail_sums.size() == 22);
  CHECK(contents.axes[2].slot->family == machine::KernelFamily::hsc);
  CHECK(contents.groups[0].name == "mill");
  CHECK(contents.groups[0].banks[1].parameters.order == 40U);
  CHECK(contents.groups[0].banks[6].hsc);
  CHECK(contents.axes[0].control->stages[1].has_oscillator);
  CHECK(contents.axes[3].control->source == 0);

  image::ImageContents const stripped = test::contents_of(bytes_of(stripped_channel));
  CHECK(stripped.groups[0].name.empty());
  CHECK(stripped.kernels.size() == contents.kernels.size());
}

TEST_CASE("an image of format 1.1 runs", "[image][golden]") {
  image::RuntimeHost runtime = test::runtime_for(bytes_of(whole_channel));
  CHECK(runtime.reset_all(1e9) == AXISRT_OK);
  CHECK(runtime.group_count() == 2);
  CHECK(runtime.has_position_control(3));
  std::vector<double> outputs(5);
  machine::FilterCommand command;
  command.filter_switch = machine::FilterSwitch::on;
  command.parameters = test::filter_set(40);
  CHECK(runtime.command(0, command) == AXISRT_OK);
  for (int cycle = 0; cycle < 200; ++cycle) {
    std::vector<double> const inputs(5, 1e9 + 1000.0 * cycle);
    REQUIRE(runtime.step(inputs, outputs) == AXISRT_OK);
  }
  // X lags by the Gaussian's 20 cycles and the PT1's 5; Y's time delay takes the order, 40, too.
  CHECK(outputs[0] == Approx(1e9 + 1000.0 * (199 - 25)).margin(20));
  CHECK(outputs[1] == 1e9 + 1000.0 * (199 - 40));
  CHECK(outputs[3] == 1e9 + 1000.0 * 199);
}

TEST_CASE("images have the same bytes with every compiler, at every optimisation, on every processor",
          "[image][golden]") {
  // Machines without kernels have the bytes that they had in format 1.0.
  bool const with_kernels = GENERATE(false, true);
  test::Random random(1'000'003);
  std::string lines;
  for (int i = 0; i < 24; ++i) {
    // Everything behind the header: it names the compiler's version.
    machine::Machine const machine =
        with_kernels ? test::random_kernel_machine(random, 0.005) : test::random_machine(random, 0.005);
    std::vector<std::byte> const image = write_image(machine, {});
    std::string const content(reinterpret_cast<char const*>(image.data()) + 128, image.size() - 128);
    for (std::uint8_t const octet : sha256(content)) {
      lines += "0123456789abcdef"[octet >> 4U];
      lines += "0123456789abcdef"[octet & 0xFU];
    }
    lines += '\n';
  }
  test::check_golden(with_kernels ? "tests/data/images/v1.1-random-machines.sha256"
                                  : "tests/data/images/v1.0-random-machines.sha256",
                     lines);
}

}  // namespace axisc::codegen::golden_image_test
