#include "validator/views/guard_view.hpp"

#include "design/kernels/vibration_guard.hpp"

namespace axisc::validator {
namespace {

/// Views are made by the thousand; the names are looked up once.
struct GuardSlots {
  schema::Slot active = row_at("vib_guard.active").first_slot;
  schema::Slot mode = row_at("vib_guard.mode").first_slot;
  schema::Slot frequency = row_at("vib_guard.freq").first_slot;
  schema::Slot damping = row_at("vib_guard.damping").first_slot;
};

GuardSlots const& guard_slots() {
  static GuardSlots const known;
  return known;
}

}  // namespace

GuardView::GuardView(EffectiveValues const& values)
    : active(values[guard_slots().active]),
      mode(values[guard_slots().mode]),
      frequency(values[guard_slots().frequency]),
      damping(values[guard_slots().damping]),
      readings(values.readings()) {}

std::optional<design::KernelSpecification> GuardView::specification(design::CycleTime cycle_time) const {
  if (mode.unusable || frequency.unusable || damping.unusable) return std::nullopt;
  double const number = mode.value.number;
  double const D = damping.value.number;
  design::Hertz const f{frequency.value.number};
  bool const in_range = number >= 1 && number <= design::guard_modes && D >= 0 && D < 1 && f.value >= 1 &&
                        f < design::as_read(cycle_time, readings.cycle_time).nyquist();
  if (!in_range) return std::nullopt;
  return design::KernelSpecification{.type = design::KernelType::vibration_guard,
                                     .order = static_cast<std::uint32_t>(number),
                                     .frequency = f,
                                     .quality = D,
                                     .reading = design::kernel_reading(readings.guard),
                                     .cycle_time = readings.cycle_time};
}

EffectiveValue const& GuardView::anchor(EffectiveValue const& wanted) const {
  for (EffectiveValue const* const value : {&wanted, &active, &mode, &frequency, &damping}) {
    if (value->set()) return *value;
  }
  return active;
}

std::optional<design::KernelSpecification> guard_after(design::KernelSpecification const& listed,
                                                       machine::FilterParameters const& parameters) {
  auto const guard = machine::with_parameters(listed, parameters);
  return guard.quality < 1 ? std::optional(guard) : std::nullopt;
}

bool can_be_compiled(design::KernelSpecification const& guard, design::CycleTime cycle_time) {
  // A centred mode 4 begins up to a cycle later; how far it reaches decides.
  return design::guard_length(guard, cycle_time) <= design::longest_guard + 1.0 &&
         design::tap_count(guard, cycle_time) <= design::longest_guard + 1;
}

}  // namespace axisc::validator
