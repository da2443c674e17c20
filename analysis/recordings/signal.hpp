// Values of a recording, packed: a recording of 100 MB takes no more memory than its text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <variant>
#include <vector>

namespace axisc::recordings {

/// Values are read back exactly. Values that are whole multiples of a power of ten and lie close together
/// take two or four bytes, or none where they rise by equal steps, as times do; those of binary32 take four,
/// others eight.
class Signal {
 public:
  Signal() = default;
  Signal(std::vector<double> const& values);  // NOLINT(google-explicit-constructor): a signal is its values
  Signal(std::initializer_list<double> values) : Signal(std::vector<double>(values)) {}

  void push(double value);
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double front() const { return front_; }  ///< of a signal that is not empty
  [[nodiscard]] double back() const { return back_; }
  /// The values from `first` on; `into` lies within the signal.
  void read(std::size_t first, std::span<double> into) const;
  [[nodiscard]] double at(std::size_t index) const;
  [[nodiscard]] std::vector<double> values() const;

 private:
  struct Block {
    std::int64_t base = 0;
    double per_unit = 1;  ///< values are (base + offset) / per_unit
    /// One number: the step between offsets.
    std::variant<std::int64_t, std::vector<std::int16_t>, std::vector<std::int32_t>, std::vector<float>,
                 std::vector<double>>
        stored{};
  };

  [[nodiscard]] bool pack(double per_unit, Block& block) const;
  void close();

  std::vector<Block> blocks_;
  std::vector<double> open_;  ///< values after the last block
  double per_unit_ = 1;       ///< of the last block
  std::size_t size_ = 0;
  double front_ = 0, back_ = 0;
};

/// Calls `visit(first, values)` for successive parts of a signal.
template <class Visit>
void for_each_part(Signal const& signal, Visit visit) {
  constexpr std::size_t part = 8192;
  std::vector<double> values;
  for (std::size_t first = 0; first < signal.size(); first += part) {
    values.resize(signal.size() - first < part ? signal.size() - first : part);
    signal.read(first, values);
    visit(first, std::span<double const>(values));
  }
}

}  // namespace axisc::recordings
