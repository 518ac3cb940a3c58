# SPDX-License-Identifier: Apache-2.0
"""All scenes by name. Each value is a function that builds one."""

from . import (afternoon, cornell, desk_lamp, gems, light, museum, sphereflake, structure, surfaces,
               teapot, whitted)

SCENES = {
    "afternoon": afternoon.build,
    "alpha_modes": surfaces.alpha_modes,
    "attributes": structure.attributes,
    "cameras_and_lights": light.cameras_and_lights,
    "cornell": cornell.build,
    "desk_lamp": desk_lamp.build,
    "emissive": light.emissive,
    "far_away": structure.far_away,
    "gems": gems.build,
    "glass": light.glass,
    "materials": surfaces.materials,
    "museum": museum.build,
    "normal_maps": surfaces.normal_maps,
    "sphereflake": sphereflake.build,
    "sphereflake_66430": sphereflake.build_66430,
    "teapot": teapot.build,
    "textures": surfaces.textures,
    "whitted": whitted.build,
}

# Arguments that a scene's function takes, all of them whole numbers with a least and a greatest.
OPTIONS = {
    "museum": {"fineness": (8, 1024)},
    "sphereflake": {"level": (0, 7)},
}
