// SPDX-License-Identifier: Apache-2.0
// A whole accelerator as a plugin: a binary hierarchy of boxes, halved at the median of the
// triangles' middles along the longest axis.
#include <lume/accelerator_plugin.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

constexpr float k_infinity = std::numeric_limits<float>::infinity();

struct Box {
  float lower[3] = {k_infinity, k_infinity, k_infinity};
  float upper[3] = {-k_infinity, -k_infinity, -k_infinity};

  void add(const float* p) {
    for (int i = 0; i < 3; ++i) {
      lower[i] = std::min(lower[i], p[i]);
      upper[i] = std::max(upper[i], p[i]);
    }
  }
};

struct Node {
  Box box;
  std::uint32_t first = 0;  // of the leaf's triangles, or the first of two children
  std::uint32_t count = 0;  // of triangles; 0: an inner node
};

struct Bvh {
  LumeTriangles triangles;
  std::vector<std::uint32_t> order;
  std::vector<Node> nodes;

  const float* corner(std::uint32_t triangle, int i) const {
    return triangles.positions + 3 * std::size_t{triangles.corners[3 * std::size_t{triangle} + i]};
  }
  float middle(std::uint32_t triangle, int axis) const {
    return corner(triangle, 0)[axis] / 3 + corner(triangle, 1)[axis] / 3 +
           corner(triangle, 2)[axis] / 3;
  }

  void build(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
    Box box;
    for (std::uint32_t i = first; i < first + count; ++i) {
      for (int k = 0; k < 3; ++k) box.add(corner(order[i], k));
    }
    nodes[node] = {box, first, count};
    if (count <= 4) return;
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
      if (box.upper[i] - box.lower[i] > box.upper[axis] - box.lower[axis]) axis = i;
    }
    const std::uint32_t half = count / 2;
    std::nth_element(
        order.begin() + first, order.begin() + first + half, order.begin() + first + count,
        [&](std::uint32_t a, std::uint32_t b) { return middle(a, axis) < middle(b, axis); });
    const auto children = static_cast<std::uint32_t>(nodes.size());
    nodes[node].first = children;
    nodes[node].count = 0;
    nodes.resize(nodes.size() + 2);
    build(children, first, half);
    build(children + 1, first + half, count - half);
  }
};

// Slabs (Kay and Kajiya 1986), a little too wide so that rounding loses no box (Ize 2013).
bool meets(const Box& box, const LumeRay& ray, float t_max) {
  float enter = ray.t_min;
  float leave = t_max;
  for (int i = 0; i < 3; ++i) {
    const float inverse = 1.0f / ray.direction[i];
    float first = (box.lower[i] - ray.origin[i]) * inverse;
    float last = (box.upper[i] - ray.origin[i]) * inverse;
    if (first > last) std::swap(first, last);
    // What is not a number (0 * infinity: the ray runs in the slab's plane) changes nothing.
    enter = std::fmax(enter, first);
    leave = std::fmin(leave, last * 1.0000004f);
  }
  return enter <= leave;
}

// Moeller and Trumbore 1997, "Fast, Minimum Storage Ray-Triangle Intersection", in double.
float crossing(const Bvh& bvh, const LumeRay& ray, std::uint32_t triangle) {
  double e1[3], e2[3], s[3], p[3], q[3];
  const float *a = bvh.corner(triangle, 0), *b = bvh.corner(triangle, 1),
              *c = bvh.corner(triangle, 2);
  const double d[3] = {ray.direction[0], ray.direction[1], ray.direction[2]};
  for (int i = 0; i < 3; ++i) {
    e1[i] = double{b[i]} - a[i];
    e2[i] = double{c[i]} - a[i];
    s[i] = double{ray.origin[i]} - a[i];
  }
  const auto cross = [](const double* x, const double* y, double* z) {
    for (int i = 0; i < 3; ++i)
      z[i] = x[(i + 1) % 3] * y[(i + 2) % 3] - x[(i + 2) % 3] * y[(i + 1) % 3];
  };
  const auto dot = [](const double* x, const double* y) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  };
  cross(d, e2, p);
  cross(s, e1, q);
  const double determinant = dot(e1, p);
  const double u = dot(s, p) / determinant;
  const double v = dot(d, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 ? static_cast<float>(dot(e2, q) / determinant) : -1.0f;
}

bool trace(const Bvh& bvh, const LumeRay& ray, bool any, LumeHit& hit) {
  std::uint32_t stack[64] = {0};
  int size = 1;
  bool found = false;
  float t_max = ray.t_max;
  while (size > 0) {
    const Node& node = bvh.nodes[stack[--size]];
    if (!meets(node.box, ray, t_max)) continue;
    if (node.count == 0) {
      stack[size++] = node.first;
      stack[size++] = node.first + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const float t = crossing(bvh, ray, bvh.order[i]);
      const bool nearer = t < t_max || (t == t_max && (!found || bvh.order[i] < hit.triangle));
      if (!(t >= ray.t_min) || !nearer) continue;
      found = true;
      hit = {bvh.order[i], t};
      t_max = t;
      if (any) return true;
    }
  }
  return found;
}

void* build(const LumeTriangles* triangles, char*, std::size_t) {
  auto* bvh = new Bvh{*triangles, {}, std::vector<Node>(1)};
  for (std::uint32_t i = 0; i < triangles->triangle_count; ++i) bvh->order.push_back(i);
  bvh->build(0, 0, triangles->triangle_count);
  return bvh;
}

int closest_hit(const void* structure, const LumeRay* ray, LumeHit* hit) {
  return trace(*static_cast<const Bvh*>(structure), *ray, false, *hit);
}

int any_hit(const void* structure, const LumeRay* ray) {
  LumeHit hit{};
  return trace(*static_cast<const Bvh*>(structure), *ray, true, hit);
}

void destroy(void* structure) { delete static_cast<Bvh*>(structure); }

}  // namespace

extern "C" const LumeAcceleratorPlugin* lume_accelerator_plugin(void) {
  static const LumeAcceleratorPlugin plugin = {
      LUME_ACCELERATOR_PLUGIN_VERSION, "median_bvh", build, closest_hit, any_hit, destroy, nullptr};
  return &plugin;
}
