#include "cli/output/picture_output.hpp"

#include "axisc/environment/failure.hpp"
#include "axisc/files/output_file.hpp"
#include "cli/terminal/printed_width.hpp"
#include "presentation/pictures/braille.hpp"
#include "presentation/pictures/page.hpp"
#include "presentation/pictures/svg.hpp"
#include "presentation/text_table.hpp"

#include <algorithm>
#include <vector>

namespace axisc::cli::says {

constexpr Sentence unknown_picture{
    "{file} says no format: name it .svg or .html, or give --format",
    "{file} nennt kein Format: auf .svg oder .html enden lassen oder --format angeben"};
constexpr Sentence table_and_picture{
    "--table prints on standard output, where -o - writes the picture",
    "--table schreibt auf die Standardausgabe, auf die -o - das Bild schreibt"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

constexpr std::size_t widest = 120;

std::string table_text(pictures::Table const& table) {
  std::vector<std::vector<std::string>> rows{table.header};
  rows.insert(rows.end(), table.rows.begin(), table.rows.end());
  return presentation::text_table(rows, 0);
}

}  // namespace

PictureFormat PictureTarget::chosen() const {
  if (format != PictureFormat::by_name) return format;
  if (path == "-" || path->ends_with(".svg")) return PictureFormat::svg;
  return path->ends_with(".html") || path->ends_with(".htm") ? PictureFormat::html : PictureFormat::by_name;
}

void PictureTarget::check() const {
  if (!path) return;
  if (chosen() == PictureFormat::by_name) {
    throw Failure({says::unknown_picture, {{"file", *path}}});
  }
  if (table && path == "-") throw Failure({says::table_and_picture});
}

void write_picture(pictures::Figure const& figure, PictureTarget const& target,
                   Invocation const& invocation) {
  auto& out = invocation.streams.out;
  bool const in_terminal = !target.path && !target.table;
  if (in_terminal) {
    auto const columns = std::min(printed_width(), widest);
    out.write(pictures::braille(figure, columns, invocation.language));
  }
  if (target.table || (in_terminal && figure.shows_table)) out.write(table_text(figure.table));
  if (!target.path) return;
  std::string const text = target.chosen() == PictureFormat::html
                               ? pictures::page(figure, invocation.language)
                               : pictures::svg(figure, invocation.language);
  if (*target.path == "-") {
    out.write(text);
    return;
  }
  OutputFile file(*target.path);
  file.write(text);
  file.commit();
}

}  // namespace axisc::cli
