#include "validator/loading/program_reading.hpp"

#include "diagnostics/writers/writers.hpp"
#include "support/catch.hpp"
#include "support/map_files.hpp"
#include "validator/check.hpp"

#include <map>
#include <string>
#include <string_view>
#include <variant>

namespace program_reading_test {

using namespace axisc;
using namespace axisc::validator;
using namespace axisc::tests;

namespace {

/// A text in pieces of `size` bytes.
class PiecewiseFiles final : public configuration::Files {
 public:
  PiecewiseFiles(std::string text, std::size_t size) : text_(std::move(text)), size_(size) {}
  [[nodiscard]] std::variant<std::string, configuration::FileError> read(
      std::string const& /*path*/) override {
    return configuration::FileError::not_readable;
  }
  [[nodiscard]] std::optional<configuration::FileError> read_pieces(
      std::string const& /*path*/, configuration::PieceReceiver const& receive) override {
    for (std::size_t at = 0; at < text_.size(); at += size_) {
      if (!receive(std::string_view(text_).substr(at, size_))) break;
    }
    return std::nullopt;
  }

 private:
  std::string text_;
  std::size_t size_;
};

/// A program of many gigabytes that nobody could hold: one block, again and again, and a mistake in the
/// middle.
class EndlessFiles final : public configuration::Files {
 public:
  [[nodiscard]] std::variant<std::string, configuration::FileError> read(
      std::string const& /*path*/) override {
    return configuration::FileError::too_large;
  }
  [[nodiscard]] std::optional<configuration::FileError> read_pieces(
      std::string const& /*path*/, configuration::PieceReceiver const& receive) override {
    std::string block;
    while (block.size() < 60000) block += "N10 G01 X1.5 Y-2.25 (#FILTER ON [ORDER=999])\n";
    for (std::size_t i = 0; i < 3000 && receive(block); ++i) {
      if (i == 1500) receive("  #FILTER ON [ORDER=500]\n");
    }
    return std::nullopt;
  }
};

std::string report_of(configuration::Files& files) {
  SourceSet sources;
  CheckOptions options;
  options.cycle_time = design::CycleTime{1'000'000};
  CheckResult const result = check(files, "part.nc", options, sources);
  std::string text =
      result.unreadable ? "unreadable " + std::to_string(static_cast<int>(*result.unreadable)) : "";
  for (Finding const& finding : result.findings) text += write_text(finding, sources, {});
  return text;
}

}  // namespace

TEST_CASE("a program reads the same in pieces of any size") {
  std::string const part =
      "%MAIN\r\nN1 G01 X1\r\n#FILTER ON [ORDER=500]\r\n  #FILTER \\\r\n (gap)\r\n ON [SHARE=101] (\xFC)\r\n"
      "(axisc: allow AX5002)\r\n#FILTER ON [ORDER=999]\r\nM30";
  for (std::string_view const mark : {"", "\xEF\xBB\xBF"}) {
    std::string const text = std::string(mark) + part;
    MapFiles whole({{"part.nc", text}});
    std::string const expected = report_of(whole);
    CHECK(expected.find("part.nc:3:19") != std::string::npos);
    CHECK(expected.find("part.nc:6:12") != std::string::npos);
    CHECK(expected.find("999") == std::string::npos);
    for (std::size_t const size : {1U, 2U, 7U, 64U}) {
      PiecewiseFiles files(text, size);
      CHECK(report_of(files) == expected);
    }
  }
}

TEST_CASE("a program that is no text is refused in pieces too") {
  for (std::string const& text :
       {std::string("AXIM\0\0", 6), std::string("\xFF\xFE%\0M\0", 6), std::string(9000, '\1'),
        std::string((1U << 20U) + 1, 'X') + "\nM30\n", "M30\n" + std::string((1U << 20U) + 1, 'X')}) {
    MapFiles whole({{"part.nc", text}});
    std::string const expected = report_of(whole);
    CHECK(expected.starts_with("unreadable"));
    PiecewiseFiles files(text, 1000);
    CHECK(report_of(files) == expected);
  }
}

TEST_CASE("of a long program only the lines with commands are kept") {
  EndlessFiles files;
  auto const read = read_program(files, "part.nc");
  auto const& program = std::get<ReadProgram>(read);
  CHECK(program.mark.bytes > 180'000'000);
  CHECK(program.text.bytes() == "  #FILTER ON [ORDER=500]\n");
  REQUIRE(program.tree.commands.size() == 1);
  CHECK(program.text.position(2).line == program.tree.commands[0].line);
  CHECK(program.tree.commands[0].line > 2'000'000);
}

TEST_CASE("a program that changes between check and image is no source") {
  using Contents = std::map<std::string, std::string>;
  MapFiles before(Contents{{"part.nc", "#FILTER ON [ORDER=20]\nM30\n"}});
  auto const read = read_program(before, "part.nc");
  ContentMark const mark = std::get<ReadProgram>(read).mark;
  std::string bytes;
  auto const keep = [&](std::string_view piece) {
    bytes += piece;
    return true;
  };
  read_program_again(before, "part.nc", mark, keep);
  CHECK(bytes == "#FILTER ON [ORDER=20]\nM30\n");
  MapFiles after(Contents{{"part.nc", "#FILTER ON [ORDER=21]\nM30\n"}});
  CHECK_THROWS_AS(read_program_again(after, "part.nc", mark, keep), configuration::SourceChanged);
  MapFiles gone(Contents{});
  CHECK_THROWS_AS(read_program_again(gone, "part.nc", mark, keep), configuration::SourceChanged);
}

TEST_CASE("an excerpt shows the lines that it holds and is not edited") {
  SourceText const text(
      "p", Excerpt{.bytes = "\xC3\xBC X\nlast\n", .numbers = {7, 12}, .encoding = Encoding::utf8});
  CHECK(text.position(3) == Position{.line = 7, .column = 3});
  CHECK(text.position(5) == Position{.line = 12, .column = 1});
  CHECK(text.slice(text.line_span(12)) == "last");
  CHECK(text.line_span(8).empty());
  CHECK(text.is_excerpt());
  SourceText const nothing("p", Excerpt{});
  CHECK(nothing.position(0) == Position{.line = 1, .column = 1});
}

}  // namespace program_reading_test
