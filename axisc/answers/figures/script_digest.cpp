#include "axisc/answers/figures/script_digest.hpp"

#include "codegen/source_digest.hpp"

#include <cstdint>

namespace axisc {

std::string script_digest(std::string_view script) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  codegen::Sha256 const digest = codegen::sha256(script);
  auto const byte = [&digest](std::size_t i) { return i < digest.size() ? std::uint32_t{digest[i]} : 0U; };
  std::string text = "sha256-";
  for (std::size_t i = 0; i < digest.size(); i += 3) {
    std::uint32_t const bits = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    for (unsigned const shift : {18U, 12U, 6U, 0U}) text += letters[(bits >> shift) & 0x3FU];
  }
  static_assert(std::tuple_size_v<codegen::Sha256> % 3 == 2);
  text.back() = '=';  // the last of four letters stands for a byte that is not there
  return text;
}

}  // namespace axisc
