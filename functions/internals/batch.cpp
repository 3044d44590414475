#include "functions/internals/dispatch.h"

namespace durer::functions {

Pack internal_value(int number, const Pack* arguments, const Context& context) {
  return dispatch_internal(number, arguments, context);
}

}  // namespace durer::functions
