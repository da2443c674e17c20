#include "presentation/pictures/svg.hpp"

#include "presentation/pictures/svg_text.hpp"
#include "presentation/pictures/text_width.hpp"
#include "support/catch.hpp"

#include <limits>

namespace svg_test {

using namespace axisc;
using namespace axisc::pictures;
using Catch::Matchers::Contains;

namespace {

Figure small_figure() {
  Figure figure;
  figure.title = "A <title> & more";
  figure.description = "in words";
  figure.x = {.quantity = "time", .unit = "ms", .low = 0, .high = 10};
  Panel panel;
  panel.y = {.quantity = "position", .unit = "", .low = 0, .high = 1};
  panel.curves.push_back({.name = "X", .points = {{.x = 0, .y = 0}, {.x = 5, .y = 2}, {.x = 10, .y = 1}}});
  figure.panels.push_back(panel);
  return figure;
}

}  // namespace

TEST_CASE("pixels have at most two decimals") {
  CHECK(pixels(0) == "0");
  CHECK(pixels(-0.001) == "0");
  CHECK(pixels(1.5) == "1.5");
  CHECK(pixels(-1.25) == "-1.25");
  CHECK(pixels(2.04) == "2.04");
  CHECK(pixels(99.999) == "100");
}

TEST_CASE("an SVG says in words what it shows, and escapes what it is given") {
  std::string const text = svg(small_figure(), Language::english);
  CHECK_THAT(text, Contains("<title>A &lt;title&gt; &amp; more</title>"));
  CHECK_THAT(text, Contains("<desc>in words</desc>"));
  CHECK_THAT(text, Contains("viewBox=\"0 0 800 "));
  CHECK_THAT(text, Contains("prefers-color-scheme: dark"));
  CHECK_THAT(text, !Contains("<script"));
}

TEST_CASE("values outside a panel are drawn at its edge, and no number is not drawn") {
  Figure figure = small_figure();
  double const none = std::numeric_limits<double>::quiet_NaN();
  double const infinite = std::numeric_limits<double>::infinity();
  figure.panels.front().curves.push_back(
      {.name = "Y", .points = {{.x = 0, .y = none}, {.x = 1, .y = -infinite}, {.x = 2, .y = infinite}}});
  std::string const text = svg(figure, Language::german);
  CHECK_THAT(text, !Contains("nan") && !Contains("inf"));
  figure.panels.clear();
  figure.nothing = "Nichts zu zeichnen.";
  CHECK_THAT(svg(figure, Language::german), Contains("Nichts zu zeichnen."));
}

TEST_CASE("a title that is too long ends in an ellipsis, between letters") {
  std::string const title = "Größe: " + std::string(300, 'x');
  auto const shown = fitted(title, 12, 700);
  CHECK(shown.ends_with("…"));
  CHECK(text_width(shown, 12) <= 700);
  CHECK(text_width(shown, 12) > 680);
  CHECK(fitted("kurz", 12, 700) == "kurz");
  for (double width = 10; width < 60; width += 0.5) {
    auto const cut = fitted("öäüöäüöäü", 12, width);
    CHECK(cut.size() % 2 == 1);  // whole letters of two bytes, and the ellipsis of three
  }
}

}  // namespace svg_test
