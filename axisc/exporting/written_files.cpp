#include "axisc/exporting/written_files.hpp"

#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "system/file.hpp"
#include "system/path.hpp"

namespace axisc {

namespace {

void write_if_different(std::string const& path, std::string const& content) {
  if (is_content_of(path, content)) return;
  OutputFile output(path);
  output.write(content);
  output.commit();
}

}  // namespace

void write_files(std::string const& folder, std::vector<image::ExportedFile> const& files,
                 std::vector<std::string> const& sources) {
  std::vector<std::string> paths;
  paths.reserve(files.size());
  for (auto const& file : files) paths.push_back(system::name_of(system::path_of(folder) / file.name));
  refuse_overwriting(paths, sources);
  make_folder(system::path_of(folder));
  for (std::size_t i = 0; i < files.size(); ++i) write_if_different(paths[i], files[i].content);
}

void write_file(std::string const& path, std::string const& content,
                std::vector<std::string> const& sources) {
  refuse_overwriting({path}, sources);
  write_if_different(path, content);
}

}  // namespace axisc
