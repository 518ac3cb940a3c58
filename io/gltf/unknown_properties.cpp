// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/unknown_properties.h"

#include "io/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace lume::io::gltf {

void note_unknown_properties(const JsonView& object, std::string_view owner,
                             std::span<const std::string_view> properties,
                             const std::string& subject, Notes& notes) {
  const std::vector<std::string> known(properties.begin(), properties.end());
  for (const std::string& key : object.keys()) {
    if (key == "extensions" || key == "extras" ||
        std::find(known.begin(), known.end(), key) != known.end()) {
      continue;
    }
    const std::string name = key.substr(0, 40);
    notes.add(subject, fmt::format("'{}' is no property of {} and is not read{}", name, owner,
                                   list_names(name, known)));
  }
}

}  // namespace lume::io::gltf
