#include "validator/rules/fir_view.hpp"

namespace axisc::validator {

FirView::FirView(EffectiveValues const& values)
    : enable(values.at("filter_fir.enable")),
      type(values.at("filter_fir.type")),
      order(values.at("filter_fir.order")),
      share(values.at("filter_fir.share")),
      frequency(values.at("filter_fir.fcut")),
      quality(values.at("filter_fir.quality")) {}

FirType FirView::configured_type() const {
  double const number = type.value.number;
  if (type.unusable || number < 1 || number > 4) return FirType::none;
  return static_cast<FirType>(static_cast<int>(number));
}

EffectiveValue const& FirView::anchor(EffectiveValue const& wanted) const {
  if (wanted.set()) return wanted;
  // A filter that is configured has a type that a list sets: the internal default is none.
  return enable.set() ? enable : type;
}

}  // namespace axisc::validator
