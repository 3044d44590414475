// Eight points at a time: every instruction set gives the bits of single points.
#include "functions/simd/tape_lanes.h"

#include <bit>
#include <limits>
#include <random>

#include "functions/builder.h"
#include "functions/evaluate.h"
#include "functions/waves.h"
#include "tests/support/catch.h"
#include "tests/unit/functions/parse_function.h"

namespace durer::functions {
namespace {

/// Equal to the sign of zero; what is not a number is all alike.
bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (a != a && b != b);
}

/// Numbers where formulas take a turn, and neighbours of whole ones.
double awkward(std::mt19937& rng) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr std::array special{0.0,     -0.0,     1.0,    -1.0,         inf,           -inf,
                               nan,     1e-310,   -1e-310, 0x1p52,      -0x1p52,       0x1p51 + 0.5,
                               1e6,     -1e6,     0.5,    2147483647.5, -2147483648.5, 2147483648.0,
                               -1e-300, 1e300,    -1.5,   2.5,          0x1p53,        -0x1p51 - 0.5};
  if (rng() % 2 == 0) return special[rng() % special.size()];
  const double whole = static_cast<double>(rng() % 7) - 3;
  switch (rng() % 3) {
    case 0: return std::nextafter(whole, 10);
    case 1: return std::nextafter(whole, -10);
    default: return std::uniform_real_distribution<double>(-1e3, 1e3)(rng);
  }
}

/// Each instruction set in turn.
class InstructionSets {
 public:
  template <class F>
  void each(F f) {
    for (const simd::TapeLanes* set : simd::all_tape_lanes()) {
      simd::best_tape_lanes = set;
      f();
    }
  }
  ~InstructionSets() { simd::best_tape_lanes = best_; }

 private:
  const simd::TapeLanes* best_ = simd::best_tape_lanes;
};

void check_bits(const Function& f, std::mt19937& rng, int repeats) {
  Workspace w;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    std::array<Pack, 4> arguments;
    for (Pack& a : arguments) {
      for (double& v : a.v) v = awkward(rng);
    }
    const auto used = std::span<const Pack>(arguments).first(f.parameters);
    InstructionSets().each([&] {
      Evaluator<Pack> at(f, w);
      const Pack batch = at(used);
      for (std::size_t lane = 0; lane < Pack::lanes; ++lane) {
        std::array<double, 4> point{};
        for (std::size_t i = 0; i < 4; ++i) point[i] = arguments[i].v[lane];
        const double alone = evaluate(f, std::span(point).first(f.parameters), w);
        if (same_bits(alone, batch.v[lane])) continue;
        CAPTURE(point, alone, batch.v[lane], lane);
        CHECK(false);
      }
    });
  }
}

}  // namespace

TEST_CASE("tape lanes: every operation has the bits of a single point", "[functions][lanes]") {
  std::mt19937 rng(21);
  for (std::size_t op = 0; op < plain_op_count; ++op) {
    FunctionBuilder b(4);
    std::vector<Value> operands;
    for (int i = 0; i < op_table[op].arity; ++i) operands.push_back(b.parameter(i));
    const Function f = b.finish(b.op(static_cast<Op>(op), operands));
    CAPTURE(op_table[op].name);
    check_bits(f, rng, 100);
  }
}

TEST_CASE("tape lanes: whole formulas have the bits of a single point", "[functions][lanes]") {
  std::mt19937 rng(22);
  for (const char* body :
       {"sin(12*x)*cos(12*y)+sin(12*y)*cos(12*z)+sin(12*z)*cos(12*x)", "sin(x)+cos(2*x)",
        "sin(x)*sin(y)*sin(z)+cos(x+y)*cos(x-z)", "sqrt(x*x+y*y+z*z)-floor(x)*ceil(y)+int(z)",
        "select(x, sin(y), 2, z)+max(x, y, z)", "f_torus(x,y,z,0.9,0.3)-pow(y,2)*exp(z)",
        "sum(i, 1, 4, i*x)*min(y, z)"}) {
    CAPTURE(body);
    check_bits(with_waves(parse_function(body)), rng, 200);
  }
}

TEST_CASE("tape lanes: plain instructions run to the end, others stop them", "[functions][lanes]") {
  const auto stops_at = [](const char* body) {
    const Function f = parse_function(body);
    std::vector<Pack> registers(f.registers, Pack(0.5));
    const auto end = static_cast<std::uint32_t>(f.code.size());
    return end - simd::best_tape_lanes->run(f, registers.data(), 0, end);
  };
  CHECK(stops_at("x*y+sqrt(z)-floor(x/y)") == 0);
  CHECK(stops_at("x*exp(y)") == 2);
}

}  // namespace durer::functions
