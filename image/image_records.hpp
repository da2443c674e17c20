// The sections of an image that axisrt_verify accepts, so that every range lies in its section.
#pragma once

#include "codegen/image_fields.hpp"
#include "codegen/record.hpp"
#include "image/image_contents.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace axisc::image {

/// Records of one section. A higher minor version may have longer ones; known fields are at their beginning.
template <class RecordType>
class Records {
 public:
  Records() = default;
  Records(std::span<std::byte const> bytes, std::size_t stride) : bytes_(bytes), stride_(stride) {}

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(bytes_.size() / stride_); }
  [[nodiscard]] codegen::ConstRecord<RecordType> operator[](std::size_t i) const {
    return codegen::ConstRecord<RecordType>(bytes_.subspan(i * stride_, stride_));
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
  [[nodiscard]] std::string text(codegen::ConstRecord<RecordType> record,
                                 codegen::Field<RecordType, std::uint32_t> offset,
                                 codegen::Field<RecordType, std::uint32_t> size) const {
    return text(record.get(offset), record.get(size));
  }
  [[nodiscard]] std::string text(std::uint32_t offset, std::uint32_t size) const;

  /// Fills the samples of whatever has a self-test.
  template <class Tested>
  void read_samples(std::uint32_t first, std::uint32_t count, Tested& tested) const {
    for (std::uint32_t i = 0; i < count; ++i) {
      tested.self_test_input.push_back(self_tests[first + i].get(codegen::fields::sample::input));
      tested.self_test_output.push_back(self_tests[first + i].get(codegen::fields::sample::output));
    }
  }

  codegen::ConstRecord<codegen::records::header> header;
  Records<codegen::records::axis> axes;
  Records<codegen::records::filter> filters;
  Records<codegen::records::coefficients> coefficients;
  Records<codegen::records::kernel> kernels;
  Records<codegen::records::tail> tails;
  Records<codegen::records::slot> slots;
  Records<codegen::records::group> groups;
  Records<codegen::records::member> members;
  Records<codegen::records::bank> banks;
  Records<codegen::records::choice> choices;
  Records<codegen::records::control> controls;
  Records<codegen::records::stage> stages;
  Records<codegen::records::byte> names;
  Records<codegen::records::sample> self_tests;
  Records<codegen::records::list> lists;
  Records<codegen::records::value> values;
};

/// A number that a later version knows and this one does not counts as `documented`: it changes no output.
template <class Reading>
[[nodiscard]] constexpr Reading known_reading(std::uint32_t number, std::span<std::string_view const> words) {
  return number < words.size() ? static_cast<Reading>(number) : Reading::documented;
}

/// Filters of a chain, one after the other.
[[nodiscard]] std::vector<ImageFilter> read_chain(ImageRecords const& image, std::uint32_t first,
                                                  std::uint32_t count);
[[nodiscard]] ImageKernel read_kernel(ImageRecords const& image,
                                      codegen::ConstRecord<codegen::records::kernel> record);
[[nodiscard]] ImageSlot read_slot(codegen::ConstRecord<codegen::records::slot> record);
[[nodiscard]] ImageGroup read_group(ImageRecords const& image,
                                    codegen::ConstRecord<codegen::records::group> record);
[[nodiscard]] ImageControl read_control(ImageRecords const& image,
                                        codegen::ConstRecord<codegen::records::control> record);

}  // namespace axisc::image
