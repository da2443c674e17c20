#include "presentation/writers.hpp"

namespace axisc::presentation {

std::string write(Document const& document, Format format, WriterOptions const& options) {
  switch (format) {
    case Format::text: return write_text(document, options);
    case Format::json: return write_json(document, options);
    case Format::csv: return write_csv(document, options);
    case Format::markdown: return write_markdown(document, options);
    case Format::html: return write_html(document, options);
  }
  return {};
}

}  // namespace axisc::presentation
