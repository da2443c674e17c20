// The layout of help texts: as wide as the terminal, at most 100 columns.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace axisc::cli {

/// Width of the terminal that standard output is, 100 elsewhere and on wider ones.
[[nodiscard]] std::size_t help_width();

/// Two columns: a name and its meaning, broken between words.
[[nodiscard]] std::string help_row(std::string_view name, std::string_view meaning, std::size_t width);

/// Paragraphs, broken between words. Lines with an indentation, which are examples, stay as they are if they
/// fit; otherwise what follows their widest gap moves to a line of its own.
[[nodiscard]] std::string help_paragraphs(std::string_view text, std::size_t width);

}  // namespace axisc::cli
