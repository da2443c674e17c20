#include "tests/runtime/c99/random_image.hpp"

#include "tests/runtime/c99/random_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axisc::test {
namespace {

/// Poles anywhere inside the unit circle, often next to z = 1 or in the middle of it.
SectionRecord random_section(Random& random) {
  SectionRecord section;
  section.b = random.chance(4)   ? 1
              : random.chance(3) ? random.magnitude(-40, 0)
                                 : random.between(0.001, 1.999);
  double const largest = 4 - 2 * section.b;
  section.k =
      std::min(random.chance(2) ? random.magnitude(-70, 1) : random.between(0, largest), largest * 0.999);
  section.p = random.chance(6) ? random.sign() * random.magnitude(-60, 6) : random.between(-2, 2);
  section.q =
      random.chance(3) ? -section.p + random.sign() * random.magnitude(-70, 0) : random.between(-2, 2);
  return section;
}

FilterRecord random_filter(Random& random, std::uint32_t index) {
  FilterRecord filter;
  filter.index = index;
  filter.realisation = random.chance(8) ? 0 : random.chance(5) ? 2 : 1;
  if (random.chance(3)) set_share(filter, random.chance(4) ? random.magnitude(-80, 0) : random.between(0, 1));
  if (filter.realisation == 2) filter.delay_cycles = random.below(random.chance(2) ? 5 : 101);
  if (filter.realisation == 1) {
    filter.blocks_constant = random.chance(3) ? 1 : 0;
    filter.sections.resize(1 + random.below(6));
    for (SectionRecord& section : filter.sections) section = random_section(random);
  }
  return filter;
}

std::vector<FilterRecord> random_chain(Random& random, std::uint32_t least, std::uint32_t most) {
  std::vector<FilterRecord> filters(least + random.below(most - least + 1));
  for (std::uint32_t i = 0; i < filters.size(); ++i) filters[i] = random_filter(random, i);
  return filters;
}

KernelRecord random_kernel(Random& random) {
  if (random.chance(3)) return moving_average(1 + random.below(random.chance(2) ? 4 : 100));
  if (random.chance(3))
    return delay_kernel(1 + random.below(random.chance(2) ? 4 : 200), random.between(0, 1));
  bool const guard = random.chance(2);
  KernelRecord kernel;
  kernel.type = guard ? 5 : 2;
  kernel.tails.resize(1 + random.below(random.chance(2) ? 20 : guard ? 960 : 200));
  for (double& tail : kernel.tails) {
    tail = random.chance(10) ? random.sign() * random.magnitude(-140, 6) : random.between(-1, 1);
  }
  kernel.delay_cycles = static_cast<std::uint32_t>(kernel.tails.size());
  kernel.peak_gain = random.between(1, 3);
  return kernel;
}

/// None, or one that a slot of this family may execute.
std::uint32_t random_choice(Random& random, ImageRecord const& image, std::uint32_t family) {
  if (image.kernels.empty() || random.chance(5)) return none;
  std::uint32_t const kernel = random.below(static_cast<std::uint32_t>(image.kernels.size()));
  return family != 3 && image.kernels[kernel].tails.size() > 200 ? none : kernel;
}

BankRecord random_bank(Random& random, ImageRecord const& image, GroupRecord const& group,
                       std::uint32_t number) {
  BankRecord bank;
  if (number > 0) {
    bank.keywords = number == 1 && random.chance(2) ? 16 : random.chance(3) ? 33 : 1 + 2 * random.below(2);
    bank.order = number;
    bank.share = (bank.keywords & 2U) != 0 ? 50 : 0;
  }
  bank.fade_cycles = random.chance(4) ? 0 : 1 + random.below(random.chance(2) ? 8 : 200);
  for (std::uint32_t const axis : group.members) {
    auto const slot = std::find_if(image.slots.begin(), image.slots.end(),
                                   [&](SlotRecord const& one) { return one.axis == axis; });
    bank.choices.push_back(slot == image.slots.end() ? none : random_choice(random, image, slot->family));
  }
  return bank;
}

void add_groups(Random& random, ImageRecord& image) {
  image.groups.resize(random.below(3));
  if (image.groups.empty()) return;
  for (std::uint32_t axis = 0; axis < image.axes.size(); ++axis) {
    if (random.chance(6)) continue;
    auto const group = random.below(static_cast<std::uint32_t>(image.groups.size()));
    image.groups[group].members.push_back(axis);
    for (SlotRecord& slot : image.slots) {
      if (slot.axis == axis) slot.group = group;
    }
  }
  for (GroupRecord& group : image.groups) {
    for (std::uint32_t number = 0; number < 1 + random.below(5); ++number) {
      group.banks.push_back(random_bank(random, image, group, number));
    }
    group.off_fade_cycles = random.chance(4) ? 0 : 1 + random.below(40);
  }
}

/// Every slot has room for each kernel that it may be given.
void size_histories(Random& random, ImageRecord& image) {
  for (SlotRecord& slot : image.slots) {
    std::size_t longest = slot.kernel == none ? 0 : image.kernels[slot.kernel].tails.size();
    for (GroupRecord const& group : image.groups) {
      for (std::size_t member = 0; member < group.members.size(); ++member) {
        if (group.members[member] != slot.axis) continue;
        for (BankRecord const& bank : group.banks) {
          if (bank.choices[member] == none) continue;
          longest = std::max(longest, image.kernels[bank.choices[member]].tails.size());
        }
      }
    }
    std::size_t const most = slot.family == 3 ? 960 : 200;
    slot.history =
        static_cast<std::uint32_t>(std::min(most, longest + random.below(random.chance(2) ? 1 : 9)));
  }
}

void add_controls(Random& random, ImageRecord& image) {
  std::uint32_t master = none;
  for (std::uint32_t axis = 0; axis < image.axes.size(); ++axis) {
    if (!random.chance(3)) continue;
    ControlRecord control{.axis = axis,
                          .source = axis,
                          .stages = {},
                          .limit = random.magnitude(-10, 60),
                          .scale = random.between(-4, 4)};
    if (master != none && random.chance(3)) {
      control.source = master;
    } else {
      control.stages.resize(1 + random.below(3));
      for (std::uint32_t i = 0; i < control.stages.size(); ++i) {
        control.stages[i] = {.index = i,
                             .mode = 1 + random.below(3),
                             .weight = random.between(0, 7),
                             .filters = random_chain(random, 1, 3)};
      }
      master = axis;
    }
    image.controls.push_back(std::move(control));
  }
}

}  // namespace

ImageRecord random_image(std::uint32_t seed) {
  Random random(seed);
  ImageRecord image;
  image.strip = random.chance(2);
  image.format_minor = 2;
  image.kernels.resize(random.below(6));
  for (KernelRecord& kernel : image.kernels) kernel = random_kernel(random);
  bool const many_forms = seed % 8 == 0;
  std::vector<std::vector<FilterRecord>> chains(many_forms ? 50 : 1 + random.below(4));
  for (auto& chain : chains) chain = random_chain(random, 0, 3);
  image.axes.resize(many_forms ? 60 + random.below(60) : 1 + random.below(8));
  for (std::uint32_t i = 0; i < image.axes.size(); ++i) {
    AxisRecord& axis = image.axes[i];
    bool const own = !many_forms && random.chance(2);
    axis.filters =
        own ? random_chain(random, 0, 3) : chains[random.below(static_cast<std::uint32_t>(chains.size()))];
    axis.interface_filters = random_chain(random, 0, 1);
    axis.position_window = random.magnitude(-4, 10);
    axis.velocity_limit = random.chance(3) ? 0 : random.magnitude(-4, 20);
    axis.peak_gain = random.between(1, 4);
    if (!image.kernels.empty() && random.chance(many_forms ? 8 : 2)) {
      std::uint32_t const family = 1 + random.below(3);
      image.slots.push_back({.axis = i,
                             .family = family,
                             .kernel = random_choice(random, image, family),
                             .on_at_start = random.below(2)});
    }
  }
  add_groups(random, image);
  size_histories(random, image);
  add_controls(random, image);
  return image;
}

}  // namespace axisc::test
