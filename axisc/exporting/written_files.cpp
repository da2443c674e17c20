#include "axisc/exporting/written_files.hpp"

#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "system/file.hpp"
#include "system/path.hpp"

#include <filesystem>
#include <system_error>

namespace axisc {

void write_files(std::string const& folder, std::vector<image::ExportedFile> const& files,
                 std::vector<std::string> const& sources) {
  std::vector<std::string> paths;
  paths.reserve(files.size());
  for (auto const& file : files) paths.push_back(system::name_of(system::path_of(folder) / file.name));
  refuse_overwriting(paths, sources);
  // Where this fails, so does the first file, which says why.
  std::error_code ignored;
  std::filesystem::create_directories(system::path_of(folder), ignored);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (is_content_of(paths[i], files[i].content)) continue;
    OutputFile output(paths[i]);
    output.write(files[i].content);
    output.commit();
  }
}

}  // namespace axisc
