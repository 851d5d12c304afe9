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
#if BARRIERS || CUT_PREVIEW == 2
#include "render/raycast/bodies.glsl"
#endif
#if BARRIERS
#include "render/raycast/barriers.glsl"
#endif
#if CUT_PREVIEW == 2
#include "render/raycast/suspended.glsl"
#endif
#if CHUNKS
#include "render/raycast/chunks.glsl"
#endif

vec3 lookAlong(Ray ray)
{
#if SHEETS
    findSheets();
#endif
    vec3 seen = seenAlong(ray);
#if SHEETS
    seen = withSheets(seen);
#endif
    return seen;
}

#if SEGMENT_LOOKS
/// The second look begins as the first one did.
void lookPastTranslucent()
{
    pastTranslucent = true;
#if SHEETS
    sheetsMet = 0;
    nearSheet.shining = 0.0;
    farSheet.shining = 0.0;
#endif
#if CONTEXT == 1
    besides = 1.0;
#endif
#if OVERLAID
    solidFrom = nowhere;
#endif
}

/// All that a ray sees: both looks, mixed by the opacity of the segment that it meets first.
vec3 looksAlong(Ray ray)
{
    vec3 seen = vec3(0.0);
    bool again = false;
#if OVERLAID
    float firstSolid = nowhere;
#endif
    do {
        // As it would be seen alone: light beyond white is white before it is mixed.
        const vec3 look = min(lookAlong(ray), vec3(1.0));
#if OVERLAID
        firstSolid = pastTranslucent ? firstSolid : solidFrom;
#endif
        seen += (pastTranslucent ? 1.0 - metOpacity : metOpacity) * look;
        again = !pastTranslucent && metOpacity < 0.999;
        if (again)
            lookPastTranslucent();
    } while (again);
#if OVERLAID
    // A segment that is seen by half hides what is behind it.
    solidFrom = metOpacity < 0.5 ? solidFrom : firstSolid;
#endif
    return seen;
}
#endif

void main()
{
    const Ray ray = rayOf(gl_FragCoord.xy);
#if SEGMENT_LOOKS
    vec3 seen = looksAlong(ray);
#else
    vec3 seen = lookAlong(ray);
#endif
#if SEEDS
    seen = withSeeds(ray, seen);
#endif
#if BARRIERS
    seen = withBarriers(ray, seen);
#endif
#if CUT_PREVIEW == 2
    seen = withSuspended(ray, seen);
#endif
#if CHUNKS
    seen = withChunks(ray, seen);
#endif
    colour = vec4(seen, 1.0);
}
