#include "diagnostics/location.hpp"
#include "diagnostics/markup.hpp"
#include "diagnostics/terminal.hpp"
#include "diagnostics/writers/report_writer.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace axisc {
namespace {

class JunitReport final : public ReportWriter {
 public:
  JunitReport(Language language, ReportContext context) : language_(language), context_(std::move(context)) {}

  void add(std::string& /*out*/, Finding const& finding, SourceSet const& sources,
           std::string_view /*fingerprint*/) override {
    auto const file = shown_path(context_.paths, file_of(finding, sources));
    std::string name = code_text(finding.code) + ' ' + std::string(finding.name);
    std::string place;
    if (finding.place) {
      auto const location = locate(*finding.place, sources);
      auto const line = std::to_string(location.begin.line);
      name += ' ' + line + ':' + std::to_string(location.begin.column);
      place = R"(" line=")" + line;
    }
    auto const shown = escaped(printable(file));
    auto const whole = escaped(whole_message(finding, language_, Values::printable));
    cases_ += R"(<testcase classname=")" + shown + R"(" name=")" + escaped(name) + R"(" file=")" + shown +
              place + R"("><failure type=")" + std::string(severity_name(finding.severity)) +
              R"(" message=")" + whole.substr(0, whole.find('\n')) + "\">" + whole +
              "</failure></testcase>\n";
    ++failures_;
  }

  void add_failure(std::string const& sentence) override {
    auto const text = escaped(printable(sentence));
    cases_ +=
        R"(<testcase classname="axisc" name=")" + text + R"("><error message=")" + text + "\"/></testcase>\n";
    ++errors_;
  }

  void end(Print const& print, RunFacts const& run) override {
    // Without any test, readers take the report for one of nothing.
    if (cases_.empty()) {
      cases_ =
          R"(<testcase classname="axisc" name="lint" assertions=")" + std::to_string(run.files) + "\"/>\n";
      ++passed_;
    }
    auto const counts = R"( tests=")" + std::to_string(failures_ + errors_ + passed_) + R"(" failures=")" +
                        std::to_string(failures_) + R"(" errors=")" + std::to_string(errors_) + "\">\n";
    print("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts + "<testsuite name=\"axisc\"" +
          counts);
    print(cases_);
    print("</testsuite>\n</testsuites>\n");
  }

 private:
  Language language_;
  ReportContext context_;
  std::string cases_;  ///< the head counts them
  std::size_t failures_ = 0, errors_ = 0, passed_ = 0;
};

}  // namespace

std::unique_ptr<ReportWriter> junit_report(WriteOptions const& options, ReportContext context) {
  return std::make_unique<JunitReport>(options.language, std::move(context));
}

}  // namespace axisc
