// SPDX-License-Identifier: Apache-2.0
// LUME_implicit: the surface f(x, y, z) = 0, f written as text.
#include "io/gltf/shape_readers.h"

#include <fmt/format.h>

namespace lume::io::gltf {
namespace {

geometry::Expression read_expression(const JsonView& json) {
  try {
    return geometry::Expression(json.text());
  } catch (const geometry::ExpressionError& error) {
    json.fail(fmt::format("column {}: {}", error.position() + 1, error.what()));
  }
}

}  // namespace

geometry::Shape read_implicit(const JsonView& parameters) {
  geometry::Expression expression = read_expression(parameters.require("expression"));
  const JsonView bounds = parameters.require("bounds");
  const geometry::DVec3 lower = read_point(bounds.require("min"));
  const geometry::DVec3 upper = read_point(bounds.require("max"));
  if (!glm::all(glm::lessThan(lower, upper))) {
    bounds.fail(R"(expected each number of "min" to be less than that of "max")");
  }
  geometry::ImplicitSurface surface(std::move(expression), lower, upper);
  if (surface.is_empty()) {
    parameters.fail("has no points: the expression is 0 nowhere within the bounds");
  }
  return surface;
}

}  // namespace lume::io::gltf
