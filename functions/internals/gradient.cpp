#include "functions/internals/dispatch.h"

namespace durer::functions {

Dual internal_value(int number, const Dual* arguments, const Context& context) {
  return dispatch_internal(number, arguments, context);
}

}  // namespace durer::functions
