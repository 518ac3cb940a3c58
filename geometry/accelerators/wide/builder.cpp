// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/wide/builder.h"

#include "geometry/accelerators/wide/collapse.h"
#include "geometry/parallel.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <vector>

namespace lume::geometry::wide {
namespace {

/// The child's number in the whole tree.
std::uint32_t moved(std::uint32_t child, std::size_t nodes_before, std::size_t leaves_before) {
  return child + static_cast<std::uint32_t>(Child::is_leaf(child) ? leaves_before : nodes_before);
}

template <class T>
std::size_t total_size(const std::vector<Part>& parts, std::vector<T> Part::*member) {
  std::size_t size = 0;
  for (const Part& part : parts) size += (part.*member).size();
  return size;
}

/// Parts behind each other; the first is the top, from which the others hang.
Tree join(std::vector<Part>& parts, const std::vector<OpenChild>& open) {
  const std::size_t block_total = total_size(parts, &Part::blocks);
  if (std::max(block_total, total_size(parts, &Part::entries)) >= Child::k_most_first) {
    throw std::runtime_error("wide: more than half a billion triangles in one object");
  }
  Tree tree;
  tree.nodes = HugeArray<Node>(total_size(parts, &Part::nodes));
  tree.blocks = HugeArray<TriangleBlock>(block_total);
  tree.entries = HugeArray<std::uint32_t>(total_size(parts, &Part::entries));
  tree.root = parts[0].root;
  std::size_t node_count = 0;
  std::size_t block_count = 0;
  std::size_t entry_count = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Part& part = parts[i];
    const std::size_t leaves_before = block_count + entry_count;  // one of them is always 0
    for (Node& node : part.nodes) {
      for (std::uint32_t& child : node.child) child = moved(child, node_count, leaves_before);
    }
    if (i > 0) {
      const OpenChild& place = open[i - 1];
      tree.nodes[place.node].child[place.lane] = moved(part.root, node_count, leaves_before);
    }
    std::copy(part.nodes.begin(), part.nodes.end(), tree.nodes.data() + node_count);
    std::copy(part.blocks.begin(), part.blocks.end(), tree.blocks.data() + block_count);
    std::copy(part.entries.begin(), part.entries.end(), tree.entries.data() + entry_count);
    node_count += part.nodes.size();
    block_count += part.blocks.size();
    entry_count += part.entries.size();
    tree.depth = std::max(tree.depth, part.depth + (i > 0 ? open[i - 1].range.depth : 0));
    tree.leaf_count += part.leaf_count;
    tree.reference_count += part.reference_count;
    tree.sah_cost += part.cost;
    part = Part();  // its memory is better given back now than later
  }
  tree.is_empty = false;
  return tree;
}

/// How often each triangle may be cut: those with boxes larger than the average. To
/// cut the others gains nothing and takes most of the time.
void allow_cuts(Range& range) {
  constexpr double k_cuts_of_average = 4.0;
  constexpr double k_most_cuts = 31.0;
  double total = 0.0;
  for (const Reference& reference : range.references()) total += reference.box().half_area();
  if (!(total > 0.0)) return;
  const double scale = k_cuts_of_average * static_cast<double>(range.count) / total;
  for (Reference& reference : range.references()) {
    const double cuts = std::min(reference.box().half_area() * scale, k_most_cuts);
    if (cuts < k_cuts_of_average) continue;
    reference.splits = static_cast<std::uint32_t>(cuts);
    ++range.cuttable;
  }
}

/// Beyond that, 1 / d times a coordinate may be more than a float holds.
bool is_outlier(const Bounds& bounds) {
  constexpr float k_farthest = 1e17f;
  const Vec3 size = glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper));
  return size.x > k_farthest || size.y > k_farthest || size.z > k_farthest;
}

/// The binary tree down to ranges that one thread builds, then those, all at once.
Tree build_parts(const Range& range, const CollapseSource& source, std::size_t leaf_size) {
  constexpr std::size_t k_parts = 64;
  constexpr std::size_t k_least = 1024;
  BinarySource binary{source.triangles, leaf_size, range.box.half_area()};
  std::vector<Part> parts(1);
  std::vector<OpenChild> open;
  const std::size_t part_size = std::max(range.count / k_parts, k_least);
  if (range.count <= part_size) {
    parts[0] = collapse(build_binary(range, binary), source, nullptr);
    return join(parts, open);
  }
  BinarySource top = binary;
  top.leaf_size = part_size;
  parts[0] = collapse(build_binary(range, top), source, &open);
  parts.resize(1 + open.size());
  parallel_for(open.size(), [&](std::size_t i) {
    parts[1 + i] = collapse(build_binary(open[i].range, binary), source, nullptr);
  });
  return join(parts, open);
}

/// What a build starts from.
struct Start {
  std::vector<Reference> references;  ///< with room for cuts behind them
  Range range;
  std::vector<std::uint32_t> outliers;
};

Start make_references(const Items& items, const CollapseSource& source) {
  Start start;
  const double share = source.triangles != nullptr ? source.config.extra_references : 0.0;
  const auto room = static_cast<std::size_t>(share * static_cast<double>(items.size()));
  start.references.reserve(items.size() + room);
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    if (is_outlier(items.bounds(i))) {
      start.outliers.push_back(i);
      continue;
    }
    start.references.push_back(make_reference(items.bounds(i), i));
    const Box box = start.references.back().box();
    start.range.box.add(box);
    start.range.middles.add_point(middle(box));
  }
  start.range.count = start.references.size();
  start.range.room = room;
  start.references.resize(start.range.count + room);
  start.range.begin = start.references.data();
  if (room > 0) allow_cuts(start.range);
  return start;
}

HugeArray<TriangleBlock> make_blocks(const TriangleItems& triangles,
                                     std::span<const std::uint32_t> items) {
  HugeArray<TriangleBlock> blocks((items.size() + TriangleBlock::k_size - 1) /
                                  TriangleBlock::k_size);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::size_t first = i * TriangleBlock::k_size;
    const std::size_t size = std::min(items.size() - first, TriangleBlock::k_size);
    blocks[i] = make_block(triangles, items.subspan(first, size));
  }
  return blocks;
}

Tree build(const Items& items, const CollapseSource& source, std::size_t leaf_size) {
  const Start start = make_references(items, source);
  const Box& box = start.range.box;
  Tree tree;
  if (start.range.count > 0) {
    tree = build_parts(start.range, source, leaf_size);
    const double area = box.half_area();
    tree.sah_cost = area > 0.0 ? tree.sah_cost / area : 0.0;
    const __m128 sign = _mm_set1_ps(-0.0f);
    _mm_store_ps(tree.farthest,
                 _mm_max_ps(_mm_andnot_ps(sign, box.lower), _mm_andnot_ps(sign, box.upper)));
  }
  if (source.triangles != nullptr) tree.outliers = make_blocks(*source.triangles, start.outliers);
  return tree;
}

}  // namespace

Tree build_tree(const TriangleItems& items, const BuildConfig& config) {
  return build(items, {&items, config}, TriangleBlock::k_size);
}

Tree build_tree(const PlacementItems& items) { return build(items, {}, 1); }

}  // namespace lume::geometry::wide
