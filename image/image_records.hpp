// The sections of an image that axisrt_verify accepts, so that every range lies in its section.
#pragma once

#include "image/image_contents.hpp"
#include "codegen/image_fields.hpp"
#include "codegen/record.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace axisc::image {

/// Records of one section. A higher minor version may have longer ones; what is known stands at their
/// beginning.
template <class RecordType>
class Records {
 public:
  Records() = default;
  Records(std::span<std::byte const> bytes, std::size_t stride) : bytes_(bytes), stride_(stride) {}

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(bytes_.size() / stride_); }
  [[nodiscard]] ConstRecord<RecordType> operator[](std::size_t i) const {
    return ConstRecord<RecordType>(bytes_.subspan(i * stride_, stride_));
  }
  [[nodiscard]] std::span<std::byte const> bytes() const { return bytes_; }

 private:
  std::span<std::byte const> bytes_;
  std::size_t stride_ = RecordType::bytes;
};

struct ImageRecords {
  explicit ImageRecords(std::span<std::byte const> image);

  /// Text in the names section; empty in a stripped image.
  template <class RecordType>
  [[nodiscard]] std::string text(ConstRecord<RecordType> record, Field<RecordType, std::uint32_t> offset,
                                 Field<RecordType, std::uint32_t> size) const {
    return text(record.get(offset), record.get(size));
  }
  [[nodiscard]] std::string text(std::uint32_t offset, std::uint32_t size) const;

  /// Fills the samples of whatever has a self-test.
  template <class Tested>
  void read_samples(std::uint32_t first, std::uint32_t count, Tested& tested) const {
    for (std::uint32_t i = 0; i < count; ++i) {
      tested.self_test_input.push_back(self_tests[first + i].get(fields::sample::input));
      tested.self_test_output.push_back(self_tests[first + i].get(fields::sample::output));
    }
  }

  ConstRecord<records::header> header;
  Records<records::axis> axes;
  Records<records::filter> filters;
  Records<records::coefficients> coefficients;
  Records<records::kernel> kernels;
  Records<records::tail> tails;
  Records<records::slot> slots;
  Records<records::group> groups;
  Records<records::member> members;
  Records<records::bank> banks;
  Records<records::choice> choices;
  Records<records::control> controls;
  Records<records::stage> stages;
  Records<records::byte> names;
  Records<records::sample> self_tests;
  Records<records::list> lists;
  Records<records::value> values;
};

/// Filters of a chain, one after the other.
[[nodiscard]] std::vector<ImageFilter> read_chain(ImageRecords const& image, std::uint32_t first,
                                                  std::uint32_t count);
[[nodiscard]] ImageKernel read_kernel(ImageRecords const& image, ConstRecord<records::kernel> record);
[[nodiscard]] ImageSlot read_slot(ConstRecord<records::slot> record);
[[nodiscard]] ImageGroup read_group(ImageRecords const& image, ConstRecord<records::group> record);
[[nodiscard]] ImageControl read_control(ImageRecords const& image, ConstRecord<records::control> record);

}  // namespace axisc::image
