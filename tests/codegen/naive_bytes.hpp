// Bytes of the naive image: little-endian numbers at given offsets, texts and self-tests that are stored
// once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace axisc::test {

using NaiveBytes = std::vector<std::byte>;

/// 100 digits.
using Wide =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

inline void put(NaiveBytes& bytes, std::size_t offset, std::uint64_t value, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i)
    bytes.at(offset + i) = static_cast<std::byte>(value >> (8 * i) & 0xFF);
}
inline void put16(NaiveBytes& bytes, std::size_t offset, std::uint64_t value) {
  put(bytes, offset, value, 2);
}
inline void put32(NaiveBytes& bytes, std::size_t offset, std::uint64_t value) {
  put(bytes, offset, value, 4);
}
inline void put64(NaiveBytes& bytes, std::size_t offset, std::uint64_t value) {
  put(bytes, offset, value, 8);
}
inline void put_double(NaiveBytes& bytes, std::size_t offset, double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  put64(bytes, offset, bits);
}
inline void put_text(NaiveBytes& bytes, std::size_t offset, std::string const& text) {
  for (std::size_t i = 0; i < text.size(); ++i) bytes.at(offset + i) = static_cast<std::byte>(text[i]);
}

struct NaiveSample {
  double input, output;
  bool operator==(NaiveSample const& other) const { return input == other.input && output == other.output; }
};

/// The compiler's input: a step, an alternating ramp, rest, a step to 1.
inline std::vector<double> naive_test_input(std::size_t delay_cycles) {
  std::vector<double> input(8, 1.0 / 64);
  for (int i = 1; i <= 16; ++i) input.push_back((i % 2 != 0 ? -i : i) / 1024.0);
  input.insert(input.end(), 7 + delay_cycles, 0.0);
  input.push_back(1);
  return input;
}

/// What several sections point into.
struct NaiveStores {
  NaiveBytes names, samples;
  std::vector<std::pair<std::string, std::size_t>> texts;
  std::vector<std::pair<std::vector<NaiveSample>, std::uint32_t>> runs;

  /// Offset and size to `at`.
  void write_text_range(NaiveBytes& bytes, std::size_t at, std::string const& text) {
    std::size_t offset = 0;
    if (!text.empty()) {
      std::size_t known = 0;
      while (known < texts.size() && texts[known].first != text) ++known;
      if (known == texts.size()) {
        texts.emplace_back(text, names.size());
        names.resize(names.size() + text.size());
        put_text(names, texts[known].second, text);
      }
      offset = texts[known].second;
    }
    put32(bytes, at, offset);
    put32(bytes, at + 4, text.size());
  }

  std::uint32_t place_samples(std::vector<NaiveSample> const& run) {
    if (run.empty()) return 0;
    for (auto const& [stored, first] : runs) {
      if (stored == run) return first;
    }
    auto const first = static_cast<std::uint32_t>(samples.size() / 16);
    for (auto const& sample : run) {
      std::size_t const at = samples.size();
      samples.resize(at + 16);
      put_double(samples, at, sample.input);
      put_double(samples, at + 8, sample.output);
    }
    runs.emplace_back(run, first);
    return first;
  }
};

}  // namespace axisc::test
