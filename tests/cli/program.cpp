#include "cli/program.hpp"

#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/sarif_schema.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace axisc::test {

namespace {

void replace(int descriptor, std::string const& path, int flags) {
  int const file = ::open(path.c_str(), flags, 0600);
  if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(126);
}

[[noreturn]] void become(std::vector<std::string> arguments, std::vector<std::string> variables) {
  std::vector<char*> argument_pointers;
  for (auto& argument : arguments) argument_pointers.push_back(argument.data());
  argument_pointers.push_back(nullptr);
  std::vector<char*> variable_pointers;
  for (auto& variable : variables) variable_pointers.push_back(variable.data());
  variable_pointers.push_back(nullptr);
  ::execve(argument_pointers[0], argument_pointers.data(), variable_pointers.data());
  ::_exit(127);
}

/// An answer in JSON is as its schema says, whatever is tested.
void check_answer(std::vector<std::string> const& arguments, std::string const& out) {
  constexpr std::array<std::string_view, 13> answering = {
      "certify",  "circle",  "compare", "contour",  "diff",     "explain", "get",
      "identify", "inspect", "replay",  "response", "simulate", "suggest"};
  auto const format = std::find(arguments.begin(), arguments.end(), "--format");
  bool const is_json = format != arguments.end() && format + 1 != arguments.end() && format[1] == "json";
  constexpr std::size_t longest = 300'000;  // all parameters at once would take seconds
  if (!is_json || out.empty() || out.size() > longest) return;
  if (std::find(answering.begin(), answering.end(), arguments.front()) == answering.end()) return;
  auto const schema = read_source_file("docs/schemas/" + arguments.front() + ".schema.json");
  CHECK(schema_complaints(out, schema) == std::vector<std::string>());
}

}  // namespace

Surroundings in_folder(std::string path) {
  Surroundings surroundings;
  surroundings.folder = std::move(path);
  return surroundings;
}

Outcome run_axisc(std::vector<std::string> const& arguments, Surroundings const& surroundings) {
  TemporaryFolder const folder;
  folder.write("in", surroundings.input);
  // The same program for another system, by way of what runs it here.
  char const* const other = std::getenv("AXISC_TEST_PROGRAM");
  std::vector<std::string> words{other != nullptr ? other : AXISC_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  auto variables = surroundings.variables;
  variables.emplace_back("PATH=/usr/bin:/bin");
  auto const child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    replace(0, folder / "in", O_RDONLY);
    replace(1, surroundings.out.empty() ? folder / "out" : surroundings.out, O_WRONLY | O_CREAT);
    replace(2, folder / "err", O_WRONLY | O_CREAT);
    if (surroundings.closed_pipe) {
      int ends[2] = {-1, -1};
      if (::pipe(ends) != 0 || ::dup2(ends[1], 1) < 0) ::_exit(126);
      ::close(ends[0]);
      ::close(ends[1]);
    }
    if (::chdir(surroundings.folder.c_str()) != 0) ::_exit(126);
    become(std::move(words), std::move(variables));
  }
  int status = 0;
  struct rusage usage {};
  REQUIRE(::wait4(child, &status, 0, &usage) == child);
  // What went elsewhere is not read.
  auto out = surroundings.out.empty() ? folder.read("out") : std::string();
  check_answer(arguments, out);
  return {.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          .out = std::move(out),
          .err = folder.read("err"),
          .peak_memory = static_cast<std::size_t>(usage.ru_maxrss) * 1024};
}

std::size_t lines_of(std::string_view text) {
  auto const ends = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  return ends + (text.empty() || text.back() == '\n' ? 0 : 1);
}

}  // namespace axisc::test
