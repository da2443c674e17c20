// What is in a coefficient image, as an answer.
#pragma once

#include "axisc/files/image_file.hpp"
#include "image/chain_figures.hpp"
#include "presentation/document.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace axisc {

struct InspectQuestion {
  std::string image;                        ///< its path, for readers
  std::optional<std::string> axis;          ///< none: all
  bool is_checked = false;                  ///< the signature was found right
  std::optional<std::uint32_t> level = {};  ///< what memory the runtime needs at this axisrt_level
};

/// Failure for an unknown axis.
[[nodiscard]] presentation::Document inspect_answer(InspectQuestion const& question, ImageFile const& file);

/// The parts about some axes, without the head of the image: chains, coefficients, kernels and channels.
/// `figures` are those of the axes. For Audience::people kernels that only programs read are left out.
[[nodiscard]] std::vector<presentation::Block> inspect_axes(image::ImageContents const& image,
                                                            std::span<std::size_t const> axes,
                                                            std::span<image::ChainFigures const> figures,
                                                            presentation::Audience audience);

/// The axes' lists, one after the other; a comment after each value names its origin. Failure for an image
/// without lists.
[[nodiscard]] std::string inspect_as_list(InspectQuestion const& question, image::ImageContents const& image,
                                          Language language);

}  // namespace axisc
