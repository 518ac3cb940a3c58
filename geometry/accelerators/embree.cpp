// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/embree.h"

#include "geometry/accelerators/embree_callbacks.h"
#include "geometry/accelerators/embree_rays.h"
#include "geometry/accelerators/items.h"
#include "geometry/accelerators/registry.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace lume::geometry {
namespace {

enum class Quality {
  robust,  ///< no ray slips between triangles that share an edge; one in six does otherwise
  high     ///< the best tree that Embree builds, which it does not combine with the former
};

class Embree final : public Accelerator {
 public:
  Embree(const World& world, const HoleTest* holes, Quality quality, bool native_hits)
      : world_(world), holes_(holes), quality_(quality), native_hits_(native_hits) {
    if (!native_hits) referee_ = make_brute_force(world, holes, {});
    const auto start = std::chrono::steady_clock::now();
    device_ = rtcNewDevice(std::getenv("LUME_EMBREE_CONFIG"));
    if (device_ == nullptr) throw std::runtime_error("Embree cannot start: " + last_error());
    rtcSetDeviceMemoryMonitorFunction(device_, count_memory, this);
    try {
      build();
    } catch (...) {
      release();
      throw;
    }
    build_seconds_ =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  ~Embree() override { release(); }

  std::optional<Hit> closest_hit(const Ray& ray) const override {
    if (!is_traceable(ray)) return std::nullopt;
    EmbreeQuery context = make_context(ray);
    for (const PlacedShape& shape : asked_first_) take_if_nearest(context, shape, ray.t_max);
    if (is_empty_) return context.nearest;
    RTCRayHit query{to_embree(ray), {}};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    if (context.nearest) query.ray.tfar = nearest_tfar(context);
    rtcIntersect1(scene_, &context.embree, &query);
    if (context.doubt_t < context.nearest_t) return referee_->closest_hit(ray);
    if (!native_hits_ || query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return context.nearest;
    return context.identity(query.hit);
  }

  bool any_hit(const Ray& ray) const override {
    if (!is_traceable(ray)) return false;
    EmbreeQuery context = make_context(ray);
    for (const PlacedShape& shape : asked_first_) {
      if (is_occluded(context, shape)) return true;
    }
    if (is_empty_) return false;
    RTCRay query = to_embree(ray);
    rtcOccluded1(scene_, &context.embree, &query);
    if (query.tfar < 0.0f) return true;  // Embree's sign for "occluded"
    return std::isfinite(context.doubt_t) && referee_->any_hit(ray);
  }

  void closest_hits(std::span<const Ray> rays, std::span<std::optional<Hit>> hits) const override {
    if (!takes_packets_) return Accelerator::closest_hits(rays, hits);
    for (std::size_t first = 0; first < rays.size(); first += k_embree_packet) {
      const std::size_t count = std::min(k_embree_packet, rays.size() - first);
      EmbreeQuery context = make_packet_context(true);
      RTCRayHit16 packet{};
      alignas(64) int valid[k_embree_packet];
      fill_packet(rays.subspan(first, count), packet.ray, valid);
      std::fill_n(packet.hit.geomID, k_embree_packet, RTC_INVALID_GEOMETRY_ID);
      rtcIntersect16(valid, scene_, &context.embree, &packet);
      for (std::size_t i = 0; i < count; ++i) {
        RTCHit hit{};
        hit.instID[0] = packet.hit.instID[0][i];
        hit.geomID = packet.hit.geomID[i];
        hit.primID = packet.hit.primID[i];
        const bool is_hit = hit.geomID != RTC_INVALID_GEOMETRY_ID;
        hits[first + i] = is_hit ? std::optional(context.identity(hit)) : std::nullopt;
      }
    }
  }

  void any_hits(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const override {
    if (!takes_packets_) return Accelerator::any_hits(rays, occluded);
    for (std::size_t first = 0; first < rays.size(); first += k_embree_packet) {
      const std::size_t count = std::min(k_embree_packet, rays.size() - first);
      // Rays of several octants that are occluded at different times can keep Embree 3.13.5 in its
      // coherent traversal for ever.
      const auto part = rays.subspan(first, count);
      EmbreeQuery context = make_packet_context(is_of_one_octant(part));
      RTCRay16 packet{};
      alignas(64) int valid[k_embree_packet];
      fill_packet(part, packet, valid);
      rtcOccluded16(valid, scene_, &context.embree, &packet);
      for (std::size_t i = 0; i < count; ++i) {
        occluded[first + i] = valid[i] != 0 && packet.tfar[i] < 0.0f ? 1 : 0;
      }
    }
  }

  AcceleratorStats stats() const override {
    AcceleratorStats stats(world_);
    stats.build_seconds = build_seconds_;
    stats.memory_bytes = static_cast<std::size_t>(memory_bytes_.load());
    return stats;
  }

 private:
  [[nodiscard]] EmbreeQuery make_context(const Ray& ray) const {
    EmbreeQuery context;
    context.ray = &ray;
    context.world = &world_;
    context.holes = holes_;
    context.merged = &merged_;
    rtcInitIntersectContext(&context.embree);
    return context;
  }

  /// For packets, which none of our functions is called for.
  [[nodiscard]] EmbreeQuery make_packet_context(bool coherent) const {
    EmbreeQuery context;
    context.merged = &merged_;
    rtcInitIntersectContext(&context.embree);
    context.embree.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return context;
  }

  [[nodiscard]] RTCScene new_scene() const {
    RTCScene scene = rtcNewScene(device_);
    const bool robust = quality_ == Quality::robust;
    rtcSetSceneFlags(scene, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(scene, robust ? RTC_BUILD_QUALITY_MEDIUM : RTC_BUILD_QUALITY_HIGH);
    return scene;
  }

  void build() {
    scene_ = new_scene();
    const std::vector<bool> is_merged = merge_unmoved();
    for (std::size_t i = 0; i < world_.objects.size(); ++i) {
      object_scenes_.push_back(is_merged[i] ? nullptr : build_object(world_.objects[i]));
    }
    for (std::uint32_t i = 0; i < world_.instances.size(); ++i) place(i);
    ask_few_first();
    takes_packets_ = native_hits_ && !has_filters_ && placed_.empty() && asked_first_.empty();
    attach_shapes();
    commit(scene_);
  }

  /// Meshes that need no instance become part of the scene itself. Says of which objects.
  std::vector<bool> merge_unmoved() {
    std::vector<bool> is_merged(world_.objects.size());
    // Instances have the numbers that they have in the world; all shapes together are the next.
    merged_.first_id = static_cast<unsigned>(world_.instances.size()) + 1;
    for (const std::uint32_t i : unmoved_instances(world_)) {
      const std::uint32_t object = world_.instances[i].object;
      is_merged[object] = true;
      const std::vector<Geometry>& geometries = world_.objects[object].geometries;
      for (std::uint32_t g = 0; g < geometries.size(); ++g) {
        if (geometries[g].mesh() == nullptr) continue;
        const auto id = merged_.first_id + static_cast<unsigned>(merged_.meshes.size());
        merged_.meshes.emplace_back(i, g);
        attach_mesh(scene_, geometries[g], id);
        is_empty_ = false;
      }
    }
    return is_merged;
  }

  /// The hierarchy over an object's triangles, if it has any.
  [[nodiscard]] RTCScene build_object(const Object& object) {
    RTCScene scene = nullptr;
    for (std::uint32_t i = 0; i < object.geometries.size(); ++i) {
      if (object.geometries[i].mesh() == nullptr) continue;
      if (scene == nullptr) scene = new_scene();
      attach_mesh(scene, object.geometries[i], i);
    }
    if (scene != nullptr) commit(scene);
    return scene;
  }

  /// False for what Embree would silently leave out.
  static bool fits(const Bounds& bounds) {
    constexpr float k_largest = 1e17f;
    return bounds.is_finite() && glm::all(glm::lessThan(glm::abs(bounds.lower), Vec3(k_largest))) &&
           glm::all(glm::lessThan(glm::abs(bounds.upper), Vec3(k_largest)));
  }

  /// Triangles are met in their object's space, shapes in the scene's: there each has the tightest
  /// bounds, and no ray is rounded on its way to it. A shape of many parts has a hierarchy of its
  /// own inside, which its instances share.
  void place(std::uint32_t index) {
    const Instance& instance = world_.instances[index];
    if (object_scenes_[instance.object] != nullptr) attach_instance(instance, index);
    const std::vector<Geometry>& geometries = world_.objects[instance.object].geometries;
    for (std::uint32_t i = 0; i < geometries.size(); ++i) {
      const Shape* shape = geometries[i].shape();
      if (shape == nullptr) continue;
      const bool has_place = fits(shape_bounds(*shape, instance.transform));
      (has_place ? placed_ : asked_first_)
          .push_back({{index, i, 0}, &geometries[i], &instance.transform});
    }
  }

  /// A handful of simple shapes is faster met one by one than sorted.
  void ask_few_first() {
    constexpr std::size_t k_few = 4;
    if (placed_.size() > k_few || !std::all_of(placed_.begin(), placed_.end(), is_simple)) return;
    asked_first_.insert(asked_first_.end(), placed_.begin(), placed_.end());
    placed_.clear();
  }

  static bool is_simple(const PlacedShape& placed) {
    const Shape& shape = *placed.geometry->shape();
    return std::holds_alternative<Plane>(shape) || std::holds_alternative<Disk>(shape) ||
           std::holds_alternative<Box>(shape) || std::holds_alternative<Sphere>(shape);
  }

  void attach_shapes() {
    if (placed_.empty()) return;
    is_empty_ = false;
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(placed_.size()));
    rtcSetGeometryUserData(geometry, &placed_);
    rtcSetGeometryBoundsFunction(geometry, bound_shape, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_shape);
    rtcSetGeometryOccludedFunction(geometry, occlude_shape);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, static_cast<unsigned>(world_.instances.size()));
    rtcReleaseGeometry(geometry);
  }

  void attach_mesh(RTCScene scene, const Geometry& source, std::uint32_t id) {
    const Mesh& mesh = *source.mesh();
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    // Embree's own buffers and not ours, since it reads 16 bytes at the last vertex.
    copy_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions);
    copy_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
    if (!native_hits_) {
      rtcSetGeometryIntersectFilterFunction(geometry, take_if_exact);
      rtcSetGeometryOccludedFilterFunction(geometry, stop_if_exact);
      has_filters_ = true;
    } else if (source.has_holes && holes_ != nullptr) {
      has_filters_ = true;
      rtcSetGeometryIntersectFilterFunction(geometry, reject_holes);
      rtcSetGeometryOccludedFilterFunction(geometry, reject_holes);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
  }

  template <class T>
  void copy_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                   const std::vector<T>& values) const {
    if (values.empty()) return;
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), values.size());
    if (buffer == nullptr) throw std::runtime_error("Embree: " + last_error());
    std::memcpy(buffer, values.data(), values.size() * sizeof(T));
  }

  void attach_instance(const Instance& instance, std::uint32_t id) {
    is_empty_ = false;
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, object_scenes_[instance.object]);
    const Mat3 linear(instance.transform.linear());
    const Vec3 translation(instance.transform.translation());
    const Vec3 columns[4] = {linear[0], linear[1], linear[2], translation};
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, id);
    rtcReleaseGeometry(geometry);
  }

  void commit(RTCScene scene) const {
    // On as many threads as ThreadLimit allows, to the same tree for any number.
    rtcCommitScene(scene);
    const RTCError error = rtcGetDeviceError(device_);
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::runtime_error("Embree is out of memory");
    if (error != RTC_ERROR_NONE) {
      throw std::runtime_error("Embree cannot build: error " + std::to_string(error));
    }
  }

  [[nodiscard]] std::string last_error() const {
    return "error " + std::to_string(rtcGetDeviceError(device_));
  }

  static bool count_memory(void* self, ssize_t bytes, bool /*post*/) {
    static_cast<Embree*>(self)->memory_bytes_ += bytes;
    return true;
  }

  void release() {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    for (RTCScene scene : object_scenes_) {
      if (scene != nullptr) rtcReleaseScene(scene);
    }
    if (device_ != nullptr) rtcReleaseDevice(device_);
  }

  const World& world_;
  const HoleTest* holes_;
  Quality quality_;
  bool native_hits_;
  std::unique_ptr<Accelerator> referee_;  ///< for the few rays that Embree cannot decide on
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  std::vector<RTCScene> object_scenes_;  ///< by object; null if it has no triangles, or is merged
  MergedMeshes merged_;
  bool has_filters_ = false;
  bool takes_packets_ = false;  ///< nothing calls back, where only single rays are understood
  PlacedShapes placed_;
  PlacedShapes asked_first_;  ///< shapes that no hierarchy can hold, or that need none
  bool is_empty_ = true;      ///< the hierarchy, which then is not asked
  std::atomic<ssize_t> memory_bytes_ = 0;
  double build_seconds_ = 0.0;
};

}  // namespace

std::unique_ptr<Accelerator> make_embree(const World& world, const HoleTest* holes,
                                         const AcceleratorOptions& options) {
  return std::make_unique<Embree>(world, holes, Quality::robust, options.native_hits);
}

std::unique_ptr<Accelerator> make_embree_high(const World& world, const HoleTest* holes,
                                              const AcceleratorOptions& options) {
  return std::make_unique<Embree>(world, holes, Quality::high, options.native_hits);
}

std::string embree_version() {
  RTCDevice device = rtcNewDevice(nullptr);
  if (device == nullptr) return "not available";
  const auto part = [device](RTCDeviceProperty property) {
    return std::to_string(rtcGetDeviceProperty(device, property));
  };
  std::string version = part(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + "." +
                        part(RTC_DEVICE_PROPERTY_VERSION_MINOR) + "." +
                        part(RTC_DEVICE_PROPERTY_VERSION_PATCH);
  rtcReleaseDevice(device);
  return version;
}

}  // namespace lume::geometry
