#include "axisc/exporting/temporary_folder.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/output_file.hpp"
#include "system/path.hpp"
#include "system/process.hpp"

#include <system_error>

namespace axisc::says {

constexpr Sentence no_temporary_folder{
    "no folder for temporary files can be made: {reason}; name another one with TMPDIR (Windows: TMP)",
    "ein Ordner für temporäre Dateien lässt sich nicht anlegen: {reason}; mit TMPDIR (Windows: TMP) einen "
    "anderen nennen"};

}  // namespace axisc::says

namespace axisc {

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  auto const parent = std::filesystem::temp_directory_path(error);
  auto const name = "axisc-" + std::to_string(system::process_name().number) + "-";
  bool is_made = false;
  for (int number = 0; !is_made && !error; ++number) {
    path_ = parent / (name + std::to_string(number));
    is_made = std::filesystem::create_directory(path_, error);
  }
  if (is_made) return;
  throw Failure({says::no_temporary_folder, {{"reason", error.message()}}}, cannot_write);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::operator/(std::string_view name) const {
  return system::name_of(path_ / system::path_of(std::string(name)));
}

void TemporaryFolder::write(std::string_view name, std::string_view content) const {
  make_folder((path_ / system::path_of(std::string(name))).parent_path());
  OutputFile output(*this / name);
  output.write(content);
  output.commit();
}

}  // namespace axisc
