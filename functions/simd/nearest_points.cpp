#include "functions/simd/nearest_points.h"

#include "functions/simd/processor.h"
#include "functions/simd/quad.h"

namespace durer::functions::simd {
namespace {

/// The three smallest values seen, ascending; of quads: lane by lane.
template <class T>
struct Smallest {
  T a, b, c;

  DURER_INLINE void add(T d) {
    const T beyond_a = larger(a, d);
    a = smaller(a, d);
    const T beyond_b = larger(b, beyond_a);
    b = smaller(b, beyond_a);
    c = smaller(c, beyond_b);
  }
};

template <class V, int exponent>
DURER_INLINE V power(V d, int n) {
  if constexpr (exponent == 2) return d * d;
  const V size = larger(d, -d);
  if constexpr (exponent == 1) return size;
  V product = size * size;
  for (int i = 2; i < n; ++i) product = product * size;
  return product;
}

template <class V>
DURER_INLINE V load(const double* p) {
  V v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

/// `V`: a vector of doubles; 4 is a multiple of its lanes. `exponent`: 1, 2, or 3 for all others.
template <class V, int exponent>
DURER_INLINE Smallest3 search(const PointList& points, const dvec3& p, int n,
                              const Smallest3& so_far) {
  constexpr int lanes = sizeof(V) / sizeof(double);
  const V none = V{} + nothing_near[0];
  Smallest<V> found{none, none, none};
  for (int i = 0; i < points.count; i += lanes) {
    found.add((power<V, exponent>(load<V>(points.x + i) - p.x, n) +
               power<V, exponent>(load<V>(points.y + i) - p.y, n)) +
              power<V, exponent>(load<V>(points.z + i) - p.z, n));
  }
  Smallest<double> all{so_far[0], so_far[1], so_far[2]};
  for (int lane = 0; lane < lanes; ++lane) {
    all.add(found.a[lane]);
    all.add(found.b[lane]);
    all.add(found.c[lane]);
  }
  return {all.a, all.b, all.c};
}

/// Of some of four points, a lane each.
template <class V, int exponent>
DURER_INLINE void search_lanes(const PointList& points, const dvec3* p, int n, Smallest3* out) {
  constexpr int lanes = sizeof(V) / sizeof(double);
  V x{}, y{}, z{};
  for (int lane = 0; lane < lanes; ++lane) {
    x[lane] = p[lane].x;
    y[lane] = p[lane].y;
    z[lane] = p[lane].z;
  }
  const V none = V{} + nothing_near[0];
  Smallest<V> found{none, none, none};
  for (int i = 0; i < points.count; ++i) {
    found.add((power<V, exponent>(points.x[i] - x, n) + power<V, exponent>(points.y[i] - y, n)) +
              power<V, exponent>(points.z[i] - z, n));
  }
  for (int lane = 0; lane < lanes; ++lane) {
    out[lane] = {found.a[lane], found.b[lane], found.c[lane]};
  }
}

template <class V, int exponent>
DURER_INLINE FourSmallest3 search(const PointList& points, const FourPoints& p, int n) {
  constexpr std::size_t lanes = sizeof(V) / sizeof(double);
  FourSmallest3 found;
  for (std::size_t i = 0; i < p.size(); i += lanes) {
    search_lanes<V, exponent>(points, &p[i], n, &found[i]);
  }
  return found;
}

/// By exponent; `more` goes on to the search.
template <class V, class Point, class... More>
DURER_INLINE auto search(const PointList& points, const Point& p, int n, const More&... more) {
  if (n == 2) return search<V, 2>(points, p, n, more...);
  if (n == 1) return search<V, 1>(points, p, n, more...);
  return search<V, 3>(points, p, n, more...);
}

struct Kernels {
  Smallest3 (*of_one)(const PointList&, const dvec3&, int, const Smallest3&);
  FourSmallest3 (*of_four)(const PointList&, const FourPoints&, int);
};

constexpr Kernels baseline{
    [](const PointList& points, const dvec3& p, int n, const Smallest3& so_far) {
      return search<Double2>(points, p, n, so_far);
    },
    [](const PointList& points, const FourPoints& p, int n) {
      return search<Double2>(points, p, n);
    },
};
#ifdef __x86_64__
DURER_AVX2 Smallest3 avx2_of_one(const PointList& points, const dvec3& p, int n,
                                 const Smallest3& so_far) {
  return search<Double4>(points, p, n, so_far);
}
DURER_AVX2 FourSmallest3 avx2_of_four(const PointList& points, const FourPoints& p, int n) {
  return search<Double4>(points, p, n);
}
#endif

constinit Kernels best = baseline;
[[maybe_unused]] const bool chosen = [] {
#ifdef __x86_64__
  if (durer::simd::has_avx2()) best = {avx2_of_one, avx2_of_four};
#endif
  return true;
}();

}  // namespace

Smallest3 smallest_distances(const PointList& points, const dvec3& p, int exponent,
                             const Smallest3& so_far) {
  return best.of_one(points, p, exponent, so_far);
}
FourSmallest3 smallest_distances(const PointList& points, const FourPoints& p, int exponent) {
  return best.of_four(points, p, exponent);
}
Smallest3 smallest_distances(const PointList& points, const dvec3& p, int exponent,
                             const Smallest3& so_far, int set) {
  return (set == 0 ? baseline : best).of_one(points, p, exponent, so_far);
}
FourSmallest3 smallest_distances(const PointList& points, const FourPoints& p, int exponent,
                                 int set) {
  return (set == 0 ? baseline : best).of_four(points, p, exponent);
}

}  // namespace durer::functions::simd
