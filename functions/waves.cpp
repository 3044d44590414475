#include "functions/waves.h"

#include <algorithm>
#include <limits>

#include "functions/operands.h"

namespace durer::functions {
namespace {

bool is_wave(const Instruction& in) { return in.op == Op::sine || in.op == Op::cosine; }

/// Puts the instructions of a tape into a new order.
class Gathering {
 public:
  explicit Gathering(const Function& f) : from_(f), to_(f), new_place_(f.registers) {
    to_.code.clear();
    known_.assign(f.registers, true);
    for (const Instruction& in : f.code) {
      for (std::uint32_t k = 0; k < results_of(in); ++k) known_[in.dst + k] = false;
    }
    for (Register r = 0; r < f.registers; ++r) new_place_[r] = r;
  }

  Function run() {
    std::vector<Instruction> waiting = from_.code;
    while (!waiting.empty()) {
      std::vector<Instruction> later;
      std::vector<Instruction> waves;
      for (const Instruction& in : waiting) {
        if (!is_ready(in)) {
          later.push_back(in);
        } else if (is_wave(in)) {
          waves.push_back(in);
        } else {
          emit(in);
        }
      }
      gather(waves);
      waiting = std::move(later);
    }
    for (Register& r : to_.results) r = new_place_[r];
    return std::move(to_);
  }

 private:
  bool is_ready(const Instruction& in) const {
    bool ready = true;
    for_operands(from_, in, [&](const Register& r) { ready = ready && known_[r]; });
    return ready;
  }
  void emit(Instruction in) {
    for (std::uint32_t k = 0; k < results_of(in); ++k) known_[in.dst + k] = true;
    for_operands(to_, in, [&](Register& r) { r = new_place_[r]; });
    to_.code.push_back(in);
  }
  void gather(const std::vector<Instruction>& waves) {
    if (waves.empty()) return;
    std::vector<Register> angles;
    for (const Instruction& in : waves) {
      const Register angle = new_place_[in.a];
      auto place = std::find(angles.begin(), angles.end(), angle);
      if (place == angles.end()) place = angles.insert(place, angle);
      const auto index = static_cast<Register>(place - angles.begin());
      new_place_[in.dst] = to_.registers + 2 * index + (in.op == Op::cosine ? 1 : 0);
      known_[in.dst] = true;
    }
    const auto first = static_cast<std::uint32_t>(to_.operands.size());
    to_.operands.insert(to_.operands.end(), angles.begin(), angles.end());
    const auto results = static_cast<std::uint16_t>(2 * angles.size());
    to_.code.push_back({Op::waves, results, to_.registers, first, 0});
    to_.registers += results;
  }

  const Function& from_;
  Function to_;
  std::vector<Register> new_place_;
  std::vector<bool> known_;
};

}  // namespace

Function with_waves(const Function& f) {
  const auto branches = [](const Instruction& in) {
    return in.op == Op::select || in.op == Op::loop;
  };
  constexpr std::ptrdiff_t most = std::numeric_limits<std::uint16_t>::max() / 2;
  const auto waves = std::count_if(f.code.begin(), f.code.end(), is_wave);
  if (waves == 0 || waves > most) return f;
  if (std::any_of(f.code.begin(), f.code.end(), branches)) return f;
  return Gathering(f).run();
}

}  // namespace durer::functions
