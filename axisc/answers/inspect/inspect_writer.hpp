// Parts of `axisc inspect` as text.
#pragma once

#include "diagnostics/message.hpp"
#include "image/image_contents.hpp"

#include <complex>
#include <span>
#include <string>
#include <vector>

namespace axisc {

class InspectWriter {
 public:
  InspectWriter(image::ImageContents const& image, Language language) : image_(image), language_(language) {}

  /// The kernels that the axes may execute; empty if there are none.
  [[nodiscard]] std::string kernels_text(std::span<std::size_t const> axes) const;
  /// The channels that one of the axes belongs to, with the effect of each command.
  [[nodiscard]] std::string channels_text(std::span<std::size_t const> axes) const;

 protected:
  [[nodiscard]] std::string say(SentenceRef text, std::vector<Argument> arguments = {}) const;
  [[nodiscard]] std::string row(SentenceRef label, std::string const& value) const;
  [[nodiscard]] std::string rounded(double value) const;
  [[nodiscard]] std::string exact(double value) const;
  [[nodiscard]] std::string milliseconds(double cycles) const;
  /// "10 cycles (10 ms)"
  [[nodiscard]] std::string delay(double cycles) const;
  /// Coefficients and poles of a section, the first numbered 0.
  [[nodiscard]] std::string section(std::size_t index, design::FilterDesign const& made) const;
  /// The linear-phase filter of an axis, or nothing.
  [[nodiscard]] std::string slot_text(std::size_t axis) const;
  /// Improved Position Control of an axis, or nothing.
  [[nodiscard]] std::string control_text(std::size_t axis) const;

  image::ImageContents const& image_;
  Language language_;

 private:
  [[nodiscard]] std::string pole(std::complex<double> pole) const;
  [[nodiscard]] std::string kernel_name(std::optional<std::size_t> kernel) const;
  [[nodiscard]] std::vector<std::string> kernel_row(std::size_t index) const;
  [[nodiscard]] std::string kernel_details(std::size_t index) const;
  [[nodiscard]] std::string change(std::uint32_t fade_cycles) const;
  [[nodiscard]] std::string channel_text(std::size_t index) const;
  [[nodiscard]] std::string stage_text(image::ImageStage const& stage) const;
};

}  // namespace axisc
