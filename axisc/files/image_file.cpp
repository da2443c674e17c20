#include "axisc/files/image_file.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/sentences.hpp"
#include "axisc/files/disk_files.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/joined.hpp"
#include "image/machine_sources.hpp"
#include "schema/closest_word.hpp"

#include <array>
#include <span>
#include <variant>

namespace axisc::says {

constexpr Sentence headline{
    "{file} is damaged or was not written by axisc ({status}); compile the lists again",
    "{file} ist beschädigt oder nicht von axisc geschrieben ({status}); die Listen neu kompilieren"};
constexpr Sentence magic{
    "{file} is not a coefficient image ({status}); `axisc compile` makes one from a list or a machine file",
    "{file} ist kein Koeffizientenabbild ({status}); `axisc compile` erzeugt eines aus Liste oder "
    "Maschinendatei"};
constexpr Sentence not_an_image_short{
    "{file} is cut off or not a coefficient image ({status}); compile the lists again",
    "{file} ist abgeschnitten oder kein Koeffizientenabbild ({status}); die Listen neu kompilieren"};
constexpr Sentence size{
    "{file} is cut off or has bytes after its end ({status}); copy it again or compile the lists again",
    "{file} ist abgeschnitten oder zu lang ({status}); neu kopieren oder die Listen neu kompilieren"};
constexpr Sentence version{
    "{file} has another format version ({status}); compile the lists with this axisc",
    "{file} hat eine andere Formatversion ({status}); die Listen mit diesem axisc kompilieren"};
constexpr Sentence newer{
    "{file} has content that this axisc does not know ({status}); run the newer one that wrote it, or "
    "compile "
    "the lists with this one",
    "{file} hat Inhalt, den dieses axisc nicht kennt ({status}); das neuere verwenden, das die Datei "
    "geschrieben "
    "hat, oder die Listen mit diesem kompilieren"};
constexpr Sentence checksum{
    "{file} was changed after it was written ({status}); copy it again or compile the lists again",
    "{file} wurde nach dem Schreiben verändert ({status}); neu kopieren oder die Listen neu kompilieren"};

constexpr Sentence unknown_axis{"there is no axis \"{axis}\"; the axes are {axes}",
                                "es gibt keine Achse \"{axis}\"; die Achsen sind {axes}"};
constexpr Sentence unknown_axis_meant{
    "there is no axis \"{axis}\"; did you mean {meant}? The axes are {axes}",
    "es gibt keine Achse \"{axis}\"; war {meant} gemeint? Die Achsen sind {axes}"};

constexpr Sentence no_level{
    "this processor does not have the instruction set that --level asks for; use --level auto",
    "dieser Prozessor hat den mit --level verlangten Befehlssatz nicht; --level auto verwenden"};

}  // namespace axisc::says

namespace axisc {

namespace {

SentenceRef sentence(axisrt_status status) {
  switch (status) {
    case AXISRT_WRONG_MAGIC: return says::magic;
    case AXISRT_TOO_SHORT: return says::not_an_image_short;
    case AXISRT_WRONG_VERSION: return says::version;
    case AXISRT_WRONG_SIZE: return says::size;
    case AXISRT_WRONG_CHECKSUM: return says::checksum;
    case AXISRT_UNKNOWN_KIND: return says::newer;
    default: return says::headline;
  }
}

}  // namespace

Failure unusable_image(std::string const& path, axisrt_status status) {
  return Failure(
      {sentence(status),
       {{"file", path}, {"status", axisrt_status_name(status)}, {"reason", axisrt_status_text(status)}}},
      not_an_image);
}

ImageFile load_image(std::string const& path) {
  return image_of_bytes(path, read_whole(path));
}

ImageFile image_of_bytes(std::string const& path, std::string_view image) {
  codegen::AlignedBytes bytes(std::as_bytes(std::span(image.data(), image.size())));
  auto contents = image::read_image(bytes.bytes());
  if (auto const* const status = std::get_if<axisrt_status>(&contents)) throw unusable_image(path, *status);
  return {.bytes = std::move(bytes), .contents = std::get<image::ImageContents>(std::move(contents))};
}

std::string axis_label(image::ImageContents const& image, std::size_t axis) {
  return image::axis_text(image, axis);
}

Failure unknown_axis(std::string const& name, std::vector<std::string> const& labels) {
  std::string meant;
  for (auto const& label : labels) {
    if (ascii::lower_case(label) == ascii::lower_case(name)) meant = label;
  }
  if (meant.empty()) {
    meant = schema::closest_word(name, std::vector<std::string_view>(labels.begin(), labels.end()));
  }
  return Failure({meant.empty() ? says::unknown_axis : says::unknown_axis_meant,
                  {{"axis", name}, {"axes", joined(labels)}, {"meant", meant}}});
}

std::vector<std::size_t> chosen_axes(image::ImageContents const& image,
                                     std::optional<std::string> const& name) {
  std::vector<std::size_t> chosen;
  std::vector<std::string> labels;
  for (std::size_t axis = 0; axis < image.axes.size(); ++axis) {
    labels.push_back(axis_label(image, axis));
    if (!name || *name == labels.back()) chosen.push_back(axis);
  }
  if (!name || !chosen.empty()) return chosen;
  throw unknown_axis(*name, labels);
}

std::string_view port_name(Port port) {
  return ports.begin()[static_cast<std::size_t>(port)].first;
}

std::uint32_t level_of(std::optional<std::string> const& word) {
  static constexpr std::array<std::pair<std::string_view, std::uint32_t>, 6> levels = {
      {{"portable", AXISRT_LEVEL_PORTABLE},
       {"auto", AXISRT_LEVEL_AUTOMATIC},
       {"v2", AXISRT_LEVEL_X86_64_V2},
       {"v3", AXISRT_LEVEL_X86_64_V3},
       {"v4", AXISRT_LEVEL_X86_64_V4},
       {"neon", AXISRT_LEVEL_NEON}}};
  if (!word) return AXISRT_LEVEL_PORTABLE;
  for (auto const& [name, level] : levels) {
    if (*word == name) return level;
  }
  throw Failure({says::bad_choice,
                 {{"option", "--level"}, {"value", *word}, {"choices", "portable, auto, v2, v3, v4, neon"}}});
}

image::RuntimeHost start_runtime(std::string const& path, ImageFile const& file, std::uint32_t level) {
  auto host = image::RuntimeHost::create(file.bytes.bytes(), std::nullopt, level);
  if (auto const* const status = std::get_if<axisrt_status>(&host)) {
    if (*status == AXISRT_NO_LEVEL) throw Failure({says::no_level});
    throw unusable_image(path, *status);
  }
  return std::get<image::RuntimeHost>(std::move(host));
}

}  // namespace axisc
