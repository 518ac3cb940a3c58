// SPDX-License-Identifier: Apache-2.0
// Sixteen rays at once, for rays that run much alike: a node's boxes are first tested against all
// of them together by interval arithmetic (Boulos, Wald and Shirley 2006, "Geometric and Arithmetic
// Culling Methods for Entire Ray Packets"), then the few that remain ray by ray in SIMD. The same
// numbers as in kernel.h, so the same answers.
#pragma once

#include "geometry/accelerators/wide/kernel.h"
#include "geometry/accelerators/wide/packet_rays.h"

namespace lume::geometry::wide {

/// A mask of the children that any ray of the packet may meet, and where the first enters.
template <class Simd>
[[gnu::always_inline]] inline unsigned enter_together(const Node& node, const Packet<Simd>& packet,
                                                      float last, float (&entries)[k_width]) {
  using Float8 = typename Simd::Float8;
  Float8 first = Simd::fill(packet.first);
  Float8 end = Simd::fill(last);
  for (unsigned axis = 0; axis < 3; ++axis) {
    const Float8 near = Simd::load(node.planes[packet.near_row[axis]]);
    const Float8 far = Simd::load(node.planes[packet.near_row[axis] ^ 1u]);
    const Float8 least = Simd::min(Simd::mul(near, packet.least_inverse[axis]),
                                   Simd::mul(near, packet.most_inverse[axis]));
    const Float8 most = Simd::max(Simd::mul(far, packet.least_inverse[axis]),
                                  Simd::mul(far, packet.most_inverse[axis]));
    first = Simd::max(first, Simd::add(least, packet.least_near[axis]));
    end = Simd::min(end, Simd::add(most, packet.most_far[axis]));
  }
  Simd::store(entries, first);
  return Simd::not_above(first, end);
}

/// A mask of the rays that meet a child's box.
template <class Simd>
[[gnu::always_inline]] inline unsigned rays_that_enter(const Node& node, unsigned lane,
                                                       const Packet<Simd>& packet) {
  using Many = typename Simd::ManyFloats;
  unsigned mask = 0;
  for (unsigned from = 0; from < k_packet_size; from += Many::k_size) {
    auto first = Many::load(packet.t_min + from);
    auto end = Many::load(packet.t_max + from);
    for (unsigned axis = 0; axis < 3; ++axis) {
      const auto inverse = Many::load(packet.inverse[axis] + from);
      const auto near = Many::fill(node.planes[packet.near_row[axis]][lane]);
      const auto far = Many::fill(node.planes[packet.near_row[axis] ^ 1u][lane]);
      first =
          Many::max(first, Many::fma(near, inverse, Many::load(packet.near_offset[axis] + from)));
      end = Many::min(end, Many::fma(far, inverse, Many::load(packet.far_offset[axis] + from)));
    }
    mask |= Many::not_above(first, end) << from;
  }
  return mask;
}

/// The crossings of some rays of a packet with one triangle: BlockCrossing with the roles changed.
template <class Simd>
struct RaysCrossing {
  using Many = typename Simd::ManyDoubles;
  using Doubles = decltype(Many::set(0.0));

  [[gnu::always_inline]] RaysCrossing(const Packet<Simd>& packet, unsigned from,
                                      const TriangleBlock& block, unsigned lane) {
    const Doubles shear_x = Many::load(packet.shear_x + from);
    const Doubles shear_y = Many::load(packet.shear_y + from);
    const Doubles ox = Many::load(packet.origin[packet.axis[0]] + from);
    const Doubles oy = Many::load(packet.origin[packet.axis[1]] + from);
    const Doubles oz = Many::load(packet.origin[packet.axis[2]] + from);
    Doubles x[3];
    Doubles y[3];
    for (unsigned i = 0; i < 3; ++i) {
      const auto corner = [&](unsigned axis) {
        return Many::set(static_cast<double>(block.corner[i][packet.axis[axis]][lane]));
      };
      z[i] = Many::sub(corner(2), oz);
      x[i] = Many::sub(Many::sub(corner(0), ox), Many::mul(shear_x, z[i]));
      y[i] = Many::sub(Many::sub(corner(1), oy), Many::mul(shear_y, z[i]));
    }
    weight[0] = Many::sub(Many::mul(x[2], y[1]), Many::mul(y[2], x[1]));
    weight[1] = Many::sub(Many::mul(x[0], y[2]), Many::mul(y[0], x[2]));
    weight[2] = Many::sub(Many::mul(x[1], y[0]), Many::mul(y[1], x[0]));
    sum = Many::add(Many::add(weight[0], weight[1]), weight[2]);
    mask = Many::same_sign(weight[0], weight[1], weight[2]) & Many::not_zero(sum);
  }

  [[nodiscard, gnu::always_inline]] Doubles t(const Packet<Simd>& packet, unsigned from) const {
    const Doubles weighted =
        Many::add(Many::add(Many::mul(weight[0], z[0]), Many::mul(weight[1], z[1])),
                  Many::mul(weight[2], z[2]));
    return Many::div(weighted, Many::mul(sum, Many::load(packet.length_z + from)));
  }

  Doubles weight[3];
  Doubles z[3];
  Doubles sum;
  unsigned mask;
};

/// Calls take(ray, t, item) for the rays whose lines pass through triangles of a block.
template <class Simd, class Take>
[[gnu::always_inline]] inline void cross_block(const Packet<Simd>& packet, unsigned rays,
                                               const TriangleBlock& block, const Take& take) {
  using Many = typename Simd::ManyDoubles;
  // So few are better tested one by one, against four triangles at a time.
  constexpr int k_few_rays = static_cast<int>(Many::k_size) / 2 + 1;
  if (std::popcount(rays) <= k_few_rays) {
    for (; rays != 0; rays &= rays - 1) {
      const auto ray = static_cast<unsigned>(std::countr_zero(rays));
      const ShearRay shear = packet.alone(ray);
      const BlockCrossing<Simd> crossing(shear, block);
      if (crossing.mask == 0) continue;
      alignas(32) double t[TriangleBlock::k_size];
      Simd::store(t, crossing.t(shear));
      for (unsigned mask = crossing.mask; mask != 0; mask &= mask - 1) {
        const auto lane = static_cast<unsigned>(std::countr_zero(mask));
        take(ray, t[lane], block.item[lane]);
      }
    }
    return;
  }
  for (unsigned lane = 0; lane < TriangleBlock::k_size; ++lane) {
    for (unsigned from = 0; from < k_packet_size; from += Many::k_size) {
      const unsigned wanted = rays >> from & ((1u << Many::k_size) - 1);
      if (wanted == 0) continue;
      const RaysCrossing<Simd> crossing(packet, from, block, lane);
      unsigned mask = crossing.mask & wanted;
      if (mask == 0) continue;
      alignas(64) double t[Many::k_size];
      Many::store(t, crossing.t(packet, from));
      for (; mask != 0; mask &= mask - 1) {
        const auto i = static_cast<unsigned>(std::countr_zero(mask));
        take(from + i, t[i], block.item[lane]);
      }
    }
  }
}

struct PacketEntry {
  StackEntry place;    ///< the least t, and the child
  std::uint32_t rays;  ///< that meet its box
};

/// Calls visit(first, count, rays) for the leaves that rays of the packet meet, the nearest first.
/// visit may lower packet.t_max, and returns the rays that are still looking.
template <class Simd, class Visit>
[[gnu::always_inline]] inline void traverse_packet(const Tree& tree, Packet<Simd>& packet,
                                                   unsigned rays, const Visit& visit) {
  if (tree.is_empty) return;
  PacketEntry stack_bottom[k_stack_size];
  PacketEntry* stack = stack_bottom;
  *stack++ = {stack_entry(0.0f, tree.root), rays};
  float last = packet.last();
  while (stack != stack_bottom) {
    const PacketEntry entry = *--stack;
    const unsigned active = entry.rays & rays;
    if (active == 0 || entry_t(entry.place) > last) continue;
    const std::uint32_t child = entry_child(entry.place);
    if (Child::is_leaf(child)) {
      rays = visit(Child::first(child), Child::count(child), active);
      if (rays == 0) return;
      last = packet.last();
      continue;
    }
    const Node& node = tree.nodes[child];
    alignas(32) float enter[k_width];
    PacketEntry* const bottom = stack;
    for (unsigned mask = enter_together(node, packet, last, enter); mask != 0; mask &= mask - 1) {
      const auto lane = static_cast<unsigned>(std::countr_zero(mask));
      const unsigned entering = rays_that_enter(node, lane, packet) & active;
      if (entering == 0) continue;
      prefetch(tree, node.child[lane]);
      const PacketEntry added{stack_entry(enter[lane], node.child[lane]), entering};
      PacketEntry* place = stack++;
      for (; place > bottom && place[-1].place < added.place; --place) *place = place[-1];
      *place = added;
    }
  }
}

template <class Simd>
void find_closest_of_packet(const Tree& tree, TriangleQuery* queries, unsigned count) {
  if (tree.outliers.size() > 0 || !run_alike(queries, count)) {
    for (unsigned i = 0; i < count; ++i) find_closest<Simd, Mode<false, false>>(tree, queries[i]);
    return;
  }
  Packet<Simd> packet;
  fill_packet(tree, queries, count, packet);
  const unsigned all = (1u << count) - 1;
  const auto take = [&](unsigned ray, double t, std::uint32_t item) {
    TriangleQuery& query = queries[ray];
    const bool nearer = t < query.ray.t_max || (t == query.ray.t_max && item < query.item_limit);
    if (!nearer || !(t >= query.ray.t_min)) return;
    query.item = query.item_limit = item;
    query.ray.t_max = t;
    packet.set_t_max(ray, t);
  };
  traverse_packet(tree, packet, all, [&](std::uint32_t first, std::uint32_t blocks, unsigned rays) {
    for (std::uint32_t i = first; i < first + blocks; ++i) {
      cross_block(packet, rays, tree.blocks[i], take);
    }
    return all;
  });
}

template <class Simd>
unsigned find_any_of_packet(const Tree& tree, TriangleQuery* queries, unsigned count) {
  unsigned met = 0;
  if (tree.outliers.size() > 0 || !run_alike(queries, count)) {
    for (unsigned i = 0; i < count; ++i) {
      met |= find_any<Simd, Mode<false, false>>(tree, queries[i]) ? 1u << i : 0u;
    }
    return met;
  }
  Packet<Simd> packet;
  fill_packet(tree, queries, count, packet);
  const unsigned all = (1u << count) - 1;
  const auto take = [&](unsigned ray, double t, std::uint32_t) {
    if (!(t >= queries[ray].ray.t_min && t <= queries[ray].ray.t_max)) return;
    met |= 1u << ray;
    packet.t_max[ray] = -1.0f;  // looks no further
  };
  traverse_packet(tree, packet, all, [&](std::uint32_t first, std::uint32_t blocks, unsigned rays) {
    for (std::uint32_t i = first; i < first + blocks && (rays & ~met) != 0; ++i) {
      cross_block(packet, rays & ~met, tree.blocks[i], take);
    }
    return all & ~met;
  });
  return met;
}

}  // namespace lume::geometry::wide
