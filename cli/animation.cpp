#include "cli/animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace durer::cli {
namespace {

/// The numbers that scenes read have gone through a text with six digits in POV-Ray.
double six_digits(double x) { return std::strtod(fmt::format("{:.6g}", x).c_str(), nullptr); }

int six_digits(int x) { return static_cast<int>(six_digits(static_cast<double>(x))); }

/// A frame number, or a fraction (below 1) of `count` frames: rounded down, and not counted from
/// the first frame (language §9.6).
int frame_at(double place, int count) {
  return static_cast<int>(place < 1 ? place * count : std::min(place, 2147483646.0));
}

}  // namespace

double Animation::clock_delta() const {
  if (last == first) return 0;  // POV-Ray divides by zero here
  return (double{last_clock} - double{first_clock}) / (last - first);
}

double Animation::clock(int frame) const {
  return static_cast<float>(double{first_clock} + clock_delta() * (frame - first));
}

interpreter::AnimationFrame Animation::values(int frame) const {
  interpreter::AnimationFrame f;
  f.number = six_digits(frame);
  f.first = six_digits(first);
  f.last = six_digits(last);
  f.first_clock = six_digits(first_clock);
  f.last_clock = six_digits(last_clock);
  f.clock_delta = six_digits(clock_delta());
  return f;
}

std::optional<Animation> animation_of(const Settings& s) {
  const int initial = s.initial_frame.value_or(0);
  const int final = s.final_frame.value_or(0);
  if (initial == final && (final == 0 || final == 1)) return std::nullopt;
  Animation a;
  a.first = std::max(s.initial_frame.value_or(1), 0);
  a.last = std::max(s.final_frame.value_or(1), a.first);
  if (s.cyclic) ++a.last;
  const int count = a.last - a.first + 1;
  a.from = s.subset_start ? std::max(frame_at(*s.subset_start, count), a.first) : a.first;
  const int end = s.cyclic ? a.last - 1 : a.last;
  a.to = std::max(s.subset_end ? frame_at(*s.subset_end, count) : end, a.from);
  a.step = s.frame_step;
  a.first_clock = static_cast<float>(s.initial_clock);
  a.last_clock = static_cast<float>(s.final_clock);
  a.digits = static_cast<int>(std::to_string(a.last).size());
  return a;
}

}  // namespace durer::cli
