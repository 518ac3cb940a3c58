// SPDX-License-Identifier: Apache-2.0
// The fast one: a watertight hierarchy of eight children a node under kernels for each instruction
// set, behind the Accelerator interface.
#include "geometry/accelerators/nearest_hit.h"
#include "geometry/accelerators/registry.h"
#include "geometry/accelerators/wide/builder.h"
#include "geometry/accelerators/wide/query.h"
#include "geometry/accelerators/wide/triangle_tree.h"
#include "geometry/refine.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <vector>

namespace lume::geometry {
namespace {

using wide::SceneQuery;
using wide::TreeRay;
using wide::TriangleQuery;
using wide::TriangleTree;

TreeRay tree_ray(const ObjectRay& ray) {
  return {{ray.origin.x, ray.origin.y, ray.origin.z},
          {ray.direction.x, ray.direction.y, ray.direction.z},
          ray.t_min,
          ray.t_max};
}

TreeRay tree_ray(const Ray& ray) {
  return {{ray.origin.x, ray.origin.y, ray.origin.z},
          {ray.direction.x, ray.direction.y, ray.direction.z},
          ray.t_min,
          ray.t_max};
}

bool has_holes(const Object& object) {
  return std::any_of(object.geometries.begin(), object.geometries.end(),
                     [](const Geometry& g) { return g.has_holes && g.mesh() != nullptr; });
}

void add(const wide::Tree& tree, StructureStats& stats) {
  StructureStats own;
  own.nodes = tree.nodes.size();
  own.leaves = tree.leaf_count;
  own.depth = tree.depth;
  own.references = tree.reference_count;
  own.sah_cost = tree.sah_cost;
  own.memory_bytes = tree.nodes.memory_bytes() + tree.blocks.memory_bytes() +
                     tree.entries.memory_bytes() + tree.outliers.memory_bytes();
  stats += own;
}

class Wide final : public Accelerator {
 public:
  Wide(const World& world, const HoleTest* holes)
      : world_(world), holes_(holes), kernel_(wide::best_kernel()) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<bool> is_merged = merge_unmoved();
    build_objects(is_merged);
    tree_ = wide::build_tree(*placements_);
    has_placements_ = placements_->size() + placements_->endless().size() > 0;
    takes_packets_ = holes == nullptr || !merged_->has_holes();
    build_seconds_ =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  std::optional<Hit> closest_hit(const Ray& ray) const override { return closest(ray, nullptr); }
  bool any_hit(const Ray& ray) const override { return any(ray, nullptr); }
  [[nodiscard]] bool counts_cost() const override { return true; }
  std::optional<Hit> closest_hit_counted(const Ray& ray, TraversalCost& cost) const override {
    return closest(ray, &cost);
  }
  bool any_hit_counted(const Ray& ray, TraversalCost& cost) const override {
    return any(ray, &cost);
  }

  void closest_hits(std::span<const Ray> rays, std::span<std::optional<Hit>> hits) const override {
    if (!takes_packets_) return Accelerator::closest_hits(rays, hits);
    std::fill(hits.begin(), hits.end(), std::nullopt);
    const Candidates candidates{this, &*merged_, std::nullopt};
    in_packets(rays, [&](std::span<TriangleQuery> queries, std::span<const std::size_t> places) {
      kernel_.closest_of_packet(merged_->tree(), queries.data(),
                                static_cast<unsigned>(queries.size()));
      for (std::size_t i = 0; i < queries.size(); ++i) {
        const Ray& ray = rays[places[i]];
        Search search{this, &ray, nullptr};
        if (queries[i].item != wide::k_no_item) {
          search.nearest = {candidates.identity(queries[i].item), queries[i].ray.t_max};
        }
        if (has_placements_) search_placements(search);
        hits[places[i]] = search.nearest.hit;
      }
    });
  }

  void any_hits(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const override {
    if (!takes_packets_) return Accelerator::any_hits(rays, occluded);
    std::fill(occluded.begin(), occluded.end(), std::uint8_t{0});
    in_packets(rays, [&](std::span<TriangleQuery> queries, std::span<const std::size_t> places) {
      const unsigned met = kernel_.any_of_packet(merged_->tree(), queries.data(),
                                                 static_cast<unsigned>(queries.size()));
      for (std::size_t i = 0; i < queries.size(); ++i) {
        const bool is_met = (met >> i & 1u) != 0;
        occluded[places[i]] =
            is_met || (has_placements_ && meets_any_placement(rays[places[i]], nullptr));
      }
    });
  }

  AcceleratorStats stats() const override {
    AcceleratorStats stats(world_);
    stats.build_seconds = build_seconds_;
    add(merged_->tree(), stats.structure);
    for (const TriangleTree& object : objects_) add(object.tree(), stats.structure);
    add(tree_, stats.structure);
    stats.memory_bytes = stats.structure.memory_bytes;
    return stats;
  }

 private:
  /// A query on its way through the scene.
  struct Search {
    const Wide* self;
    const Ray* ray;
    TraversalCost* cost;
    NearestHit nearest = {};
  };

  /// Triangles to be asked: those of an instance, or the merged ones, which know theirs.
  struct Candidates {
    const Wide* self;
    const TriangleTree* triangles;
    std::optional<std::uint32_t> instance;

    [[nodiscard]] Hit identity(std::uint32_t item) const {
      Hit hit = triangles->identity(item);
      if (instance) hit.instance = *instance;
      return hit;
    }
    /// The first item whose identity is above that of `hit`, which is none of them.
    [[nodiscard]] std::uint32_t first_above(Hit hit) const {
      if (instance && hit.instance != *instance) {
        return hit.instance < *instance ? 0 : wide::k_no_item;
      }
      if (instance) hit.instance = 0;
      return triangles->first_above(hit);
    }
  };

  /// Puts what stands unmoved into one tree; says of which objects there is nothing left to build.
  std::vector<bool> merge_unmoved() {
    const std::vector<std::uint32_t> unmoved = unmoved_instances(world_);
    std::vector<bool> is_merged(world_.objects.size());
    bool any_holes = false;
    for (const std::uint32_t i : unmoved) {
      const std::uint32_t object = world_.instances[i].object;
      is_merged[object] = true;
      any_holes |= has_holes(world_.objects[object]);
    }
    merged_.emplace(TriangleItems(world_, unmoved), any_holes);
    return is_merged;
  }

  void build_objects(const std::vector<bool>& is_merged) {
    const Object none;
    std::vector<Bounds> of_triangles;
    of_triangles.reserve(world_.objects.size());
    objects_.reserve(world_.objects.size());
    for (std::size_t i = 0; i < world_.objects.size(); ++i) {
      const Object& object = is_merged[i] ? none : world_.objects[i];
      objects_.emplace_back(TriangleItems(object), has_holes(object));
      of_triangles.push_back(objects_.back().bounds());
    }
    placements_.emplace(world_, of_triangles);
  }

  /// Calls trace(queries, their rays' numbers) for all rays that can be traced, in packets.
  template <class Trace>
  static void in_packets(std::span<const Ray> rays, const Trace& trace) {
    std::array<TriangleQuery, wide::k_packet_size> queries;
    std::array<std::size_t, wide::k_packet_size> places{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (is_asked(rays[i])) {
        queries[count] = TriangleQuery();
        queries[count].ray = tree_ray(rays[i]);
        places[count++] = i;
      }
      if (count < queries.size() && i + 1 < rays.size()) continue;
      if (count > 0) trace({queries.data(), count}, {places.data(), count});
      count = 0;
    }
  }

  static bool is_asked(const Ray& ray) { return is_traceable(ray) && ray.direction != Vec3(0.0f); }

  std::optional<Hit> closest(const Ray& ray, TraversalCost* cost) const {
    if (!is_asked(ray)) return std::nullopt;
    Search search{this, &ray, cost};
    take_triangle(tree_ray(ray), {this, &*merged_, std::nullopt}, search);
    if (has_placements_) search_placements(search);
    return search.nearest.hit;
  }

  void search_placements(Search& search) const {
    SceneQuery query = scene_query<&Wide::take_placement>(search);
    if (search.nearest.hit) query.ray.t_max = search.nearest.t;
    for (const Placement& placement : placements_->endless()) take_placement(placement, query);
    kernel_.scene(tree_, query);
  }

  bool any(const Ray& ray, TraversalCost* cost) const {
    if (!is_asked(ray)) return false;
    if (meets_triangle(tree_ray(ray), {this, &*merged_, std::nullopt}, cost)) return true;
    return has_placements_ && meets_any_placement(ray, cost);
  }

  [[nodiscard]] bool meets_any_placement(const Ray& ray, TraversalCost* cost) const {
    Search search{this, &ray, cost};
    SceneQuery query = scene_query<&Wide::meets_placement>(search);
    for (const Placement& placement : placements_->endless()) {
      if (meets_placement(placement, query)) return true;
    }
    return kernel_.scene(tree_, query);
  }

  /// `search` must live as long as the query.
  template <bool (Wide::*visit)(const Placement&, SceneQuery&) const>
  static SceneQuery scene_query(Search& search) {
    SceneQuery query;
    query.ray = tree_ray(*search.ray);
    query.visit = [](SceneQuery& q, std::uint32_t i) {
      const Wide& self = *search_of(q).self;
      return (self.*visit)(self.placements_->placement(i), q);
    };
    query.context = &search;
    query.cost = search.cost;
    return query;
  }
  static Search& search_of(const SceneQuery& query) { return *static_cast<Search*>(query.context); }

  /// The scene's ray, as far as it still goes, in the space of the placement.
  [[nodiscard]] ObjectRay ray_in(const Placement& placement, const SceneQuery& query) const {
    ObjectRay ray =
        to_object(world_.instances[placement.instance].transform, *search_of(query).ray);
    ray.t_max = query.ray.t_max;
    return ray;
  }
  [[nodiscard]] Candidates candidates_of(const Placement& placement) const {
    return {this, &objects_[world_.instances[placement.instance].object], placement.instance};
  }

  /// Takes what is nearer than all before. Never ends the search.
  bool take_placement(const Placement& placement, SceneQuery& query) const {
    Search& search = search_of(query);
    const ObjectRay ray = ray_in(placement, query);
    if (placement.shape) {
      take_shape(ray, {placement.instance, *placement.shape, 0}, search);
    } else {
      take_triangle(tree_ray(ray), candidates_of(placement), search);
    }
    if (search.nearest.hit) query.ray.t_max = search.nearest.t;
    return false;
  }

  void take_shape(const ObjectRay& ray, Hit hit, Search& search) const {
    if (search.cost != nullptr) search.cost->add_test();
    const auto crossing = first_crossing(world_.geometry(hit), ray, hit, holes_);
    if (!crossing) return;
    hit.primitive = crossing->part;
    if (search.nearest.yields_to(hit, crossing->t)) search.nearest = {hit, crossing->t};
  }

  void take_triangle(const TreeRay& ray, const Candidates& candidates, Search& search) const {
    TriangleQuery query = triangle_query(ray, candidates, search.cost);
    if (search.nearest.hit) query.item_limit = candidates.first_above(*search.nearest.hit);
    kernel_.closest(candidates.triangles->tree(), query);
    if (query.item == wide::k_no_item) return;
    search.nearest = {candidates.identity(query.item), query.ray.t_max};
  }

  bool meets_placement(const Placement& placement, SceneQuery& query) const {
    const ObjectRay ray = ray_in(placement, query);
    if (!placement.shape)
      return meets_triangle(tree_ray(ray), candidates_of(placement), query.cost);
    if (query.cost != nullptr) query.cost->add_test();
    const Hit hit{placement.instance, *placement.shape, 0};
    return first_crossing(world_.geometry(hit), ray, hit, holes_).has_value();
  }

  [[nodiscard]] bool meets_triangle(const TreeRay& ray, const Candidates& candidates,
                                    TraversalCost* cost) const {
    TriangleQuery query = triangle_query(ray, candidates, cost);
    return kernel_.any(candidates.triangles->tree(), query);
  }

  /// `candidates` must live as long as the query.
  [[nodiscard]] TriangleQuery triangle_query(const TreeRay& ray, const Candidates& candidates,
                                             TraversalCost* cost) const {
    TriangleQuery query;
    query.ray = ray;
    query.cost = cost;
    if (holes_ != nullptr && candidates.triangles->has_holes()) {
      query.holes = {is_hole, &candidates};
    }
    return query;
  }

  static bool is_hole(const void* context, std::uint32_t item, double u, double v) {
    const auto& candidates = *static_cast<const Candidates*>(context);
    const Wide& self = *candidates.self;
    const Hit hit = candidates.identity(item);
    return self.world_.geometry(hit).has_holes &&
           self.holes_->is_hole(hit, {static_cast<float>(u), static_cast<float>(v)});
  }

  const World& world_;
  const HoleTest* holes_;
  const wide::Kernel& kernel_;
  std::optional<TriangleTree> merged_;
  std::vector<TriangleTree> objects_;
  std::optional<PlacementItems> placements_;
  wide::Tree tree_;
  bool has_placements_ = false;
  bool takes_packets_ = false;  ///< of what is merged; holes are asked ray by ray
  double build_seconds_ = 0.0;
};

}  // namespace

std::unique_ptr<Accelerator> make_wide(const World& world, const HoleTest* holes,
                                       const AcceleratorOptions& /*options*/) {
  return std::make_unique<Wide>(world, holes);
}

}  // namespace lume::geometry
