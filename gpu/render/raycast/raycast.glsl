// Common parts of all ray-cast pictures: the ray of a pixel, the skip map, shading, segments.
//
// Spaces: texture is 0 … 1 over the voxels of the volume (voxel centres at (index + 0.5) / size).
// World is patient millimetres; only directions are used. t is millimetres along the ray; in an
// orthographic view it is measured from the target's plane, so it may be negative.
//
// llvmpipe executes both sides of an `if`, and every loop's body at least once, for all pixels of a
// group, so what is not needed must not be compiled. Hence the variants by SCULPTED (something is
// carved away or a segment is shown), SEGMENTS (a segment is shown; then SCULPTED, too) and CLIPPED
// (a clip box or plane is on) and CONTEXT (1: the volume is translucent or cut away in front of
// segments, 2: only segments are drawn; then MODE is 0) and SEGMENT_LOOKS (a segment is translucent, or
// all are drawn as their voxels are) and CUT_PREVIEW (1: marks on segments, 2: also bodies of what is
// suspended), and loops that put much work behind few tests.

// Bodies are laid over what a ray sees, so it is noted where that begins.
#define OVERLAID (SEEDS || BARRIERS || CHUNKS || CUT_PREVIEW == 2)

/* Textures */
layout(binding = 0) uniform sampler3D intensity;    // code / 65535
layout(binding = 1) uniform sampler3D radiation;    // ≥ 0.5: carved away
layout(binding = 2) uniform sampler3D segmentation; // ≥ 0.5: inside a shown segment
layout(binding = 3) uniform usampler3D labels;
layout(binding = 4) uniform usampler3D skipMap;     // distance in cells, flags
layout(binding = 5) uniform sampler3D cellRanges;   // least and greatest code / 65535
layout(binding = 6) uniform sampler2D transferFunction;
layout(binding = 7) uniform sampler2D palette;      // rgb, opacity (0: not shown)

/* Uniforms */
uniform vec3 originBase; // texture: start of the ray of pixel (0, 0)
uniform vec3 originPerX;      // texture per pixel
uniform vec3 originPerY;
uniform vec3 directionBase;   // texture per millimetre, before division by the length
uniform vec3 directionPerX;
uniform vec3 directionPerY;
uniform vec2 planeCentre;     // pixel
uniform float planePerPixel; // 0: orthographic; else pixel size / distance of the target
uniform float nearest;        // t before which nothing is drawn
uniform float stepMm;
uniform float jitterPhase; // 0 … 1, different for every accumulated picture
uniform float pixelScale;     // frame pixels per drawn pixel
uniform vec2 pixelJitter;     // frame pixels
uniform vec3 voxel;           // texture: size of one voxel
uniform mat3 gradientToWorld; // per-voxel differences → world
uniform mat3 worldToTexture;  // directions
uniform float aoTilt;         // 0: straight along the normal

#if CLIPPED // the clip region is convex, so a ray stays inside for a single interval
uniform vec3 clipLow;  // texture
uniform vec3 clipHigh;
// texture: kept where dot(xyz, at) ≤ w; a plane that is off keeps everything
uniform vec4 clipPlanes[3];
uniform vec4 clipNormals[3]; // world, unit, towards what is hidden

bool isClipped(vec3 at)
{
    bool hidden = any(lessThan(at, clipLow)) || any(greaterThan(at, clipHigh));
    for (int i = 0; i < 3; ++i)
        hidden = hidden || dot(clipPlanes[i].xyz, at) > clipPlanes[i].w;
    return hidden;
}
#else
const vec3 clipLow = vec3(0.0);
const vec3 clipHigh = vec3(1.0);
#endif

/* Output */
layout(location = 0) out vec4 colour;

const float cellSide = 8.0;
const uint carvedFlag = 2u;
const uint segmentFlag = 4u;

const float nowhere = 1e30; // no t

#if OVERLAID
float solidFrom = nowhere; // t behind which nothing is seen
#endif
#if SHEETS
#include "render/raycast/meetSheets.glsl"
#endif

struct Ray {
    vec3 origin;    // texture
    vec3 direction; // texture per millimetre
    vec3 inverse;   // 1 / direction
    vec3 world;     // world, unit, away from the viewer
    float first;    // t of entry
    float last;     // t of exit
    float gridZero; // t of number 0 of the sample grid; samples are at gridZero + n · stepMm
#if CLIPPED
    vec3 gate; // world, unit: normal of the clip plane by which it enters; 0: none
#endif
};

uniform mat3 textureToWorld; // directions

/// Noise without visible patterns (Jimenez 2014, interleaved gradient noise).
float pixelNoise(vec2 pixel)
{
    return fract(52.9829189 * fract(dot(floor(pixel), vec2(0.06711056, 0.00583715))));
}

/// Computes where a ray enters and leaves a box, and clips it.
void setBounds(inout Ray ray, vec3 low, vec3 high)
{
    // Avoids a division by zero for a ray along an axis.
    const vec3 tiny = vec3(1e-12);
    const vec3 safe = mix(ray.direction, tiny, lessThan(abs(ray.direction), tiny));
    ray.inverse = 1.0 / safe;
    const vec3 toLow = (low - ray.origin) * ray.inverse;
    const vec3 toHigh = (high - ray.origin) * ray.inverse;
    const vec3 enter = min(toLow, toHigh);
    const vec3 leave = max(toLow, toHigh);
    ray.first = max(max(max(enter.x, enter.y), enter.z), nearest);
    ray.last = min(min(leave.x, leave.y), leave.z);
#if CLIPPED
    ray.gate = vec3(0.0);
    for (int i = 0; i < 3; ++i) {
        const vec4 plane = clipPlanes[i];
        const float room = plane.w - dot(plane.xyz, ray.origin);
        const float approach = dot(plane.xyz, ray.direction);
        const float safe = abs(approach) < 1e-9 ? 1e-9 : approach;
        const float t = room / safe;
        const bool entering = safe < 0.0;
        ray.gate = entering && t > ray.first ? clipNormals[i].xyz : ray.gate;
        ray.first = entering ? max(ray.first, t) : ray.first;
        ray.last = entering ? ray.last : min(ray.last, t);
    }
#endif
}

Ray rayOf(vec2 fragment)
{
    Ray ray;
    const vec2 pixel = fragment * pixelScale + pixelJitter;
    ray.origin = originBase + originPerX * pixel.x + originPerY * pixel.y;
    const vec2 slope = (pixel - planeCentre) * planePerPixel;
    ray.direction = (directionBase + directionPerX * pixel.x + directionPerY * pixel.y)
        * inversesqrt(1.0 + dot(slope, slope));
    setBounds(ray, clipLow, clipHigh);
    ray.world = normalize(textureToWorld * ray.direction);
    const float jitter = fract(pixelNoise(fragment) + jitterPhase);
    ray.gridZero = ray.first - stepMm * jitter;
#if PIECES // pieces may be met beside the volume
    ray.gridZero = ray.first < ray.last ? ray.gridZero : -stepMm * jitter;
#endif
    return ray;
}

/// Distance and flags of the skip map. The outermost half voxel lies outside all cells, so the
/// nearest cell is used.
uvec2 skipAt(vec3 cell)
{
#ifdef EVERY_SAMPLE // for tests: nothing is skipped, so that pictures can be compared
    return uvec2(0u, carvedFlag | segmentFlag);
#endif
    return texture(skipMap, (cell + 0.5) / vec3(textureSize(skipMap, 0))).rg;
}

/// The cell of a sample, and where the ray leaves the block that the skip map lets it treat at
/// once.
struct Stretch {
    uint distance; // 0: the cell may hold something
    uint flags;
    float end; // t
    ivec3 cell;
};

Stretch stretchAt(Ray ray, float t)
{
    Stretch stretch;
    const vec3 cellsPerTexture = 1.0 / (voxel * cellSide);
    const vec3 here = (ray.origin + ray.direction * t) * cellsPerTexture - 0.5 / cellSide;
    const vec3 cell = clamp(floor(here), vec3(0.0), vec3(textureSize(skipMap, 0) - 1));
    stretch.cell = ivec3(cell);
    const uvec2 skip = skipAt(cell);
    stretch.distance = skip.x;
    stretch.flags = skip.y;
    const float reach = max(float(skip.x), 1.0) - 1.0;
    vec3 low = cell - reach;
    low -= vec3(lessThanEqual(low, vec3(0.0))); // the outermost half voxel belongs to cell 0
    const vec3 high = cell + 1.0 + reach;
    const vec3 border = mix(low, high, greaterThan(ray.inverse, vec3(0.0)));
    const vec3 times = ((border * cellSide + 0.5) * voxel - ray.origin) * ray.inverse;
    stretch.end = min(min(min(times.x, times.y), times.z), ray.last);
    return stretch;
}

/// The first grid sample after both this one and the end of the stretch.
float gridAfter(Ray ray, float t, float end)
{
    const float now = floor((t - ray.gridZero) / stepMm + 0.5);
    const float next = floor((end - ray.gridZero) / stepMm) + 1.0;
    return ray.gridZero + max(now + 1.0, next) * stepMm;
}

/// The numbered samples of a ray: sample n is at origin + n · step, for 1 ≤ n < last.
struct Samples {
    vec3 origin; // texture
    vec3 step;   // texture
    float last;
    vec3 cellOrigin; // the same in units of cells
    vec3 cellStep;
    vec3 leaveOrigin; // sample number at which a cell is left = leaveOrigin + cell · leavePerCell
    vec3 leavePerCell;
};

/// @param side of a cell, in voxels
Samples samplesOf(Ray ray, float side)
{
    Samples samples;
    const vec3 cellsPerTexture = 1.0 / (voxel * side);
    samples.origin = ray.origin + ray.direction * ray.gridZero;
    samples.step = ray.direction * stepMm;
    samples.last = (ray.last - ray.gridZero) / stepMm;
    samples.cellOrigin = samples.origin * cellsPerTexture - 0.5 / side;
    samples.cellStep = samples.step * cellsPerTexture;
    samples.leavePerCell = ray.inverse / (stepMm * cellsPerTexture);
    samples.leaveOrigin = (vec3(greaterThan(ray.inverse, vec3(0.0))) - samples.cellOrigin)
        * samples.leavePerCell;
    return samples;
}

vec3 cellOf(Samples samples, float n)
{
    return floor(samples.cellOrigin + samples.cellStep * n);
}

/// Where the ray leaves a cell and `reach` further cells on all sides.
float leaves(Samples samples, vec3 cell, float reach)
{
    const vec3 times = samples.leaveOrigin + cell * samples.leavePerCell
        + reach * abs(samples.leavePerCell);
    return min(min(times.x, times.y), times.z);
}

vec3 centralDifferences(sampler3D field, vec3 at, float reach)
{
    const vec3 h = voxel * reach;
    return vec3(
        texture(field, at + vec3(h.x, 0, 0)).r - texture(field, at - vec3(h.x, 0, 0)).r,
        texture(field, at + vec3(0, h.y, 0)).r - texture(field, at - vec3(0, h.y, 0)).r,
        texture(field, at + vec3(0, 0, h.z)).r - texture(field, at - vec3(0, 0, h.z)).r)
        * (0.5 / reach);
}

/// Differences per voxel from the eight corners of a cube around the place; they smooth the steps
/// that voxels make in a surface.
vec3 cubeDifferences(sampler3D field, vec3 at, float reach)
{
    const vec3 h = voxel * reach;
    vec3 sum = vec3(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 side = vec3(ivec3(corner & 1, corner >> 1 & 1, corner >> 2) * 2 - 1);
        sum += side * texture(field, at + h * side).r;
    }
    return sum / (8.0 * reach);
}

/// Differences per voxel from the four corners of a tetrahedron around the place.
vec3 tetrahedronDifferences(sampler3D field, vec3 at)
{
    const vec3 a = vec3(1, 1, 1);
    const vec3 b = vec3(-1, -1, 1);
    const vec3 c = vec3(-1, 1, -1);
    const vec3 d = vec3(1, -1, -1);
    return 0.25
        * (a * texture(field, at + voxel * a).r + b * texture(field, at + voxel * b).r
            + c * texture(field, at + voxel * c).r + d * texture(field, at + voxel * d).r);
}

#if WARNED || CUT_PREVIEW || BARRIERS
#include "kernels/labels/memberWords.glsl"
#endif
#if CUT_PREVIEW
#include "render/parts/cutPreview.glsl"
#endif

#include "render/raycast/segmentLooks.glsl"

/// The colour of the shown segments around a point, weighted as by interpolation.
vec3 segmentColour(vec3 at)
{
    const vec3 place = at / voxel - 0.5;
    const ivec3 base = ivec3(floor(place));
    const vec3 part = place - vec3(base);
    const ivec3 last = textureSize(labels, 0) - 1;
    vec4 sum = vec4(0.0);
#if SEGMENT_LOOKS
    float opacity = 0.0;
#endif
#if CUT_PREVIEW
    float going = 0.0;
    float reached = 0.0;
    float reinstated = 0.0;
#endif
    for (int corner = 0; corner < 8; ++corner) {
        const ivec3 offset = ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
#if SEGMENT_LOOKS
        const vec3 share = cornerShare(part, offset);
#else
        const vec3 share = mix(1.0 - part, part, vec3(offset));
#endif
        const ivec3 there = clamp(base + offset, ivec3(0), last);
        const uint label = texelFetch(labels, there, 0).r;
        const vec4 entry = texelFetch(palette, ivec2(int(label), 0), 0);
        // Near a thin part no shown voxel may be in reach; then any weight will do.
#if SEGMENT_LOOKS
        const float weight = counted(entry.a) * (share.x * share.y * share.z + 1e-4);
        opacity += entry.a * weight;
#else
        const float weight = entry.a * (share.x * share.y * share.z + 1e-4);
#endif
        sum += vec4(entry.rgb, 1.0) * weight;
#if CUT_PREVIEW
        // Where another plane's segment is seen in its place, a mark of the growth is not.
        const uint found = previewMarkAt(there);
        const uint mark = found != 0u && labelOf(wordAt(there)) == label ? found : 0u;
        going += mark == cutGoes ? weight : 0.0;
        reached += mark == growthReached ? weight : 0.0;
        reinstated += mark == growthReinstated ? weight : 0.0;
#endif
    }
    vec3 own = sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.8);
#if SEGMENT_LOOKS
    segmentOpacity = sum.a > 0.0 ? opacity / sum.a : 1.0;
#endif
#if WARNED
    const ivec3 nearestVoxel = clamp(ivec3(floor(place + 0.5)), ivec3(0), last);
    // Another plane's segment may be the one that is seen.
    const bool isOwn = texelFetch(labels, nearestVoxel, 0).r == labelOf(wordAt(nearestVoxel));
    own = isOwn && warns(nearestVoxel) ? texelFetch(palette, ivec2(0), 0).rgb : own;
#endif
#if CUT_PREVIEW
    const float most = 0.5 * sum.a;
    const uint mark = going > most ? cutGoes
        : reached > most           ? growthReached
        : reinstated > most        ? growthReinstated
                                   : 0u;
    own = mark != 0u ? previewMarkColour(mark, gl_FragCoord.xy * pixelScale, own) : own;
#endif
    return own;
}

/// The normal (world, towards the viewer) of the flat face by which a ray enters: the end of the
/// scan, or a clip plane.
vec3 faceNormal(Ray ray)
{
    const vec3 at = ray.origin + ray.direction * ray.first;
    const vec3 fromMiddle = (2.0 * at - clipLow - clipHigh) / (clipHigh - clipLow);
    const vec3 far = abs(fromMiddle);
    const float most = max(max(far.x, far.y), far.z);
    const vec3 side = vec3(greaterThanEqual(far, vec3(most - 2e-4))) * sign(fromMiddle);
    vec3 normal = normalize(gradientToWorld * side);
#if CLIPPED
    normal = dot(ray.gate, ray.gate) > 0.0 ? ray.gate : normal;
#endif
    return normal;
}

#include "render/parts/light.glsl"
