// SPDX-License-Identifier: Apache-2.0
// What a file says of its analytic shapes.
#include "tests/io/gltf_guard.h"
#include "tests/io/gltf_shape_file.h"

#include <gmock/gmock.h>

namespace lume::io {
namespace {

/// A shape, and where in it the error is to be reported.
struct ShapeCase {
  const char* name;
  const char* shape;
  const char* pointer;
};

std::ostream& operator<<(std::ostream& out, const ShapeCase& test) { return out << test.name; }

const std::string k_shapes = "/extensions/KHR_implicit_shapes/shapes";

class GltfShapeGuard : public testing::TestWithParam<ShapeCase> {};

TEST_P(GltfShapeGuard, BadShape_IsSceneErrorWithPointerInEitherArray) {
  const nlohmann::json shape = nlohmann::json::parse(GetParam().shape);
  test::expect_scene_error(test::shape_file(shape), k_shapes + "/0" + GetParam().pointer);
  nlohmann::json json = test::shape_file(nullptr);
  json.erase("extensions");
  json["shapes"] = nlohmann::json::array({shape});
  test::expect_scene_error(json, std::string("/shapes/0") + GetParam().pointer);
}

constexpr ShapeCase k_khronos_cases[] = {
    {"ShapeNumber", R"(5)", ""},
    {"NoType", R"({"sphere":{}})", ""},
    {"TypeNumber", R"({"type":5})", "/type"},
    {"TypeUnknown", R"({"type":"spere"})", "/type"},
    {"NameNumber", R"({"type":"sphere","name":1})", "/name"},
    {"ParametersNotObject", R"({"type":"sphere","sphere":[]})", "/sphere"},
    {"SphereRadiusZero", R"({"type":"sphere","sphere":{"radius":0}})", "/sphere/radius"},
    {"SphereRadiusNegative", R"({"type":"sphere","sphere":{"radius":-1}})", "/sphere/radius"},
    {"SphereRadiusHuge", R"({"type":"sphere","sphere":{"radius":1e16}})", "/sphere/radius"},
    {"SphereRadiusTiny", R"({"type":"sphere","sphere":{"radius":1e-300}})", "/sphere/radius"},
    {"SphereRadiusText", R"({"type":"sphere","sphere":{"radius":"1"}})", "/sphere/radius"},
    {"SphereRadiusNull", R"({"type":"sphere","sphere":{"radius":null}})", "/sphere/radius"},
    {"BoxSizeNumber", R"({"type":"box","box":{"size":1}})", "/box/size"},
    {"BoxSizeShort", R"({"type":"box","box":{"size":[1,1]}})", "/box/size"},
    {"BoxSizeZero", R"({"type":"box","box":{"size":[1,0,1]}})", "/box/size/1"},
    {"BoxSizeText", R"({"type":"box","box":{"size":[1,1,"1"]}})", "/box/size/2"},
    {"CylinderHeightZero", R"({"type":"cylinder","cylinder":{"height":0}})", "/cylinder/height"},
    {"CylinderRadiusNegative", R"({"type":"cylinder","cylinder":{"radiusTop":-0.1}})",
     "/cylinder/radiusTop"},
    {"CylinderRadiusBool", R"({"type":"cylinder","cylinder":{"radiusBottom":true}})",
     "/cylinder/radiusBottom"},
    {"CylinderWithoutRadii", R"({"type":"cylinder","cylinder":{"radiusBottom":0,"radiusTop":0}})",
     "/cylinder"},
    {"CapsuleHeightNegative", R"({"type":"capsule","capsule":{"height":-1}})", "/capsule/height"},
    {"CapsuleRadiusNegative", R"({"type":"capsule","capsule":{"radiusBottom":-1}})",
     "/capsule/radiusBottom"},
    {"CapsuleWithoutRadii", R"({"type":"capsule","capsule":{"radiusBottom":0,"radiusTop":0}})",
     "/capsule"},
    {"PlaneSizeZero", R"({"type":"plane","plane":{"sizeX":0}})", "/plane/sizeX"},
    {"PlaneSizeNegative", R"({"type":"plane","plane":{"sizeX":1,"sizeZ":-2}})", "/plane/sizeZ"},
    {"PlaneSidesNumber", R"({"type":"plane","plane":{"doubleSided":1}})", "/plane/doubleSided"},
};

constexpr ShapeCase k_vendor_cases[] = {
    {"DiskRadiusZero", R"({"type":"LUME_disk","LUME_disk":{"radius":0}})", "/LUME_disk/radius"},
    {"DiskHoleTooLarge", R"({"type":"LUME_disk","LUME_disk":{"radius":1,"innerRadius":1}})",
     "/LUME_disk/innerRadius"},
    {"DiskHoleNegative", R"({"type":"LUME_disk","LUME_disk":{"innerRadius":-0.1}})",
     "/LUME_disk/innerRadius"},
    {"TorusTubeZero", R"({"type":"LUME_torus","LUME_torus":{"minorRadius":0}})",
     "/LUME_torus/minorRadius"},
    {"TorusTubeTooThick", R"({"type":"LUME_torus","LUME_torus":{"minorRadius":0.4}})",
     "/LUME_torus/minorRadius"},
    {"TorusRingTooSmall", R"({"type":"LUME_torus","LUME_torus":{"majorRadius":0.1}})",
     "/LUME_torus"},
    {"PolygonWithoutParameters", R"({"type":"LUME_polygon"})", ""},
    {"PolygonWithoutOutline", R"({"type":"LUME_polygon","LUME_polygon":{}})", "/LUME_polygon"},
    {"PolygonOutlineText", R"({"type":"LUME_polygon","LUME_polygon":{"outline":"square"}})",
     "/LUME_polygon/outline"},
    {"PolygonTwoCorners", R"({"type":"LUME_polygon","LUME_polygon":{"outline":[[0,0,0],[1,0,0]]}})",
     "/LUME_polygon/outline"},
    {"PolygonCornerFlat",
     R"({"type":"LUME_polygon","LUME_polygon":{"outline":[[0,0,0],[1,0],[1,1,0]]}})",
     "/LUME_polygon/outline/1"},
    {"PolygonCornerText",
     R"({"type":"LUME_polygon","LUME_polygon":{"outline":[[0,0,0],[1,0,"0"],[1,1,0]]}})",
     "/LUME_polygon/outline/1/2"},
    {"PolygonCornerFarAway",
     R"({"type":"LUME_polygon","LUME_polygon":{"outline":[[0,0,0],[1e16,0,0],[1,1,0]]}})",
     "/LUME_polygon/outline/1/0"},
    {"PolygonIsALine",
     R"({"type":"LUME_polygon","LUME_polygon":{"outline":[[0,0,0],[1,0,1],[3,0,3]]}})",
     "/LUME_polygon/outline"},
    {"PolygonIsAPoint",
     R"({"type":"LUME_polygon","LUME_polygon":{"outline":[[1,1,1],[1,1,1],[1,1,1]]}})",
     "/LUME_polygon/outline"},
    {"PolygonNotPlanar",
     R"({"type":"LUME_polygon","LUME_polygon":
         {"outline":[[0,0,0],[1,0,0],[1,1,0.001],[0,1,0]]}})",
     "/LUME_polygon/outline/0"},
    {"PolygonHoleOffPlane",
     R"({"type":"LUME_polygon","LUME_polygon":{"outline":[[0,0,0],[9,0,0],[0,9,0]],
         "holes":[[[1,1,0],[2,1,0],[1,2,0]],[[1,1,0],[2,1,0],[1,2,1]]]}})",
     "/LUME_polygon/holes/1/2"},
    {"PolygonHoleOfTwo",
     R"({"type":"LUME_polygon","LUME_polygon":{"outline":[[0,0,0],[9,0,0],[0,9,0]],
         "holes":[[[1,1,0],[2,1,0]]]}})",
     "/LUME_polygon/holes/0"},
    {"PolygonHoleIsALine",
     R"({"type":"LUME_polygon","LUME_polygon":{"outline":[[0,0,0],[9,0,0],[0,9,0]],
         "holes":[[[1,1,0],[2,1,0],[3,1,0]]]}})",
     "/LUME_polygon/holes/0"},
    {"PolygonHolesObject",
     R"({"type":"LUME_polygon","LUME_polygon":{"outline":[[0,0,0],[9,0,0],[0,9,0]],"holes":{}}})",
     "/LUME_polygon/holes"},
    {"BezierWithoutPatches",
     R"({"type":"LUME_bezier_patch","LUME_bezier_patch":{"points":[[0,0,0]]}})",
     "/LUME_bezier_patch"},
    {"BezierNoPatches",
     R"({"type":"LUME_bezier_patch","LUME_bezier_patch":{"points":[[0,0,0]],"patches":[]}})",
     "/LUME_bezier_patch/patches"},
    {"BezierNoPoints",
     R"({"type":"LUME_bezier_patch","LUME_bezier_patch":{"points":[],"patches":[[0]]}})",
     "/LUME_bezier_patch/points"},
    {"BezierPointShort",
     R"({"type":"LUME_bezier_patch","LUME_bezier_patch":{"points":[[0,0]],"patches":[[0]]}})",
     "/LUME_bezier_patch/points/0"},
    {"BezierFifteenIndices",
     R"({"type":"LUME_bezier_patch","LUME_bezier_patch":{"points":[[0,0,0],[1,0,0]],
         "patches":[[0,0,0,0,0,0,0,0,1,1,1,1,1,1,1]]}})",
     "/LUME_bezier_patch/patches/0"},
    {"BezierNoSuchPoint",
     R"({"type":"LUME_bezier_patch","LUME_bezier_patch":{"points":[[0,0,0],[1,0,0]],
         "patches":[[0,0,0,0,0,0,0,0,1,1,1,1,1,1,1,2]]}})",
     "/LUME_bezier_patch/patches/0/15"},
    {"BezierIndexNegative",
     R"({"type":"LUME_bezier_patch","LUME_bezier_patch":{"points":[[0,0,0],[1,0,0]],
         "patches":[[-1,0,0,0,0,0,0,0,1,1,1,1,1,1,1,1]]}})",
     "/LUME_bezier_patch/patches/0/0"},
    {"BezierIsAPoint",
     R"({"type":"LUME_bezier_patch","LUME_bezier_patch":{"points":[[0,0,0],[0,0,0]],
         "patches":[[1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]]}})",
     "/LUME_bezier_patch/patches/0"},
};

constexpr ShapeCase k_equation_cases[] = {
    {"QuadricWithoutParameters", R"({"type":"LUME_quadric"})", ""},
    {"QuadricNeither", R"({"type":"LUME_quadric","LUME_quadric":{}})", "/LUME_quadric"},
    {"QuadricBoth",
     R"({"type":"LUME_quadric","LUME_quadric":
         {"form":"cone","coefficients":[1,0,0,0,1,0,0,1,0,-1]}})",
     "/LUME_quadric"},
    {"QuadricNineNumbers",
     R"({"type":"LUME_quadric","LUME_quadric":{"coefficients":[1,0,0,0,1,0,0,1,0]}})",
     "/LUME_quadric/coefficients"},
    {"QuadricText",
     R"({"type":"LUME_quadric","LUME_quadric":{"coefficients":[1,0,0,0,1,0,0,1,0,"a"]}})",
     "/LUME_quadric/coefficients/9"},
    {"QuadricAllZero",
     R"({"type":"LUME_quadric","LUME_quadric":{"coefficients":[0,0,0,0,0,0,0,0,0,0]}})",
     "/LUME_quadric/coefficients"},
    {"QuadricConstant",
     R"({"type":"LUME_quadric","LUME_quadric":{"coefficients":[0,0,0,0,0,0,0,0,0,3]}})",
     "/LUME_quadric/coefficients"},
    {"QuadricImaginary",
     R"({"type":"LUME_quadric","LUME_quadric":{"coefficients":[1,0,0,0,1,0,0,1,0,1]}})",
     "/LUME_quadric"},
    {"QuadricAPoint",
     R"({"type":"LUME_quadric","LUME_quadric":{"coefficients":[1,0,0,0,1,0,0,1,0,0]}})",
     "/LUME_quadric"},
    {"QuadricClippedAway",
     R"({"type":"LUME_quadric","LUME_quadric":{"form":"ellipsoid","clip":{"x":[2,3]}}})",
     "/LUME_quadric"},
    {"QuadricFormUnknown", R"({"type":"LUME_quadric","LUME_quadric":{"form":"elipsoid"}})",
     "/LUME_quadric/form"},
    {"QuadricFormNumber", R"({"type":"LUME_quadric","LUME_quadric":{"form":1}})",
     "/LUME_quadric/form"},
    {"QuadricAxesZero",
     R"({"type":"LUME_quadric","LUME_quadric":{"form":"cone","semiAxes":[1,1,0]}})",
     "/LUME_quadric/semiAxes/2"},
    {"QuadricAxesShort",
     R"({"type":"LUME_quadric","LUME_quadric":{"form":"cone","semiAxes":[1,1]}})",
     "/LUME_quadric/semiAxes"},
    {"QuadricAxesOfCoefficients",
     R"({"type":"LUME_quadric","LUME_quadric":
         {"semiAxes":[1,1,1],"coefficients":[1,0,0,0,1,0,0,1,0,-1]}})",
     "/LUME_quadric/semiAxes"},
    {"QuadricWaistOne",
     R"({"type":"LUME_quadric","LUME_quadric":{"form":"hyperboloidOneSheet","waist":1}})",
     "/LUME_quadric/waist"},
    {"QuadricWaistOfCone", R"({"type":"LUME_quadric","LUME_quadric":{"form":"cone","waist":0.5}})",
     "/LUME_quadric/waist"},
    {"QuadricClipArray", R"({"type":"LUME_quadric","LUME_quadric":{"form":"cone","clip":[]}})",
     "/LUME_quadric/clip"},
    {"QuadricClipSwapped",
     R"({"type":"LUME_quadric","LUME_quadric":{"form":"cone","clip":{"y":[0.1,-0.1]}}})",
     "/LUME_quadric/clip/y"},
    {"QuadricClipEqual",
     R"({"type":"LUME_quadric","LUME_quadric":{"form":"cone","clip":{"z":[0,0]}}})",
     "/LUME_quadric/clip/z"},
    {"QuadricClipText",
     R"({"type":"LUME_quadric","LUME_quadric":{"form":"cone","clip":{"x":[0,"1"]}}})",
     "/LUME_quadric/clip/x/1"},
    {"QuadricCapsNumber", R"({"type":"LUME_quadric","LUME_quadric":{"form":"cone","caps":1}})",
     "/LUME_quadric/caps"},
    {"ImplicitWithoutBounds", R"({"type":"LUME_implicit","LUME_implicit":{"expression":"x"}})",
     "/LUME_implicit"},
    {"ImplicitWithoutExpression",
     R"({"type":"LUME_implicit","LUME_implicit":{"bounds":{"min":[0,0,0],"max":[1,1,1]}}})",
     "/LUME_implicit"},
    {"ImplicitNumber",
     R"({"type":"LUME_implicit","LUME_implicit":
         {"expression":1,"bounds":{"min":[0,0,0],"max":[1,1,1]}}})",
     "/LUME_implicit/expression"},
    {"ImplicitEmptyText",
     R"({"type":"LUME_implicit","LUME_implicit":
         {"expression":"","bounds":{"min":[0,0,0],"max":[1,1,1]}}})",
     "/LUME_implicit/expression"},
    {"ImplicitSyntax",
     R"({"type":"LUME_implicit","LUME_implicit":
         {"expression":"x + * y","bounds":{"min":[0,0,0],"max":[1,1,1]}}})",
     "/LUME_implicit/expression"},
    {"ImplicitUnknownName",
     R"({"type":"LUME_implicit","LUME_implicit":
         {"expression":"x + w\n","bounds":{"min":[0,0,0],"max":[1,1,1]}}})",
     "/LUME_implicit/expression"},
    {"ImplicitBoundsWithoutMax",
     R"({"type":"LUME_implicit","LUME_implicit":{"expression":"x","bounds":{"min":[0,0,0]}}})",
     "/LUME_implicit/bounds"},
    {"ImplicitBoundsSwapped",
     R"({"type":"LUME_implicit","LUME_implicit":
         {"expression":"x","bounds":{"min":[-1,2,-1],"max":[1,1,1]}}})",
     "/LUME_implicit/bounds"},
    {"ImplicitBoundsFarAway",
     R"({"type":"LUME_implicit","LUME_implicit":
         {"expression":"x","bounds":{"min":[-1,-1,-1],"max":[1,1e17,1]}}})",
     "/LUME_implicit/bounds/max/1"},
    {"ImplicitNowhere",
     R"({"type":"LUME_implicit","LUME_implicit":
         {"expression":"x^2+1","bounds":{"min":[-1,-1,-1],"max":[1,1,1]}}})",
     "/LUME_implicit"},
};

std::string shape_case_name(const testing::TestParamInfo<ShapeCase>& info) {
  return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(Khronos, GltfShapeGuard, testing::ValuesIn(k_khronos_cases),
                         shape_case_name);
INSTANTIATE_TEST_SUITE_P(Vendor, GltfShapeGuard, testing::ValuesIn(k_vendor_cases),
                         shape_case_name);
INSTANTIATE_TEST_SUITE_P(Equation, GltfShapeGuard, testing::ValuesIn(k_equation_cases),
                         shape_case_name);

std::string message_of(const nlohmann::json& json) {
  try {
    static_cast<void>(test::load_json(json));
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(GltfShapeMessage, MistypedName_GetsTheNearest) {
  EXPECT_THAT(message_of(test::shape_file({{"type", "lume_tourus"}})),
              testing::HasSubstr("did you mean LUME_torus?"));
  EXPECT_THAT(message_of(test::shape_file(
                  test::shape_of("LUME_quadric", {{"form", "hyperboloidTowSheets"}}))),
              testing::HasSubstr("did you mean hyperboloidTwoSheets?"));
}

TEST(GltfShapeMessage, BadExpression_NamesItsColumn) {
  const nlohmann::json parameters = {{"expression", "x^2 + foo"},
                                     {"bounds", {{"min", {0, 0, 0}}, {"max", {1, 1, 1}}}}};
  EXPECT_THAT(message_of(test::shape_file(test::shape_of("LUME_implicit", parameters))),
              testing::HasSubstr("/LUME_implicit/expression: column 7: "));
}

TEST(GltfShapeMessage, NumberBeyondDouble_IsAnError) {
  const tests::TemporaryFolder folder;
  std::string text = test::shape_file(test::shape_of("sphere", {{"radius", 7}})).dump();
  text.replace(text.find(":7"), 2, ":1e999");
  test::write_bytes(folder / "a.gltf", text);
  EXPECT_THROW(static_cast<void>(load_gltf(folder / "a.gltf")), Error);
}

TEST(GltfShapeMessage, TooManyCorners_AreAnError) {
  nlohmann::json outline = nlohmann::json::array({{0, 0, 0}, {9, 0, 0}, {0, 9, 0}});
  for (int i = 0; i < 100'000; ++i) outline.push_back({0, 9, 0});
  EXPECT_THAT(message_of(test::shape_file(test::shape_of("LUME_polygon", {{"outline", outline}}))),
              testing::HasSubstr("/LUME_polygon/outline: the polygon has more than 100000"));
}

}  // namespace
}  // namespace lume::io
