#include "axisc/workspace/image_names.hpp"

#include "axisc/environment/failure.hpp"
#include "system/path.hpp"

#include <filesystem>
#include <unordered_map>

namespace axisc::says {

constexpr Sentence output_collision{
    "{first} and {second} would both be written to {file}; rename one, or compile them into different "
    "folders",
    "{first} und {second} würden beide nach {file} geschrieben; eine umbenennen oder in verschiedene Ordner "
    "kompilieren"};
constexpr Sentence outside_input_folder{
    "{file} is not below {folder}, to which image names are relative; give another folder with "
    "--input-folder",
    "{file} liegt nicht unter {folder}, wozu die Namen der Abbilder relativ sind; mit --input-folder einen "
    "anderen Ordner angeben"};
constexpr Sentence no_image_name{"an image from standard input has no name; write it with -o",
                                 "ein Abbild aus der Standardeingabe hat keinen Namen; es mit -o schreiben"};

}  // namespace axisc::says

namespace axisc {

namespace {

namespace fs = std::filesystem;

fs::path absolute(std::string const& name) {
  std::error_code error;
  auto const whole = fs::absolute(system::path_of(name), error).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

}  // namespace

std::vector<std::string> image_names(std::vector<std::string> const& inputs, std::string const& input_folder,
                                     std::string const& output_folder) {
  auto const folder = absolute(input_folder.empty() ? "." : input_folder);
  std::vector<std::string> names;
  std::unordered_map<std::string, std::string> taken;
  for (auto const& input : inputs) {
    if (input == "-") throw Failure({says::no_image_name});
    auto below = absolute(input).lexically_relative(folder);
    if (below.empty() || *below.begin() == "..") {
      throw Failure({says::outside_input_folder, {{"file", input}, {"folder", system::name_of(folder)}}});
    }
    names.push_back(system::name_of(system::path_of(output_folder) / below.replace_extension(".axim")));
    auto const [first, is_new] = taken.emplace(names.back(), input);
    if (is_new) continue;
    throw Failure(
        {says::output_collision, {{"first", first->second}, {"second", input}, {"file", names.back()}}});
  }
  return names;
}

}  // namespace axisc
