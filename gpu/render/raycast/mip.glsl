// Maximum intensity projection: the greatest interpolated value that is not carved away.

/* Uniforms */
uniform vec2 window;     // grey = code / 65535 · x + y
uniform float saturated; // code / 65535 from which on every grey is white
uniform float black;     // code / 65535 up to which every grey is black
uniform float levels[6]; // code / 65535, ascending

#include "render/parts/colourMap.glsl"

layout(binding = 8) uniform usampler3D maximumCells; // greatest code, distances by level

/// What is black in grey is black in all colours, since what lies beside the volume cannot always be
/// told from values that are too low to be looked at.
vec3 shownGreatest(float greatest)
{
    const float grey = clamp(greatest * window.x + window.y, 0.0, 1.0);
    return grey * 255.0 < 0.5 ? vec3(grey) : shownGrey(grey);
}

#if SEGMENTS || PIECES
float greatestOf(ivec3 cell)
{
#ifdef EVERY_SAMPLE
    return 2.0;
#endif
    return texelFetch(cellRanges, cell, 0).g;
}

#if PIECES
/// The greatest value along a piece. For a solid piece it also returns where its surface is.
float greatestOfPiece(Ray ray, int piece, float greatest, out float surfaceAt)
{
    const Samples samples = samplesOf(ray, cellSide);
    const float opacity = pieces[piece].low.w;
    float n = floor((ray.first - ray.gridZero) / stepMm) + 1.0;
    surfaceAt = nowhere;
    while (n < samples.last) {
        n = leaveFreeCells(piece, samples, n);
        const float end = min(
            max(leaves(samples, cellOf(samples, n), 0.0), n + 0.5), samples.last);
        while (n < end) {
            const vec3 at = samples.origin + samples.step * n;
            const bool own = footprintAt(piece, at) >= 0.5;
            const float value = max(mix(black, texture(intensity, at).r, opacity), 0.0);
            greatest = own ? max(greatest, value) : greatest;
            surfaceAt = own ? min(surfaceAt, n) : surfaceAt;
            n += 1.0;
        }
    }
    return greatest;
}

/// Draws solid pieces over the picture in their colours, like segments, the nearest one on top.
vec3 overPieces(Ray ray, vec3 picture, float nearest, int solid)
{
    const Ray own = pieceRay(ray, solid);
    const vec3 at = own.origin + own.direction * nearest;
    const vec3 normal = asShown(
        solid, normalize(gradientToWorld * -footprintRise(solid, at) - 1e-9 * own.world));
    const vec3 seen = lit(pieces[solid].colour.rgb, lightOn(normal, -ray.world, 1.0, 0.15));
    return mix(picture, seen, 0.7 * pieces[solid].low.w);
}
#endif

vec3 seenAlong(Ray ray)
{
    float t = ray.gridZero + stepMm;
    float greatest = -1.0;
    float segmentAt = nowhere;
#if PIECES
    t = ray.first < ray.last ? t : nowhere; // beside the volume
    float solidAt = nowhere;
    int solid = restOf;
    for (int k = 0; k < pieceCount; ++k) {
        const Ray own = pieceRay(ray, k);
        float surfaceAt = nowhere;
        if (own.first < own.last)
            greatest = greatestOfPiece(own, k, greatest, surfaceAt);
        const float surface = own.gridZero + surfaceAt * stepMm;
        const bool nearer = isSolid(k) && surfaceAt < nowhere && surface < solidAt;
        solid = nearer ? k : solid;
        solidAt = nearer ? surface : solidAt;
    }
#endif
    while (t < ray.last) {
        const float start = t;
        const Stretch stretch = stretchAt(ray, t);
        const bool wanted = stretch.distance == 0u && greatest < saturated
            && greatestOf(stretch.cell) > greatest;
        const bool plain = (stretch.flags & (carvedFlag | segmentFlag)) == 0u;
        const bool segments = (stretch.flags & segmentFlag) != 0u && segmentAt == nowhere;
        float end = !plain && (wanted || segments) ? stretch.end : t;
        while (t < end) {
            const vec3 at = ray.origin + ray.direction * t;
            const bool kept = texture(radiation, at).r < 0.5;
            greatest = max(greatest, kept ? texture(intensity, at).r : -1.0);
            segmentAt = segmentAt == nowhere && segmentationAt(at) >= 0.5 ? t : segmentAt;
            t += stepMm;
        }
        end = wanted && plain ? stretch.end : t;
        while (t < end) {
            greatest = max(greatest, texture(intensity, ray.origin + ray.direction * t).r);
            t += stepMm;
        }
        t = t == start ? gridAfter(ray, t, stretch.end) : t;
    }
    vec3 result = greatest < 0.0 ? vec3(0.0) : shownGreatest(greatest);
    float over = 0.7;
#if CONTEXT == 1
    const float grey = segmentAt == nowhere && !pastTranslucent ? contextOpacity.x : contextOpacity.y;
    result *= grey;
    over = mix(1.0, over, grey);
#endif
    const vec3 at = ray.origin + ray.direction * segmentAt;
    const vec3 inward = segmentRise(ray, at);
    const vec3 normal = normalize(gradientToWorld * -inward - 1e-9 * ray.world);
    const vec3 segment = lit(segmentColour(at), lightOn(normal, -ray.world, 1.0, 0.15));
    result = segmentAt != nowhere ? mix(result, segment, over) : result;
    meetSegment(segmentAt != nowhere);
#if PIECES
    if (solid >= 0 && solidAt < segmentAt)
        result = overPieces(ray, result, solidAt, solid);
#endif
    return result;
}
#else
const float maximumSide = 4.0;

vec3 seenAlong(Ray ray)
{
    const Samples samples = samplesOf(ray, maximumSide);
#if SCULPTED
    const Samples blocks = samplesOf(ray, cellSide);
#endif
    const vec3 perCells = 1.0 / vec3(textureSize(maximumCells, 0));
    float n = 1.0;
    float greatest = max(black, -1.0);
    float last = samples.last;
    do {
        // The jump distance is known for the highest level that the ray has reached.
        int level = -1;
        for (int k = 0; k < 6; ++k)
            level += greatest >= levels[k] ? 1 : 0;
        const uint mask = level < 0 ? 0u : 255u;
        const uint shift = uint(level & 1) * 8u;
        vec3 cell;
        bool wanted;
        for (;;) {
            cell = cellOf(samples, n);
#ifdef EVERY_SAMPLE
            const uvec4 entry = uvec4(65536u, 0u, 0u, 0u);
#else
            const uvec4 entry = texture(maximumCells, (cell + 0.5) * perCells);
#endif
            const uint word = level < 2 ? entry.y : level < 4 ? entry.z : entry.w;
            const float distance = float(word >> shift & mask);
            wanted = n < last && float(entry.x) > greatest * 65535.0;
            if (wanted || n >= last)
                break;
            const float leave = leaves(samples, cell, max(distance, 1.0) - 1.0);
            n = max(n, floor(leave)) + 1.0;
        }
        float end = wanted ? min(max(leaves(samples, cell, 0.0), n + 0.5), last) : n;
#if SCULPTED
        // What the greatest values know nothing of: that all is carved away here.
        const vec3 around = floor(cell * (maximumSide / cellSide));
        const float gone = float(skipAt(around).x);
        const float leave = leaves(blocks, around, max(gone, 1.0) - 1.0);
        n = wanted && gone > 0.0 ? max(n, floor(leave)) + 1.0 : n;
        end = gone > 0.0 ? n : end;
        // Whether a place is carved away is asked where its value would count, not at each sample.
        float value = 0.0;
        bool greater = false;
        do {
            value = texture(intensity, samples.origin + samples.step * n).r;
            greater = n < end && value > greatest;
            n += greater || n >= end ? 0.0 : 1.0;
        } while (n < end && !greater);
        const bool kept = texture(radiation, samples.origin + samples.step * n).r < 0.5;
        greatest = greater && kept ? value : greatest;
        n += greater ? 1.0 : 0.0;
#else
        do {
            const float value = texture(intensity, samples.origin + samples.step * n).r;
            greatest = n < end ? max(greatest, value) : greatest;
            n += 1.0;
        } while (n < end);
#endif
        last = greatest < saturated ? last : 0.0;
    } while (n < last);
    const vec3 picture = shownGreatest(greatest);
#if CONTEXT == 1
    return picture * contextOpacity.x;
#endif
    return picture;
}
#endif
