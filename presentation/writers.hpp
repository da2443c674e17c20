// Writes documents. A format is one source; none knows what the answer is about.
#pragma once

#include "presentation/document.hpp"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace axisc::presentation {

enum class Format : std::uint8_t { text, json, csv, markdown, html };

/// As people name them.
inline std::initializer_list<std::pair<std::string_view, Format>> const formats = {
    {"text", Format::text},
    {"json", Format::json},
    {"csv", Format::csv},
    {"markdown", Format::markdown},
    {"html", Format::html}};

struct WriterOptions {
  Language language = Language::english;
  std::size_t width = 80;  ///< columns of the terminal, for text
  bool color = false;      ///< for text
};

/// The whole output, with a line end. Foreign text cannot break out of its place in any format.
[[nodiscard]] std::string write(Document const& document, Format format, WriterOptions const& options);

[[nodiscard]] std::string write_text(Document const& document, WriterOptions const& options);
/// Numbers read back as the same double.
[[nodiscard]] std::string write_json(Document const& document, WriterOptions const& options);
/// The tables `csv_table` names, one below the other with their sections' identity as first columns and one
/// header; a column that a table lacks is empty there. An identity that a column is called like begins with
/// the key of its array: "axes.name". Empty for a document without such tables.
[[nodiscard]] std::string write_csv(Document const& document, WriterOptions const& options);
[[nodiscard]] std::string write_markdown(Document const& document, WriterOptions const& options);
/// A page of its own.
[[nodiscard]] std::string write_html(Document const& document, WriterOptions const& options);
/// The blocks alone, for a part of another page; headings begin at `level`.
[[nodiscard]] std::string html_of(std::vector<Block> const& blocks, int level, WriterOptions const& options);

}  // namespace axisc::presentation
