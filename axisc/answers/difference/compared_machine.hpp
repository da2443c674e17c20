// One side of a comparison: a machine from its lists or from an image, in the terms that both have.
#pragma once

#include "axisc/answers/dynamics/channel_values.hpp"
#include "axisc/checking/machine_input.hpp"
#include "axisc/files/image_file.hpp"
#include "validator/loading/loading.hpp"

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct ComparedAxis {
  std::string name;
  std::vector<std::string> called;      ///< what the programs of its channels call it
  std::optional<std::uint32_t> number;  ///< kopf.achs_nr, where lists set it
  std::string list;                     ///< as the machine names it; empty: an image does not tell
  std::string path;                     ///< of the list
  machine::AxisType type = machine::AxisType::translatory;
  std::string drive;                                        ///< empty: not known
  validator::EffectiveValues const* values = nullptr;       ///< null: a stripped image has none
  std::vector<image::ImageValue> const* origins = nullptr;  ///< of an image: where its lines come from
  std::size_t index = 0;                                    ///< in the image
};

struct ComparedProgram {
  std::string name;
  validator::ContentMark mark;
};

struct ComparedChannel {
  std::string name;  ///< its number where it has none
  std::vector<std::string> axes, spindles;
  std::vector<std::string> couplings;  ///< "X2 = X": slave and master
  std::vector<ComparedProgram> programs;
  std::vector<ChannelValue> dynamics;  ///< of lists
};

struct ComparedGantry {
  std::string master;
  std::vector<std::string> slaves;
};

struct ComparedMachine {
  std::string input;  ///< as named on the command line
  std::vector<ComparedAxis> axes;
  bool tells_channels = false;  ///< false for a single list, and for an image of one axis
  bool tells_all = false;       ///< spindles, couplings, programs and gantries are known: not an image
  std::vector<ComparedChannel> channels;
  std::vector<ComparedGantry> gantries;
  design::CycleTime cycle_time;
  bool cycle_time_known = true;             ///< false: 1 ms is assumed
  std::optional<machine::Machine> machine;  ///< none after errors, and of an image
  std::optional<ImageFile> image;  ///< none after errors: what the lists do to the axes is not known then

  /// What the values look into.
  SourceSet sources;
  std::optional<validator::LoadedMachine> loaded;
  std::deque<validator::LoadedList> lists;
  std::deque<validator::MergedValues> merged;

  /// "listen/achsmds1.lis:12"; empty where no list sets the value.
  [[nodiscard]] std::string place_of(ComparedAxis const& axis, validator::EffectiveValue const& value) const;
  /// The value as the list writes it; empty where no list sets it.
  [[nodiscard]] std::string written(validator::EffectiveValue const& value) const;
};

/// Reads a list, a machine file, a start-up list, the only machine in a folder, or an image. `errors` takes
/// errors, and what can be read is compared nevertheless; null where that is no axis. Failure for what cannot
/// be read or compiled.
[[nodiscard]] std::unique_ptr<ComparedMachine> compared_machine(Workspace& workspace,
                                                                std::string const& input,
                                                                ErrorSink const& errors);

/// The two sides of a comparison; one object where both are one input.
struct ComparedSides {
  std::shared_ptr<ComparedMachine> before, after;
  /// A list to which two start-up lists lead: lists name each other from a folder above, so that the copy
  /// of a folder may lead back to the original.
  std::optional<std::string> read_by_both = {};
};

/// As compared_machine(); none where one of them is no axis. A list alone does not say its NC cycle time:
/// that of the other side counts.
[[nodiscard]] std::optional<ComparedSides> compared_sides(Workspace& workspace, std::string const& before,
                                                          std::string const& after, ErrorSink const& errors);

}  // namespace axisc
