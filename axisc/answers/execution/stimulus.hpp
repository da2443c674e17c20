// Input of `axisc run`, cycle by cycle: a signal or the rows of a CSV file.
#pragma once

#include "axisc/answers/execution/signals.hpp"
#include "axisc/files/csv.hpp"
#include "axisc/files/image_file.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace axisc {

/// The meaning of an input column for its axis.
enum class Input : std::uint8_t { setpoint, interface, v_set, v_motor, v_direct };
inline constexpr std::size_t inputs = 5;

/// One column of input: an axis and its port.
struct Channel {
  std::size_t axis = 0;
  Input input = Input::setpoint;
};

[[nodiscard]] Port port_of(Input input);

/// "X", "X.interface", "X.v_set", "X.v_motor", "X.v_direct".
[[nodiscard]] std::string channel_name(image::ImageContents const& image, Channel const& channel);

class Stimulus {
 public:
  virtual ~Stimulus() = default;
  Stimulus(Stimulus const&) = delete;
  Stimulus& operator=(Stimulus const&) = delete;

  [[nodiscard]] virtual std::vector<Channel> const& channels() const = 0;
  /// One number per channel for the next cycle; false at the end.
  [[nodiscard]] virtual bool next(std::span<double> values) = 0;

 protected:
  Stimulus() = default;
};

/// One signal for every axis that has the port; at the velocity port for all three velocities.
class SignalStimulus final : public Stimulus {
 public:
  struct Facts {
    Signal signal;
    double amplitude = 1;
    std::uint64_t cycles = 0;
    Port port = Port::setpoint;
  };
  SignalStimulus(image::ImageContents const& image, Facts const& facts);

  [[nodiscard]] std::vector<Channel> const& channels() const override { return channels_; }
  [[nodiscard]] bool next(std::span<double> values) override;

 private:
  Facts facts_;
  design::CycleTime cycle_time_;
  std::vector<Channel> channels_;
  std::uint64_t cycle_ = 0;
};

/// The columns of a CSV file. A column that the image does not use is a Failure (AX9005).
class CsvStimulus final : public Stimulus {
 public:
  CsvStimulus(image::ImageContents const& image, std::string name, ByteSource source);

  [[nodiscard]] std::vector<Channel> const& channels() const override { return channels_; }
  [[nodiscard]] bool next(std::span<double> values) override { return reader_.next(values); }

 private:
  CsvReader reader_;
  std::vector<Channel> channels_;
};

}  // namespace axisc
