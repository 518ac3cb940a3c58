// SPDX-License-Identifier: Apache-2.0
// A scene made ready for tracing: the accelerator over its world and the tables of its lights. The
// choice of an accelerator acts here and nowhere else.
#pragma once

#include "geometry/accelerators/accelerator.h"
#include "geometry/surface_point.h"
#include "renderer/emitters.h"
#include "shading/scene.h"

#include <functional>
#include <memory>
#include <optional>
#include <string_view>

namespace lume::renderer {

/// Builds a structure over a world; the holes may be null. Both outlive it.
using AcceleratorFactory = std::function<std::unique_ptr<geometry::Accelerator>(
    const geometry::World&, const geometry::HoleTest*)>;

class PreparedScene {
 public:
  /// `scene` must outlive this. Throws what make_accelerator throws.
  PreparedScene(const shading::Scene& scene, std::string_view accelerator);
  /// With a structure that need not have a name. Throws what `make_accelerator` throws.
  PreparedScene(const shading::Scene& scene, const AcceleratorFactory& make_accelerator);

  /// Says whose picture is to be rendered; see Accelerator::prepare_view.
  void prepare_view(const geometry::Camera& camera, int width, int height) {
    accelerator_->prepare_view(camera, width, height);
  }

  [[nodiscard]] const shading::Scene& scene() const { return scene_; }
  [[nodiscard]] const geometry::Accelerator& accelerator() const { return *accelerator_; }
  [[nodiscard]] const Emitters& emitters() const { return emitters_; }
  /// Some surface lets light through, so a shadow ray must look at each one it crosses.
  [[nodiscard]] bool has_see_through() const { return has_see_through_; }
  /// Some surface is absent when it is met from behind.
  [[nodiscard]] bool has_one_way() const { return has_one_way_; }

  [[nodiscard]] const shading::Material& material(const geometry::Hit& hit) const {
    return scene_.materials[scene_.world.geometry(hit).material];
  }
  /// Where along the ray, and where on the primitive, it meets what an accelerator named.
  [[nodiscard]] geometry::Crossing crossing_at(const geometry::Ray& ray,
                                               const geometry::Hit& hit) const {
    return refine(scene_.world, ray, hit, holes_.get());
  }
  /// The place where the ray meets what the accelerator named.
  [[nodiscard]] geometry::SurfacePoint point_at(const geometry::Ray& ray,
                                                const geometry::Hit& hit) const;

  /// The first visible surface along the ray. Back faces of single-sided materials are not visible.
  /// When there are none to skip this is one query of the accelerator.
  [[nodiscard]] std::optional<geometry::SurfacePoint> first_surface(geometry::Ray ray) const;

 private:
  const shading::Scene& scene_;
  std::unique_ptr<geometry::HoleTest> holes_;
  std::unique_ptr<geometry::Accelerator> accelerator_;
  Emitters emitters_;
  bool has_see_through_;
  bool has_one_way_;
};

}  // namespace lume::renderer
