#include "axisc/answers/certify/certify_answer.hpp"
#include "axisc/files/image_file.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/command_line.hpp"
#include "cli/output/answer_output.hpp"

namespace axisc::cli::says {

constexpr Sentence option_certified_axis{"only this axis; the exit status is that of all",
                                         "nur diese Achse; der Rückgabewert ist der von allen"};

}  // namespace axisc::cli::says

namespace axisc::cli {

ExitStatus certify(Invocation const& invocation) {
  std::optional<std::string> path;
  CertifyQuestion question;
  auto format = presentation::Format::text;
  CommandLine command_line("certify", invocation.language);
  command_line.argument("IMAGE.axim", path, says::argument_image);
  command_line.value("--axis", "NAME", question.axis, says::option_certified_axis);
  declare_format(command_line, format);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(path.has_value(), "IMAGE.axim");
  question.image = *path;
  auto const file = load_image(*path);
  auto const checked = image::check_bounds(file.bytes.bytes());
  print(certify_answer(question, file, checked), format, invocation, command_line);
  return checked.failures() == 0 ? ExitStatus::success : ExitStatus::findings;
}

}  // namespace axisc::cli
