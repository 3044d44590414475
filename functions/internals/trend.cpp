#include "functions/internals/dispatch.h"

namespace durer::functions {

Trend internal_value(int number, const Trend* arguments, const Context& context) {
  return dispatch_internal(number, arguments, context);
}

}  // namespace durer::functions
