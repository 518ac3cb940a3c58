/* SPDX-License-Identifier: Apache-2.0
 *
 * A hierarchy of your own in Lume, from a shared library: `lume bench SCENE --accelerators
 * embree,./mine.so`. The library exports one function, lume_accelerator_plugin(), which returns a
 * table of what it can do. docs/adding_an_accelerator.md has a complete example.
 *
 * Lume builds one structure for each object of the scene and asks it with rays in that object's own
 * space. Instances, analytic surfaces and alpha holes are Lume's affair. So are t, u, v and normals
 * in the picture: the plugin only names the triangle, and Lume computes where it is met. */
#ifndef LUME_ACCELERATOR_PLUGIN_H
#define LUME_ACCELERATOR_PLUGIN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define LUME_ACCELERATOR_PLUGIN_VERSION 1u

/* The arrays stay where they are, unchanged, until destroy(). There is at least one triangle, all
 * coordinates are finite, and all corners are below position_count. */
typedef struct LumeTriangles {
  const float* positions; /* x, y, z of each position, in metres of the object's space */
  uint32_t position_count;
  const uint32_t* corners; /* three positions of each triangle */
  uint32_t triangle_count;
} LumeTriangles;

/* The points origin + t direction, t_min <= t <= t_max. All finite but t_max, which may be
 * infinite; direction is not 0 and not a unit vector. */
typedef struct LumeRay {
  float origin[3];
  float t_min;
  float direction[3];
  float t_max;
} LumeRay;

typedef struct LumeHit {
  uint32_t triangle; /* from 0 */
  float t;           /* in lengths of the ray's direction; checked, and not used otherwise */
} LumeHit;

typedef struct LumeAcceleratorPlugin {
  uint32_t version; /* LUME_ACCELERATOR_PLUGIN_VERSION of the header it was compiled with */
  const char* name;

  /* A structure over the triangles, or NULL and a message of at most `size` bytes, 0 included.
   * Never called twice at once. May use threads of its own. */
  void* (*build)(const LumeTriangles* triangles, char* message, size_t size);
  /* The next two are called from many threads at once, and must not write to the structure. */
  /* The first triangle on the ray, whichever side it shows; 0 if there is none. Of several at the
   * same t any will do, but the one of lowest number gives the very picture of other structures. */
  int (*closest_hit)(const void* structure, const LumeRay* ray, LumeHit* hit);
  /* Whether there is any triangle on the ray. */
  int (*any_hit)(const void* structure, const LumeRay* ray);
  void (*destroy)(void* structure);
  /* Bytes that the structure holds; may be NULL. */
  size_t (*memory_bytes)(const void* structure);
} LumeAcceleratorPlugin;

#define LUME_PLUGIN_EXPORT __attribute__((visibility("default")))

/* What Lume looks for in the library. The table must live as long as the library is loaded. */
LUME_PLUGIN_EXPORT const LumeAcceleratorPlugin* lume_accelerator_plugin(void);

#ifdef __cplusplus
}
#endif

#endif
