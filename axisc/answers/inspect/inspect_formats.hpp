// Output formats of `axisc inspect`.
#pragma once

#include "diagnostics/message.hpp"
#include "image/chain_figures.hpp"
#include "image/image_contents.hpp"
#include "image/signature.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct Shown {
  std::string const& file;
  image::ImageContents const& image;
  std::vector<std::size_t> axes;                      ///< which of them
  std::optional<image::KeyId> signer = std::nullopt;  ///< the key that the image was signed with
  bool signature_checked = false;                     ///< and the signature was found right
  std::vector<image::ChainFigures> figures = {};      ///< of `axes`
  std::optional<std::size_t> memory;  ///< bytes that the runtime needs on a target, where asked for
};

[[nodiscard]] std::string inspect_text(Shown const& shown, Language language);
[[nodiscard]] std::string inspect_json(Shown const& shown);
/// The axes' lists, one after the other; a comment after each value names its origin.
[[nodiscard]] std::string inspect_as_list(Shown const& shown, Language language);

}  // namespace axisc
