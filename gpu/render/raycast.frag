// One pixel of the 3D view. MODE: 0 surface, 1 volume rendering, 2 maximum intensity, 3 X-ray.
#include "render/raycast.glsl"
#if PIECES
#include "render/pieces.glsl"
#endif
#if MODE <= 1
#include "render/cutFace.glsl"
#endif
#if MODE == 0
#include "render/surface.glsl"
#elif MODE == 1
#include "render/dvr.glsl"
#elif MODE == 2
#include "render/mip.glsl"
#else
#include "render/xray.glsl"
#endif
#if SEEDS
#include "render/seeds.glsl"
#endif
#if BARRIERS
#include "render/barriers.glsl"
#endif
#if CHUNKS
#include "render/chunks.glsl"
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
