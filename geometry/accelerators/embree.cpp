// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/embree.h"

#include "geometry/refine.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace lume::geometry {
namespace {

/// Embree hands this back to the filter: the first member is what it knows, the rest is ours.
struct QueryContext {
  RTCIntersectContext embree;
  const Ray* ray;  ///< in the scene's frame; Embree's own copy is in object space by then
  const World* world;
  const HoleTest* holes;
};

/// Embree asks this at each candidate on a mesh with holes, for closest and any hits alike. The
/// barycentric coordinates are refined first, so that the rim of a hole is the same under every
/// accelerator.
void reject_holes(const RTCFilterFunctionNArguments* args) {
  const auto& query = *reinterpret_cast<const QueryContext*>(args->context);
  const auto& candidate = *reinterpret_cast<const RTCHit*>(args->hit);  // N is 1: single rays only
  const Hit hit{candidate.instID[0], candidate.geomID, candidate.primID};
  const Crossing crossing = refine(*query.world, *query.ray, hit);
  const Vec2 uv(static_cast<float>(crossing.u), static_cast<float>(crossing.v));
  if (query.holes->is_hole(hit, uv)) args->valid[0] = 0;
}

RTCRay to_embree(const Ray& ray) {
  RTCRay result{};
  result.org_x = ray.origin.x;
  result.org_y = ray.origin.y;
  result.org_z = ray.origin.z;
  result.tnear = ray.t_min;
  result.dir_x = ray.direction.x;
  result.dir_y = ray.direction.y;
  result.dir_z = ray.direction.z;
  result.tfar = ray.t_max;
  result.mask = ~0u;  // a mask of 0 meets nothing
  return result;
}

class Embree final : public Accelerator {
 public:
  Embree(const World& world, const HoleTest* holes) : world_(world), holes_(holes) {
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
    QueryContext context = make_context(ray);
    RTCRayHit query{to_embree(ray), {}};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context.embree, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return Hit{query.hit.instID[0], query.hit.geomID, query.hit.primID};
  }

  bool any_hit(const Ray& ray) const override {
    if (!is_traceable(ray)) return false;
    QueryContext context = make_context(ray);
    RTCRay query = to_embree(ray);
    rtcOccluded1(scene_, &context.embree, &query);
    return query.tfar < 0.0f;  // Embree's sign for "occluded"
  }

  AcceleratorStats stats() const override {
    AcceleratorStats stats;
    stats.build_seconds = build_seconds_;
    stats.memory_bytes = static_cast<std::size_t>(memory_bytes_.load());
    stats.instances = world_.instances.size();
    for (const Object& object : world_.objects) {
      for (const Mesh& mesh : object.geometries) stats.primitives += mesh.triangles.size();
    }
    return stats;
  }

 private:
  [[nodiscard]] QueryContext make_context(const Ray& ray) const {
    QueryContext context{{}, &ray, &world_, holes_};
    rtcInitIntersectContext(&context.embree);
    return context;
  }

  [[nodiscard]] RTCScene new_scene() const {
    RTCScene scene = rtcNewScene(device_);
    // Without ROBUST one ray in six that is aimed at a shared edge slips through it.
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    return scene;
  }

  void build() {
    scene_ = new_scene();
    object_scenes_.reserve(world_.objects.size());
    for (const Object& object : world_.objects) {
      object_scenes_.push_back(new_scene());
      for (std::uint32_t i = 0; i < object.geometries.size(); ++i) {
        attach_mesh(object_scenes_.back(), object.geometries[i], i);
      }
      commit(object_scenes_.back());
    }
    for (std::uint32_t i = 0; i < world_.instances.size(); ++i) {
      attach_instance(world_.instances[i], i);
    }
    commit(scene_);
  }

  void attach_mesh(RTCScene scene, const Mesh& mesh, std::uint32_t id) const {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    // Embree's own buffers and not ours, since it reads 16 bytes at the last vertex.
    copy_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions);
    copy_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
    if (mesh.has_holes && holes_ != nullptr) {
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

  void attach_instance(const Instance& instance, std::uint32_t id) const {
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
    rtcCommitScene(
        scene);  // on as many threads as ThreadLimit allows, to the same tree for any number
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
    for (RTCScene scene : object_scenes_) rtcReleaseScene(scene);
    if (device_ != nullptr) rtcReleaseDevice(device_);
  }

  const World& world_;
  const HoleTest* holes_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  std::vector<RTCScene> object_scenes_;
  std::atomic<ssize_t> memory_bytes_ = 0;
  double build_seconds_ = 0.0;
};

}  // namespace

std::unique_ptr<Accelerator> make_embree(const World& world, const HoleTest* holes) {
  return std::make_unique<Embree>(world, holes);
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
