// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/extensions.h"
#include "io/gltf/guards.h"

#include <algorithm>
#include <charconv>

namespace lume::io::gltf {
namespace {

struct Version {
  int major = 0;
  int minor = 0;
};

/// "2.1" and nothing else.
Version parse_version(const JsonView& value) {
  const std::string& text = value.text();
  const char* end = text.data() + text.size();
  Version version;
  const auto major = std::from_chars(text.data(), end, version.major);
  if (major.ec == std::errc() && major.ptr != end && *major.ptr == '.') {
    const auto minor = std::from_chars(major.ptr + 1, end, version.minor);
    if (minor.ec == std::errc() && minor.ptr == end && version.major >= 0 && version.minor >= 0) {
      return version;
    }
  }
  value.fail("is '" + text.substr(0, 20) + "', expected a version such as '2.0'");
}

}  // namespace

void check_asset(const JsonView& root) {
  const JsonView asset = root.require("asset");
  const JsonView version = asset.require("version");
  if (parse_version(version).major != 2) {
    version.fail("is \"" + version.text() + "\", expected glTF 2.x");
  }
  if (const std::optional<JsonView> minimum = asset.find("minVersion")) {
    const Version needed = parse_version(*minimum);
    if (needed.major != 2 || needed.minor > 0) {
      minimum->fail("asks for glTF " + minimum->text() + ", expected 2.0, which Lume reads");
    }
  }
  static_cast<void>(asset.text_or("generator", ""));
  static_cast<void>(asset.text_or("copyright", ""));
  for (const JsonView& name : root.items("extensionsUsed")) {
    static_cast<void>(name.text());
  }
  for (const JsonView& name : root.items("extensionsRequired")) {
    check_required_extension(name);
  }
}

void check_document(const JsonView& root) {
  check_asset(root);
  check_accessors(root);
  check_textures(root);
  check_meshes(root);
  check_nodes(root);
  check_instancing(root);
  check_animations(root);
}

}  // namespace lume::io::gltf
