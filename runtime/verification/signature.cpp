#include "runtime/verification/signature.hpp"

#include "runtime/verification/image_view.hpp"

namespace axisc::runtime {

axisrt_status check_signature(axisrt_config const& config) {
  if (config.verify_signature == nullptr) return AXISRT_OK;
  if (config.image == nullptr) return AXISRT_BAD_ARGUMENT;
  auto const* const image = static_cast<uint8_t const*>(config.image);
  axisrt_status const status = check_header(image, config.image_size);
  if (status != AXISRT_OK) return status;
  auto const signed_size = static_cast<size_t>(Record<record::header>(image)[field::header::total_size]);
  if (signed_size == config.image_size) return AXISRT_UNSIGNED;
  uint8_t const* const trailer = image + signed_size;
  int const answer = config.verify_signature(config.verify_context, trailer + axim_trailer_key_id_offset,
                                             image, signed_size, trailer + axim_trailer_signature_offset);
  return answer == 0 ? AXISRT_OK : AXISRT_WRONG_SIGNATURE;
}

}  // namespace axisc::runtime
