// Draws one pixel of the 3D view. MODE: 0 surface, 1 volume rendering, 2 maximum intensity, 3
// X-ray.
#include "render/raycast/raycast.glsl"
#if PIECES
#include "render/raycast/pieces.glsl"
#endif
#if MODE <= 1
#include "render/raycast/cutFace.glsl"
#endif
#if CONTEXT
#include "render/raycast/context.glsl"
#endif
#if MODE == 0
#include "render/raycast/surface.glsl"
#elif MODE == 1
#include "render/raycast/dvr.glsl"
#elif MODE == 2
#include "render/raycast/mip.glsl"
#else
#include "render/raycast/xray.glsl"
#endif
#if SEEDS
#include "render/raycast/seeds.glsl"
#endif
#if BARRIERS
#include "render/raycast/barriers.glsl"
#endif
#if CHUNKS
#include "render/raycast/chunks.glsl"
#endif

void main()
{
    const Ray ray = rayOf(gl_FragCoord.xy);
#if SHEETS
    findSheets();
#endif
    vec3 seen = seenAlong(ray);
#if SHEETS
    seen = withSheets(seen);
#endif
#if SEEDS
    seen = withSeeds(ray, seen);
#endif
#if BARRIERS
    seen = withBarriers(ray, seen);
#endif
#if CHUNKS
    seen = withChunks(ray, seen);
#endif
    colour = vec4(seen, 1.0);
}
