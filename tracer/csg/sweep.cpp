#include "tracer/csg/sweep.h"

namespace durer::tracer {

void Sweep::flip(std::uint32_t leaf) {
  inside_[leaf] ^= 1U;
  bool now = leaf_value(leaf);
  for (std::uint32_t n = solid_.leaves[leaf].parent; n != no_node; n = solid_.nodes[n].parent) {
    const SolidNode& node = solid_.nodes[n];
    const bool before = node.value(counts_[n]);
    counts_[n] += now ? 1U : ~0U;
    now = node.value(counts_[n]);
    if (now == before) return;
  }
}

bool Sweep::begin(const Ray& ray, double t_from, double t_to, std::uint8_t who) {
  b_.crossings.clear();
  if (!BoxTree::clip(solid_.surface, ray.o, 1.0 / ray.d, t_from, t_to)) return false;
  const std::size_t slots = solid_.stores.size();
  for (std::size_t s = 0; s < slots; ++s) b_.asked[s].clear();
  for (const std::uint32_t leaf : solid_.endless) ask(leaf, who);
  solid_.boxes.along(ray, t_from, t_to,
                     [&](std::uint32_t box) { ask(solid_.leaf_of_box[box], who); });
  b_.begun.clear();
  for (std::size_t s = 0; s < slots; ++s) {
    if (!b_.asked[s].empty()) solid_.stores[s]->crossings(b_.asked[s], ray, b_.crossings, b_.begun);
  }
  for (const std::uint32_t leaf : b_.begun) {
    flip(leaf);
    b_.flipped.push_back(leaf);
  }
  std::sort(b_.crossings.begin(), b_.crossings.end(), [](const Crossing& a, const Crossing& b) {
    return a.t != b.t ? a.t < b.t : a.leaf < b.leaf;
  });
  return !b_.crossings.empty();
}

void Sweep::place(dvec3 p) {
  const auto test = [&](std::uint32_t leaf) {
    const SolidLeaf& l = solid_.leaves[leaf];
    if (!l.store->contains(l.shape, p)) return;
    flip(leaf);
    b_.flipped.push_back(leaf);
  };
  for (const std::uint32_t leaf : solid_.endless) test(leaf);
  solid_.boxes.at(p, [&](std::uint32_t box) { test(solid_.leaf_of_box[box]); });
}

/// Goes from a leaf to the root: f(node, count, truth of the child below); ends when f is false.
template <typename F>
bool Sweep::climb(std::uint32_t leaf, F&& f) const {
  bool child = leaf_value(leaf);
  for (std::uint32_t n = solid_.leaves[leaf].parent; n != no_node; n = solid_.nodes[n].parent) {
    if (!f(solid_.nodes[n], counts_[n], child)) return false;
    child = solid_.nodes[n].value(counts_[n]);
  }
  return true;
}

void Sweep::judge(std::size_t begin, std::size_t end) {
  b_.shown.clear();
  if (end - begin == 1) return judge_one(b_.crossings[begin]);
  judge_group(begin, end);
}

void Sweep::judge_one(const Crossing& c) {
  const bool seen = c.visible && !solid_.leaves[c.leaf].muted &&
                    climb(c.leaf, [](const SolidNode& node, std::uint32_t count, bool child) {
                      return node.passes(count, child);
                    });
  b_.shown.push_back(seen ? 1 : 0);
  cross(c);
}

// Where crossings coincide, the others are not simply inside or outside. A surface is let through
// by a node if the others let it through both before and behind the event, or if the node's own
// truth changes there: two boxes that begin together make one face, a hole that begins with its
// block leaves none.
void Sweep::judge_group(std::size_t begin, std::size_t end) {
  b_.before.clear();
  for (std::size_t i = begin; i < end; ++i) {
    climb(b_.crossings[i].leaf, [&](const SolidNode& node, std::uint32_t count, bool child) {
      b_.before.push_back({node.passes(count, child), node.value(count)});
      return true;
    });
  }
  for (std::size_t i = begin; i < end; ++i) cross(b_.crossings[i]);
  std::size_t at = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const Crossing& c = b_.crossings[i];
    bool seen = c.visible && !solid_.leaves[c.leaf].muted;
    climb(c.leaf, [&](const SolidNode& node, std::uint32_t count, bool child) {
      const SweepBuffers::Verdict& before = b_.before[at++];
      seen = seen &&
             ((before.passes && node.passes(count, child)) || before.value != node.value(count));
      return true;
    });
    b_.shown.push_back(seen ? 1 : 0);
  }
}

bool solid_contains(const Solid& solid, dvec3 p, SweepState& state) {
  if (!solid.inside.contains(p)) return false;
  Sweep sweep(solid, state, state.gates);
  sweep.place(p);
  return sweep.root();
}

}  // namespace durer::tracer
