#include "cli/checkpointing.h"

#include <chrono>
#include <filesystem>

#include "tracer/compile.h"

namespace durer::cli {
namespace {

namespace fs = std::filesystem;

/// Between two states on disk: at least this many seconds, and this many times what one takes.
constexpr double interval = 10;
constexpr double patience = 50;

}  // namespace

std::uint64_t Checkpointing::print() {
  if (!print_) print_ = fingerprint(scene_, tracer::registry(), options_);
  return *print_;
}

std::optional<std::string> Checkpointing::take_up() {
  std::error_code ignored;
  if (path_.empty() || !fs::exists(path_, ignored)) return std::nullopt;
  StateRead read = read_state(path_, print());
  if (read.error) return read.error;
  if (checkpoint_.restore(std::move(read.state))) return std::nullopt;
  return "`" + path_ + "` belongs to a picture of another size";
}

void Checkpointing::save_now_and_then(const tracer::Progress& progress) {
  if (path_.empty() || progress.seconds < next_) return;
  const auto start = std::chrono::steady_clock::now();
  (void)save();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  next_ = progress.seconds + taken.count() + std::max(interval, patience * taken.count());
}

std::optional<std::string> Checkpointing::save() {
  if (path_.empty()) return "what was rendered is lost, for the picture has no file";
  return write_state(path_, print(), checkpoint_.copy());
}

void Checkpointing::remove() {
  if (path_.empty()) return;
  std::error_code ignored;
  fs::remove(path_, ignored);
}

}  // namespace durer::cli
