#include "functions/internals/dispatch.h"

namespace durer::functions {

Interval internal_value(int number, const Interval* arguments, const Context& context) {
  return dispatch_internal(number, arguments, context);
}

}  // namespace durer::functions
