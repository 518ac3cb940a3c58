// SPDX-License-Identifier: Apache-2.0
// LUME_quadric: ten coefficients, or one of the named forms; cut, and closed where it is cut.
#include "io/gltf/shape_readers.h"
#include "io/nearest_name.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lume::io::gltf {
namespace {

using geometry::DMat4;
using geometry::DVec3;
using geometry::QuadricForm;

constexpr double k_infinity = std::numeric_limits<double>::infinity();

struct NamedForm {
  const char* name;
  QuadricForm form;
};
constexpr NamedForm k_forms[] = {
    {"ellipsoid", QuadricForm::ellipsoid},
    {"cylinder", QuadricForm::cylinder},
    {"cone", QuadricForm::cone},
    {"paraboloid", QuadricForm::paraboloid},
    {"hyperboloidOneSheet", QuadricForm::hyperboloid_one_sheet},
    {"hyperboloidTwoSheets", QuadricForm::hyperboloid_two_sheets},
};

QuadricForm read_form(const JsonView& json) {
  std::vector<std::string> names;
  for (const NamedForm& known : k_forms) {
    if (json.text() == known.name) {
      return known.form;
    }
    names.emplace_back(known.name);
  }
  const std::string name = json.text().substr(0, 40);
  json.fail("there is no form '" + name + "'" + list_names(name, names));
}

/// Multiplied by a power of two, which changes neither the surface nor any digit, so that products
/// of the coefficients stay within a double's range.
DMat4 normalized(DMat4 q) {
  double largest = 0.0;
  for (int i = 0; i < 16; ++i) {
    largest = std::max(largest, std::abs(q[i / 4][i % 4]));
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (int i = 0; i < 16; ++i) {
    q[i / 4][i % 4] = std::ldexp(q[i / 4][i % 4], -exponent);
  }
  return q;
}

/// The symmetric matrix whose upper triangle stands in the file row by row.
DMat4 read_coefficients(const JsonView& json) {
  const std::vector<double> numbers = json.numbers(10);
  DMat4 q(0.0);
  std::size_t next = 0;
  for (int row = 0; row < 4; ++row) {
    for (int column = row; column < 4; ++column) {
      q[row][column] = q[column][row] = numbers[next++];
    }
  }
  const bool has_variables =
      std::any_of(numbers.begin(), numbers.end() - 1, [](double number) { return number != 0.0; });
  if (!has_variables) {
    json.fail("is no surface: expected one of the first nine coefficients not to be 0");
  }
  return normalized(q);
}

/// What is left of the surface; infinite where it is not cut.
struct Clip {
  DVec3 lower{-k_infinity};
  DVec3 upper{k_infinity};
};

/// An axis that is not named stays as it is.
void read_clip(const JsonView& json, Clip& clip) {
  constexpr std::array<const char*, 3> k_axes = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const auto range = json.find(k_axes[static_cast<std::size_t>(axis)]);
    if (!range) {
      continue;
    }
    const std::vector<double> ends = range->numbers(2, k_coordinate);
    if (!(ends[0] < ends[1])) {
      range->fail("expected a lower end and a larger upper one");
    }
    clip.lower[axis] = ends[0];
    clip.upper[axis] = ends[1];
  }
}

DMat4 read_named_form(const JsonView& json, Clip& clip) {
  const QuadricForm form = read_form(json.require("form"));
  const std::vector<double> axes = json.numbers_or("semiAxes", {0.5, 0.5, 0.5}, k_length);
  const DVec3 semi_axes(axes[0], axes[1], axes[2]);
  clip = {-semi_axes, semi_axes};

  const Range between{.lower = 0.0, .upper = 1.0, .without_lower = true, .without_upper = true};
  const double waist = json.number_or("waist", 0.5, between);
  const bool has_waist =
      form == QuadricForm::hyperboloid_one_sheet || form == QuadricForm::hyperboloid_two_sheets;
  if (json.has("waist") && !has_waist) {
    json.require("waist").fail("is only for the two hyperboloids");
  }
  return normalized(geometry::quadric_matrix(form, semi_axes, waist));
}

/// True if nothing is there but at most a single point.
bool is_nothing(const geometry::Quadric& quadric) {
  const auto width = [&](const DVec3& axis) {
    return quadric.support(axis) + quadric.support(-axis);
  };
  return !(width({1, 0, 0}) > 0.0 || width({0, 1, 0}) > 0.0 || width({0, 0, 1}) > 0.0);
}

}  // namespace

geometry::Shape read_quadric(const JsonView& parameters) {
  const std::optional<JsonView> coefficients = parameters.find("coefficients");
  if (coefficients.has_value() == parameters.has("form")) {
    parameters.fail(R"(expected either "coefficients" or a "form")");
  }
  for (const char* key : {"semiAxes", "waist"}) {
    if (coefficients && parameters.has(key)) {
      parameters.require(key).fail(R"(is only for a "form", not for "coefficients")");
    }
  }
  Clip clip;
  const DMat4 q =
      coefficients ? read_coefficients(*coefficients) : read_named_form(parameters, clip);
  if (const std::optional<JsonView> json = parameters.find("clip")) {
    read_clip(*json, clip);
  }
  const geometry::Quadric quadric(q, clip.lower, clip.upper, parameters.boolean_or("caps", false));
  if (is_nothing(quadric)) {
    parameters.fail("has no points: expected an equation with solutions within the clip box");
  }
  return quadric;
}

}  // namespace lume::io::gltf
