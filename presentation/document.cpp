#include "presentation/document.hpp"

#include "diagnostics/message.hpp"

#include <utility>

namespace axisc::presentation {

Field data(std::string key, Value value) {
  return {.key = std::move(key),
          .label = axisc::says::as_given,
          .value = std::move(value),
          .audience = Audience::programs};
}

}  // namespace axisc::presentation
