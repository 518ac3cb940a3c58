# SPDX-License-Identifier: Apache-2.0
"""All scenes by name. Each value is a function that builds one."""

from . import afternoon, light, structure, surfaces

SCENES = {
    "afternoon": afternoon.build,
    "alpha_modes": surfaces.alpha_modes,
    "attributes": structure.attributes,
    "cameras_and_lights": light.cameras_and_lights,
    "emissive": light.emissive,
    "far_away": structure.far_away,
    "glass": light.glass,
    "materials": surfaces.materials,
    "normal_maps": surfaces.normal_maps,
    "textures": surfaces.textures,
}
