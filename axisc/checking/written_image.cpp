#include "axisc/checking/written_image.hpp"

#include "axisc/checking/depfile.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "system/path.hpp"

#include <utility>

namespace axisc {

namespace {

void write_depfile(ImageTarget const& target, std::vector<std::string> const& sources) {
  if (!target.depfile) return;
  OutputFile file(*target.depfile);
  file.write(dependency_rule(target.path, sources));
  file.commit();
}

ImageFate put(std::string const& bytes, ImageTarget const& target, std::vector<std::string> const& sources) {
  std::vector<std::string> outputs{target.path};
  if (target.depfile) outputs.push_back(*target.depfile);
  refuse_overwriting(outputs, sources);
  if (is_content_of(target.path, bytes)) {
    write_depfile(target, sources);
    return ImageFate::unchanged;
  }
  if (target.makes_folder) make_folder(system::path_of(target.path).parent_path());
  OutputFile output(target.path);
  output.write(bytes);
  // The rule is written first: an image without it would never be rebuilt.
  write_depfile(target, sources);
  output.commit();
  return ImageFate::written;
}

}  // namespace

WrittenImage write_image(CompiledInput compiled, ImageTarget const& target,
                         std::vector<std::string> const& more_sources) {
  WrittenImage written{.checked = std::move(compiled.checked), .sources = {}};
  written.sources = written.checked.files;
  written.sources.insert(written.sources.end(), more_sources.begin(), more_sources.end());
  if (compiled.skipped) written.fate = ImageFate::skipped;
  if (!compiled.image) return written;
  written.bytes = compiled.image->bytes.size();
  written.axes = compiled.image->axes;
  written.filters = compiled.image->filters;
  try {
    written.fate = put(compiled.image->bytes, target, written.sources);
  } catch (Failure const& failure) {
    written.checked.failure = failure;
  }
  return written;
}

}  // namespace axisc
