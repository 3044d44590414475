#include "tracer/film/progress.h"

namespace durer::tracer {

ProgressMeter::ProgressMeter(std::uint64_t pixels_total,
                             const std::function<void(const Progress&)>& report,
                             const std::atomic<bool>* cancel)
    : total_(pixels_total), report_(&report), cancel_(cancel) {}

void ProgressMeter::add(std::uint64_t pixels, std::uint64_t rays) {
  constexpr std::chrono::milliseconds interval(200);
  pixels_ += pixels;
  rays_ += rays;
  if (!*report_) return;
  // A thread that finds another one reporting goes on with its work.
  const std::unique_lock lock(reporting_, std::try_to_lock);
  if (!lock.owns_lock() || Clock::now() < next_report_) return;
  next_report_ = Clock::now() + interval;
  (*report_)(now());
}

Progress ProgressMeter::now() const {
  const std::chrono::duration<double> elapsed = Clock::now() - start_;
  return {pixels_.load(), total_, rays_.load(), elapsed.count()};
}

}  // namespace durer::tracer
