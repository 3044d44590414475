#include "cli/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace durer::cli {
namespace {

/// Seconds between two updates: often enough to look alive, rare enough for a log.
constexpr double terminal_interval = 0.1;
constexpr double plain_interval = 10;

double share(const tracer::Progress& p) {
  if (p.pixels_total == 0) return 1;
  return static_cast<double>(p.pixels_done) / static_cast<double>(p.pixels_total);
}

}  // namespace

std::string count_text(double count) {
  for (const auto& [unit, name] : {std::pair{1e9, " G"}, {1e6, " M"}, {1e3, " k"}}) {
    if (count < unit) continue;
    const double scaled = count / unit;
    return fmt::format("{:.{}f}{}", scaled, scaled < 10 ? 2 : scaled < 100 ? 1 : 0, name);
  }
  return fmt::format("{:.0f}", count);
}

std::string time_text(double seconds) {
  if (seconds < 1) return fmt::format("{:.0f} ms", seconds * 1000);
  if (seconds < 10) return fmt::format("{:.1f} s", seconds);
  const long whole = std::lround(seconds);
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string progress_text(const tracer::Progress& p) {
  std::string text = fmt::format("{:.0f} %", std::floor(share(p) * 100));
  if (p.seconds > 0)
    text += fmt::format(", {} rays/s", count_text(static_cast<double>(p.rays) / p.seconds));
  const double done = share(p);
  if (done > 0.005 && done < 1 && p.seconds > 0.5) {
    text += fmt::format(", {} left", time_text(p.seconds * (1 - done) / done));
  }
  return text;
}

std::string progress_bar(const tracer::Progress& p, int columns) {
  const std::string text = progress_text(p);
  const int room = std::min(40, columns - 4 - static_cast<int>(text.size()));
  if (room < 5) return text.substr(0, static_cast<std::size_t>(std::max(columns - 1, 0)));
  const int full = static_cast<int>(share(p) * room);
  std::string bar(full, '=');
  if (full < room) bar += '>';
  bar.resize(room, ' ');
  return fmt::format("[{}] {}", bar, text);
}

void ProgressLine::show(const tracer::Progress& p) {
  const double interval = columns_ > 0 ? terminal_interval : plain_interval;
  if (p.seconds - last_ < interval) return;
  last_ = p.seconds;
  if (columns_ > 0) {
    fmt::print(to_, "\r\x1b[K{}", progress_bar(p, columns_));
    drawn_ = true;
  } else {
    fmt::print(to_, "{}\n", progress_text(p));
  }
  std::fflush(to_);
}

void ProgressLine::clear() {
  if (!drawn_) return;
  fmt::print(to_, "\r\x1b[K");
  std::fflush(to_);
  drawn_ = false;
}

}  // namespace durer::cli
