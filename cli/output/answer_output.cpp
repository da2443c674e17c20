#include "cli/output/answer_output.hpp"

#include "cli/terminal/printed_width.hpp"

namespace axisc::cli::says {

constexpr Sentence format_of_text{"output format (default: text)", "Ausgabeformat (Standardwert: text)"};
constexpr Sentence format_of_csv{"output format (default: csv)", "Ausgabeformat (Standardwert: csv)"};
constexpr Sentence format_of_markdown{"output format (default: markdown)",
                                      "Ausgabeformat (Standardwert: markdown)"};

}  // namespace axisc::cli::says

namespace axisc::cli {

void declare_format(CommandLine& command_line, presentation::Format& format) {
  using presentation::Format;
  SentenceRef const meaning = format == Format::csv        ? says::format_of_csv
                              : format == Format::markdown ? says::format_of_markdown
                                                           : says::format_of_text;
  command_line.choice("--format", presentation::formats, format, meaning);
}

void print(presentation::Document const& answer, presentation::Format format, Invocation const& invocation,
           CommandLine const& command_line) {
  presentation::WriterOptions const options{.language = invocation.language,
                                            .width = printed_width(),
                                            .color = use_color(command_line.color(), system::Stream::output)};
  invocation.streams.out.write(presentation::write(answer, format, options));
}

}  // namespace axisc::cli
