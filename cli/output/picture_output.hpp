// Where a picture goes, and in which form.
#pragma once

#include "cli/options/invocation.hpp"
#include "presentation/pictures/figure.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace axisc::cli {

enum class PictureFormat : std::uint8_t { by_name, svg, html };

struct PictureTarget {
  std::optional<std::string> path;  ///< none: the terminal; "-": standard output
  PictureFormat format = PictureFormat::by_name;
  bool table = false;

  /// SVG on standard output; else as the name ends.
  [[nodiscard]] PictureFormat chosen() const;
  /// Failure for a name that says no format, and for a picture and a table on one standard output.
  void check() const;
};

/// Writes the picture, and its table where it is wanted.
void write_picture(pictures::Figure const& figure, PictureTarget const& target, Invocation const& invocation);

}  // namespace axisc::cli
