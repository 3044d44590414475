#include "base/diagnostic.h"

#include <array>

namespace durer {

std::string_view code_text(Code code) {
  static constexpr std::array texts = {
#define DURER_CODE(name, code, meaning) std::string_view(code),
#include "base/codes.def"
#undef DURER_CODE
  };
  return texts[static_cast<std::size_t>(code)];
}

void Diagnostics::report(Diagnostic d) {
  if (d.severity == Severity::error && ++errors_ > max_errors) return;
  all_.push_back(std::move(d));
}

}  // namespace durer
