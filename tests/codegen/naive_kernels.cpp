#include "naive_kernels.hpp"

#include "design/kernels/kernel_analysis.hpp"
#include "design/kernels/kernel_design.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace axisc::test {
namespace {

using design::KernelSpecification;
using design::KernelType;
using machine::KernelFamily;

constexpr std::uint32_t none = 0xFFFFFFFF;

KernelSpecification without_what_its_type_ignores(KernelSpecification specification,
                                                  design::CycleTime cycle_time) {
  bool const novib = specification.type == KernelType::novib;
  if (!novib && specification.type != KernelType::windowed_sinc) specification.frequency = {30};
  if (specification.type != KernelType::gaussian) specification.quality = 1;
  if (novib) specification.order = design::novib_order(specification.frequency, cycle_time);
  return specification;
}

/// y[n] = sum of b_j x[n-j]
std::vector<NaiveSample> self_test(std::vector<double> const& tails) {
  std::vector<Wide> taps;
  Wide before = 1;
  for (double const tail : tails) {
    taps.push_back(before - tail);
    before = tail;
  }
  taps.push_back(before);
  std::vector<double> const input = naive_test_input(tails.size());
  std::vector<NaiveSample> samples;
  for (std::size_t n = 0; n < input.size(); ++n) {
    Wide output = 0;
    for (std::size_t j = 0; j < taps.size() && j <= n; ++j) output += taps[j] * input[n - j];
    samples.push_back({input[n], static_cast<double>(output)});
  }
  return samples;
}

class Writer {
 public:
  Writer(machine::Machine const& machine, bool strip, NaiveStores& stores,
         std::function<double(machine::AxisConfiguration const&)> const& peak_gain)
      : machine_(machine), strip_(strip), stores_(stores), peak_gain_(peak_gain) {}

  NaiveKernelSections write() {
    for (std::size_t axis = 0; axis < machine_.axes.size(); ++axis) {
      if (auto const& kernel = machine_.axes[axis].kernel) {
        slots_.push_back({axis, kernel_of(kernel->specification), {}, none, none});
        slots_.back().reachable = {none, slots_.back().kernel};
      }
    }
    for (auto const& group : machine_.groups) choose(group);
    for (auto const& specification : specifications_) write_kernel(specification);
    for (Group const& group : groups_) write_group(group);
    for (Slot const& slot : slots_) write_slot(slot);
    return std::move(sections_);
  }

 private:
  struct Slot {
    std::size_t axis;
    std::uint32_t kernel;
    std::set<std::uint32_t> reachable;
    std::uint32_t group, member;
  };
  struct Bank {
    machine::FilterParameters parameters;
    bool hsc;
    std::vector<std::uint32_t> choices;
  };
  struct Group {
    std::string name;
    std::vector<std::size_t> axes;
    std::vector<Bank> banks;
  };

  std::uint32_t kernel_of(KernelSpecification const& wanted) {
    if (wanted.order == 0 || wanted.share_percent == 0) return none;
    KernelSpecification const specification = without_what_its_type_ignores(wanted, machine_.cycle_time);
    for (std::uint32_t i = 0; i < specifications_.size(); ++i) {
      if (specifications_[i] == specification) return i;
    }
    specifications_.push_back(specification);
    return static_cast<std::uint32_t>(specifications_.size() - 1);
  }

  Slot* slot_of(std::size_t axis) {
    for (Slot& slot : slots_)
      if (slot.axis == axis) return &slot;
    return nullptr;
  }
  [[nodiscard]] bool is_hsc(Slot const& slot) const {
    return machine_.axes[slot.axis].kernel->family == KernelFamily::hsc;
  }

  void choose(machine::MachineGroup const& from) {
    Group group{from.name, {}, {}};
    bool any = false;
    bool any_hsc = false;
    for (std::size_t const axis : from.axes) {
      Slot* const slot = slot_of(axis);
      if (slot != nullptr && slot->group != none) continue;  // another channel has it
      if (slot != nullptr) {
        slot->group = static_cast<std::uint32_t>(groups_.size());
        slot->member = static_cast<std::uint32_t>(next_member_ + group.axes.size());
        any = true;
        any_hsc = any_hsc || is_hsc(*slot);
      }
      group.axes.push_back(axis);
    }
    if (!any) return;
    group.banks.push_back({{}, false, {}});
    for (auto const& parameters : from.filter_sets) group.banks.push_back({parameters, false, {}});
    if (any_hsc) group.banks.push_back({{}, true, {}});
    for (Bank& bank : group.banks) {
      for (std::size_t const axis : group.axes) {
        Slot* const slot = slot_of(axis);
        bool const concerned = slot != nullptr && is_hsc(*slot) == bank.hsc;
        bank.choices.push_back(concerned ? choice(*slot, bank.parameters) : none);
      }
    }
    next_member_ += group.axes.size();
    groups_.push_back(group);
  }

  std::uint32_t choice(Slot& slot, machine::FilterParameters const& parameters) {
    KernelSpecification wanted = machine_.axes[slot.axis].kernel->specification;
    wanted.order = parameters.order.value_or(wanted.order);
    wanted.share_percent = parameters.share_percent.value_or(wanted.share_percent);
    wanted.frequency = parameters.frequency.value_or(wanted.frequency);
    wanted.quality = parameters.quality.value_or(wanted.quality);
    std::uint32_t const kernel = kernel_of(wanted);
    slot.reachable.insert(kernel);
    return kernel;
  }

  [[nodiscard]] std::vector<double> tails_of(std::uint32_t kernel) const {
    if (kernel == none) return {};
    return design::design_kernel(specifications_[kernel], machine_.cycle_time).tail_sums;
  }

  void write_kernel(KernelSpecification const& specification) {
    design::KernelDesign const design = design::design_kernel(specification, machine_.cycle_time);
    design::StepFigures const figures = design::step_figures(design, 1e-9);
    std::vector<NaiveSample> const samples =
        strip_ ? std::vector<NaiveSample>{} : self_test(design.tail_sums);
    NaiveBytes& out = sections_.kernels;
    std::size_t const at = out.size();
    out.resize(at + 128);
    put32(out, at, static_cast<std::uint32_t>(specification.type));
    put32(out, at + 4, specification.order);
    put32(out, at + 8, design.half_width);
    put32(out, at + 12, design.delay_cycles);
    put32(out, at + 16, sections_.tails.size() / 8);
    put32(out, at + 20, design.tail_sums.size());
    put32(out, at + 24, stores_.place_samples(samples));
    put32(out, at + 28, samples.size());
    put_double(out, at + 32, specification.share_percent);
    put_double(out, at + 40, specification.frequency.value);
    put_double(out, at + 48, specification.quality);
    put_double(out, at + 56, design.group_delay_cycles);
    put_double(out, at + 64, 1);
    put_double(out, at + 72, figures.peak_gain_bound);
    put_double(out, at + 80, figures.overshoot);
    double tail_gain = 0;
    for (double const tail : design.tail_sums) {
      tail_gain += std::abs(tail);
      std::size_t const end = sections_.tails.size();
      sections_.tails.resize(end + 8);
      put_double(sections_.tails, end, tail);
    }
    put_double(out, at + 88, tail_gain * (1 + 0x1p-45));
  }

  void write_slot(Slot const& slot) {
    auto const& configured = *machine_.axes[slot.axis].kernel;
    std::size_t history = 0;
    for (std::uint32_t const kernel : slot.reachable) history = std::max(history, tails_of(kernel).size());
    NaiveBytes& out = sections_.slots;
    std::size_t const at = out.size();
    out.resize(at + 32);
    put32(out, at, slot.axis);
    put32(out, at + 4, configured.family == KernelFamily::hsc ? 1 : 2);
    put32(out, at + 8, configured.index);
    put32(out, at + 12, slot.kernel);
    put32(out, at + 16, configured.on_at_start ? 1 : 0);
    put32(out, at + 20, history);
    put32(out, at + 24, slot.group);
    put32(out, at + 28, slot.member);
  }

  /// Of all axes that the bank concerns, the longest fade; nullopt as target: off.
  std::uint32_t fade(Group const& group, Bank const* bank) {
    std::uint32_t longest = 1;
    for (std::size_t i = 0; i < group.axes.size(); ++i) {
      Slot const* const slot = slot_of(group.axes[i]);
      if (slot == nullptr || (bank != nullptr && is_hsc(*slot) != bank->hsc)) continue;
      std::uint32_t const one = fade_of(*slot, bank == nullptr ? none : bank->choices[i]);
      if (one == 0) return 0;
      longest = std::max(longest, one);
    }
    return longest;
  }

  std::uint32_t fade_of(Slot const& slot, std::uint32_t to) {
    std::vector<double> const tails_to = tails_of(to);
    long double distance = 0;
    for (std::uint32_t const from : slot.reachable) {
      std::vector<double> const tails_from = tails_of(from);
      long double sum = 0;
      for (std::size_t j = 0; j < std::max(tails_to.size(), tails_from.size()); ++j) {
        long double const a = j < tails_from.size() ? tails_from[j] : 0;
        long double const b = j < tails_to.size() ? tails_to[j] : 0;
        sum += std::abs(a - b);
      }
      distance = std::max(distance, sum);
    }
    auto const& axis = machine_.axes[slot.axis];
    long double const T = machine_.cycle_time.nanoseconds / 1e9L;
    return naive_fade(distance * peak_gain_(axis), axis.velocity_limit * 10 * T,
                      axis.acceleration_limit * 1e4L * T * T);
  }

  void write_group(Group const& group) {
    NaiveBytes& out = sections_.groups;
    std::size_t const at = out.size();
    out.resize(at + 32);
    if (!strip_) stores_.write_text_range(out, at, group.name);
    put32(out, at + 8, sections_.members.size() / 4);
    put32(out, at + 12, group.axes.size());
    put32(out, at + 16, sections_.banks.size() / 64);
    put32(out, at + 20, group.banks.size());
    put32(out, at + 24, fade(group, nullptr));
    for (std::size_t const axis : group.axes) append32(sections_.members, axis);
    for (Bank const& bank : group.banks) write_bank(group, bank);
  }

  void write_bank(Group const& group, Bank const& bank) {
    auto const& p = bank.parameters;
    NaiveBytes& out = sections_.banks;
    std::size_t const at = out.size();
    out.resize(at + 64);
    put32(out, at,
          (p.order ? 1 : 0) + (p.share_percent ? 2 : 0) + (p.frequency ? 4 : 0) + (p.quality ? 8 : 0) +
              (bank.hsc ? 16 : 0));
    if (p.order) put32(out, at + 4, *p.order);
    if (p.share_percent) put_double(out, at + 8, *p.share_percent);
    if (p.frequency) put_double(out, at + 16, p.frequency->value);
    if (p.quality) put_double(out, at + 24, *p.quality);
    put32(out, at + 32, sections_.choices.size() / 4);
    put32(out, at + 36, fade(group, &bank));
    for (std::uint32_t const kernel : bank.choices) append32(sections_.choices, kernel);
  }

  static void append32(NaiveBytes& bytes, std::size_t value) {
    bytes.resize(bytes.size() + 4);
    put32(bytes, bytes.size() - 4, value);
  }

  machine::Machine const& machine_;
  bool strip_;
  NaiveStores& stores_;
  std::function<double(machine::AxisConfiguration const&)> const& peak_gain_;
  NaiveKernelSections sections_;
  std::vector<KernelSpecification> specifications_;
  std::vector<Slot> slots_;
  std::vector<Group> groups_;
  std::size_t next_member_ = 0;
};

}  // namespace

NaiveKernelFigures kernel_at_start(machine::AxisConfiguration const& axis, design::CycleTime cycle_time) {
  if (!axis.kernel || !axis.kernel->on_at_start) return {};
  KernelSpecification const& specification = axis.kernel->specification;
  if (specification.order == 0 || specification.share_percent == 0) return {};
  design::KernelDesign const design =
      design::design_kernel(without_what_its_type_ignores(specification, cycle_time), cycle_time);
  return {design::step_figures(design, 1e-9).peak_gain_bound, design.group_delay_cycles};
}

NaiveKernelSections naive_kernel_sections(
    machine::Machine const& machine, bool strip, NaiveStores& stores,
    std::function<double(machine::AxisConfiguration const&)> const& peak_gain) {
  return Writer(machine, strip, stores, peak_gain).write();
}

std::uint32_t naive_fade(long double L, long double v, long double a) {
  for (std::uint32_t F = 1; F <= 4096 && v > 0 && a > 0; ++F) {
    long double const added_velocity = 15 / (8.0L * F) * L * v;
    long double const added_acceleration = 10 / (std::sqrt(3.0L) * F * F) * L * v + 15 / (4.0L * F) * L * a;
    if (added_velocity <= v / 4 && added_acceleration <= a / 4) return F;
  }
  return 0;
}

}  // namespace axisc::test
