// The names that every scene finds declared (language §3.2, §9.2, §9.6).
#include <cstdlib>
#include <filesystem>

#include <fmt/printf.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {
namespace {

/// The oracle hands the numbers of a frame over as text of six significant digits.
double six_digits(double x) { return std::strtod(fmt::sprintf("%g", x).c_str(), nullptr); }

Value text_value(const std::string& s) {
  return text_value(Text(s));
}

}  // namespace

void Interpreter::predefine() {
  // Declared on the command line first: those win over the predefined names.
  const auto global = [&](std::string_view name, Value value) {
    const SymbolId id = symbols_.intern(name);
    if (env_.find(id) == nullptr) env_.for_global(id).value = std::move(value);
  };
  for (const auto& [name, value] : options_.declares) {
    if (const double* x = std::get_if<double>(&value)) {
      global(name, Value(Num(*x)));
    } else {
      global(name, text_value(std::get<std::string>(value)));
    }
  }
  const auto number = [&](std::string_view name, double x) {
    global(name, Value(Num(six_digits(x))));
  };
  global("image_width", Value(Num(options_.width)));
  global("image_height", Value(Num(options_.height)));
  const std::filesystem::path scene(std::string(sources_.path(main_file_)));
  global("input_file_name", text_value(scene.filename().string()));
  const AnimationFrame& f = options_.frame;
  number("frame_number", f.number);
  number("initial_frame", f.first);
  number("final_frame", f.last);
  number("initial_clock", f.first_clock);
  number("final_clock", f.last_clock);
  number("clock_delta", f.clock_delta);
}

}  // namespace durer::interpreter
