#include "bench/runtime/peers.hpp"

#include <liquid/liquid.h>
#include <memory>
#include <rtfilter.h>

namespace axisc::bench {
namespace {

/// Numerator and denominator of a cascade: rtfilter takes one polynomial each.
struct Polynomials {
  std::vector<double> numerator{1};
  std::vector<double> denominator{1};
};

std::vector<double> product(std::vector<double> const& a, std::vector<double> const& b) {
  std::vector<double> result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) result[i + k] += a[i] * b[k];
  }
  return result;
}

Polynomials polynomials_of(PlainAxis const& axis) {
  Polynomials result;
  for (Biquad const& section : axis.sections) {
    result.numerator = product(result.numerator, {section.b0, section.b1, section.b2});
    result.denominator = product(result.denominator, {1, section.a1, section.a2});
  }
  return result;
}

Peer rtfilter_peer(PlainAxis const& axis, std::size_t axes) {
  Polynomials const filter_of_axis = axis.taps.empty() ? polynomials_of(axis) : Polynomials{axis.taps, {1}};
  hfilter const filter = rtf_create_filter(
      static_cast<unsigned>(axes), RTF_DOUBLE, static_cast<unsigned>(filter_of_axis.numerator.size()),
      filter_of_axis.numerator.data(), static_cast<unsigned>(filter_of_axis.denominator.size()),
      filter_of_axis.denominator.data(), RTF_DOUBLE);
  std::shared_ptr<std::remove_pointer_t<hfilter>> const owned(filter, rtf_destroy_filter);
  return {"rtfilter", [owned](double const* in, double* out) { rtf_filter(owned.get(), in, out, 1); }};
}

Peer liquid_fir_peer(std::vector<PlainAxis> const& axes) {
  using Filter = std::remove_pointer_t<firfilt_rrrf>;
  auto const filters = std::make_shared<std::vector<std::shared_ptr<Filter>>>();
  for (PlainAxis const& axis : axes) {
    std::vector<float> taps(axis.taps.begin(), axis.taps.end());
    filters->emplace_back(firfilt_rrrf_create(taps.data(), static_cast<unsigned>(taps.size())),
                          [](firfilt_rrrf filter) { firfilt_rrrf_destroy(filter); });
  }
  return {"liquid", [filters](double const* in, double* out) {
            for (std::size_t i = 0; i < filters->size(); ++i) {
              float y = 0;
              firfilt_rrrf_push((*filters)[i].get(), static_cast<float>(in[i]));
              firfilt_rrrf_execute((*filters)[i].get(), &y);
              out[i] = static_cast<double>(y);
            }
          }};
}

Peer liquid_iir_peer(std::vector<PlainAxis> const& axes) {
  using Filter = std::remove_pointer_t<iirfilt_rrrf>;
  auto const filters = std::make_shared<std::vector<std::shared_ptr<Filter>>>();
  for (PlainAxis const& axis : axes) {
    std::vector<float> b;
    std::vector<float> a;
    for (Biquad const& section : axis.sections) {
      for (double const value : {section.b0, section.b1, section.b2}) b.push_back(static_cast<float>(value));
      for (double const value : {1.0, section.a1, section.a2}) a.push_back(static_cast<float>(value));
    }
    filters->emplace_back(
        iirfilt_rrrf_create_sos(b.data(), a.data(), static_cast<unsigned>(axis.sections.size())),
        [](iirfilt_rrrf filter) { iirfilt_rrrf_destroy(filter); });
  }
  return {"liquid", [filters](double const* in, double* out) {
            for (std::size_t i = 0; i < filters->size(); ++i) {
              float y = 0;
              iirfilt_rrrf_execute((*filters)[i].get(), static_cast<float>(in[i]), &y);
              out[i] = static_cast<double>(y);
            }
          }};
}

}  // namespace

std::vector<Peer> make_peers(std::string const& case_name, std::vector<PlainAxis> const& axes) {
  if (case_name == "a" || case_name == "b")
    return {rtfilter_peer(axes.front(), axes.size()), liquid_iir_peer(axes)};
  if (case_name == "d" || case_name == "e")
    return {rtfilter_peer(axes.front(), axes.size()), liquid_fir_peer(axes)};
  return {};
}

}  // namespace axisc::bench
