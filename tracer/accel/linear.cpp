#include <vector>

#include "tracer/accel/accel.h"

namespace durer::tracer {
namespace {

class LinearAccel final : public Accel {
 public:
  explicit LinearAccel(std::span<const Targets* const> all) : all_(all.begin(), all.end()) {}

  void closest(RayQuery& query) const override {
    for (const Targets* targets : all_) {
      for (std::uint32_t i = 0; i < targets->size(); ++i) targets->nearest(*targets, i, query);
    }
  }
  bool any(RayQuery& query) const override {
    closest(query);
    return query.found.store != nullptr;
  }

 private:
  std::vector<const Targets*> all_;
};

}  // namespace

std::unique_ptr<Accel> make_linear_accel(std::span<const Targets* const> all) {
  return std::make_unique<LinearAccel>(all);
}

}  // namespace durer::tracer
