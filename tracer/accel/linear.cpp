#include <vector>

#include "tracer/accel/accel.h"

namespace durer::tracer {
namespace {

class LinearAccel final : public Accel {
 public:
  explicit LinearAccel(std::span<const Store* const> stores) : stores_(stores.begin(), stores.end()) {}

  void closest(RayQuery& query) const override {
    for (const Store* store : stores_) {
      for (std::uint32_t i = 0; i < store->size(); ++i) store->nearest(*store, i, query);
    }
  }
  bool any(RayQuery& query) const override {
    closest(query);
    return query.found.store != nullptr;
  }

 private:
  std::vector<const Store*> stores_;
};

}  // namespace

std::unique_ptr<Accel> make_linear_accel(std::span<const Store* const> stores) {
  return std::make_unique<LinearAccel>(stores);
}

}  // namespace durer::tracer
