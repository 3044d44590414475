#include "functions/internals/dispatch.h"

namespace durer::functions {

double internal_value(int number, const double* arguments, const Context& context) {
  return dispatch_internal(number, arguments, context);
}

}  // namespace durer::functions
