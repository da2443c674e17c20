#include "axisc/exporting/temporary_folder.hpp"

#include "axisc/files/output_file.hpp"
#include "system/path.hpp"
#include "system/process.hpp"

#include <system_error>

namespace axisc {

TemporaryFolder::TemporaryFolder() {
  // Where this fails, so does the first file, which says why.
  std::error_code ignored;
  auto const parent = std::filesystem::temp_directory_path(ignored);
  auto const name = "axisc-" + std::to_string(system::process_name().number) + "-";
  int number = 0;
  do {
    path_ = parent / (name + std::to_string(number++));
  } while (!std::filesystem::create_directory(path_, ignored) && !ignored && number < 1000);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::operator/(std::string_view name) const {
  return system::name_of(path_ / system::path_of(std::string(name)));
}

void TemporaryFolder::write(std::string_view name, std::string_view content) const {
  std::error_code ignored;
  std::filesystem::create_directories((path_ / system::path_of(std::string(name))).parent_path(), ignored);
  OutputFile output(*this / name);
  output.write(content);
  output.commit();
}

}  // namespace axisc
