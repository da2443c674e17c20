#include "analysis/recordings/text_encoding.hpp"

#include "diagnostics/utf8.hpp"
#include "diagnostics/windows_1252.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace axisc::recordings {

namespace {

constexpr char32_t first_high = 0xD800;
constexpr char32_t first_low = 0xDC00;
constexpr char32_t after_low = 0xE000;

/// Hands out what an inner source has, decoded, in pieces of any size.
class Utf16Source {
 public:
  Utf16Source(ByteSource source, std::string bytes, bool is_big_endian)
      : source_(std::move(source)), bytes_(std::move(bytes)), is_big_endian_(is_big_endian) {}

  std::size_t operator()(std::span<char> buffer) {
    while (text_.size() == used_ && !ended_) refill();
    auto const size = std::min(buffer.size(), text_.size() - used_);
    std::copy_n(text_.data() + used_, size, buffer.data());
    used_ += size;
    return size;
  }

 private:
  void refill() {
    text_.clear();
    used_ = 0;
    std::array<char, 1U << 14U> piece{};
    auto const got = source_(piece);
    bytes_.append(piece.data(), got);
    ended_ = got == 0;
    std::size_t at = 0;
    for (; at + 2 <= bytes_.size(); at += 2) decode(unit(at));
    bytes_.erase(0, at);
    if (ended_ && (high_ != 0 || !bytes_.empty())) append_utf8(text_, replacement_character);
  }

  [[nodiscard]] char32_t unit(std::size_t at) const {
    auto const first = static_cast<unsigned char>(bytes_[at]);
    auto const second = static_cast<unsigned char>(bytes_[at + 1]);
    return is_big_endian_ ? first * 256U + second : second * 256U + first;
  }

  void decode(char32_t unit) {
    bool const is_low = unit >= first_low && unit < after_low;
    if (high_ != 0 && is_low) {
      constexpr char32_t beyond = 0x10000;
      append_utf8(text_, beyond + (high_ - first_high) * 0x400 + (unit - first_low));
      high_ = 0;
      return;
    }
    if (high_ != 0) append_utf8(text_, replacement_character);
    high_ = unit >= first_high && unit < first_low ? unit : 0;
    if (high_ == 0) append_utf8(text_, unit);
  }

  ByteSource source_;
  std::string bytes_;  ///< not decoded yet
  bool is_big_endian_;
  std::string text_;
  std::size_t used_ = 0;
  char32_t high_ = 0;  ///< half of a character
  bool ended_ = false;
};

/// First what was read already, then the rest.
ByteSource preceded_by(std::string bytes, ByteSource rest) {
  return [bytes = std::move(bytes), used = std::size_t{0},
          rest = std::move(rest)](std::span<char> buffer) mutable -> std::size_t {
    if (used == bytes.size()) return rest(buffer);
    auto const size = std::min(buffer.size(), bytes.size() - used);
    std::copy_n(bytes.data() + used, size, buffer.data());
    used += size;
    return size;
  };
}

}  // namespace

std::string first_bytes(ByteSource& source, std::size_t count) {
  std::string bytes(count, '\0');
  std::size_t filled = 0;
  while (filled < count) {
    auto const got = source(std::span(bytes).subspan(filled));
    if (got == 0) break;
    filled += got;
  }
  bytes.resize(filled);
  std::string peeked = bytes;
  source = preceded_by(std::move(bytes), std::move(source));
  return peeked;
}

ByteSource as_utf8(ByteSource source) {
  auto const mark = first_bytes(source, 2);
  bool const is_big_endian = mark == "\xFE\xFF";
  if (!is_big_endian && mark != "\xFF\xFE") return source;
  std::array<char, 2> left_out{};
  for (std::size_t got = 0; got < left_out.size();) got += source(std::span(left_out).subspan(got));
  return Utf16Source(std::move(source), {}, is_big_endian);
}

std::string utf8_text(std::string_view bytes) {
  if (valid_utf8_prefix(bytes) == bytes.size()) return std::string(bytes);
  std::string text;
  for (char const byte : bytes) append_utf8(text, decode_windows_1252(byte));
  return text;
}

std::string shown_text(std::string_view field) {
  constexpr std::size_t longest = 40;
  return utf8_text(field.substr(0, longest));
}

}  // namespace axisc::recordings
