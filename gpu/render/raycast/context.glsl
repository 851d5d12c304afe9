// Segments among a context, which is all of the volume that is in none. CONTEXT 1: the context is a
// translucent layer, or cut away, in front of them. CONTEXT 2: it is not drawn at all.
//
// All that a ray sees of the context together is one layer: if its colour is C and its opacity A,
// it counts as c · C and c · A with the same c along the whole ray. So whatever the transfer
// function is, what lies behind it is seen by at least 1 − c.

const float segmentAoRadius = 14.0; // mm

/// Ambient occlusion of segments by segments, as openness() has it for matter.
float segmentOpenness(vec3 at, vec3 directionWorld)
{
    float hidden = 0.0;
    float stride = segmentAoRadius * 0.22;
    float reached = 0.0;
    for (int look = 0; look < 3; ++look) {
        reached += stride;
        stride *= 1.6;
        const vec3 there = at + worldToTexture * (directionWorld * reached);
        float solid = smoothstep(0.35, 0.65, segmentationAt(there));
#if CLIPPED
        solid = isClipped(there) ? 0.0 : solid;
#endif
        hidden += solid * (0.62 - 0.14 * float(look));
    }
    return 1.0 - clamp(hidden, 0.0, 1.0);
}

#if CONTEXT == 1
/* Textures */
// distance in cells to the nearest with a part of a shown segment
layout(binding = 28) uniform usampler3D segmentSkip;

/* Uniforms */
uniform vec2 contextOpacity; // on rays that meet neither segment nor surface, and on others

float context = 1.0; // of this ray
float besides = 1.0; // how much of what is behind them lets through all but the context

/// How much of what lies behind is seen.
/// @param through of the context, as if it were opaque
float seenThrough(float through)
{
    return besides * (1.0 - context * (1.0 - through));
}

#if SHEETS
/// Composites the sheets up to a t.
void meetSheetsIn(float t, inout vec3 seen, float through)
{
    const float before = seenThrough(through);
    float left = before;
    meetSheets(t, seen, left);
    besides *= before > 0.0 ? left / before : 0.0;
}
#endif

#if SEGMENTS
float segmentDistanceAt(vec3 cell)
{
#ifdef EVERY_SAMPLE
    return 0.0;
#endif
    return float(texture(segmentSkip, (cell + 0.5) / vec3(textureSize(segmentSkip, 0))).r);
}

/// The first t along a ray that is inside a shown segment; nowhere if none is.
float segmentFrom(Ray ray)
{
    const Samples samples = samplesOf(ray, cellSide);
    float n = (ray.first - ray.gridZero) / stepMm;
    bool hit = false;
    do {
        vec3 cell = vec3(0.0);
        for (;;) {
            cell = cellOf(samples, n);
            const float distance = segmentDistanceAt(cell);
            if (distance == 0.0 || n >= samples.last)
                break;
            n = max(floor(n), floor(leaves(samples, cell, distance - 1.0))) + 1.0;
        }
        const float end = min(max(leaves(samples, cell, 0.0), n + 0.5), samples.last);
        do {
            const float inside = segmentationAt(samples.origin + samples.step * n);
            hit = n < end && inside >= 0.5;
            n = hit || n >= end ? n : floor(n) + 1.0;
        } while (n < end && !hit);
    } while (n < samples.last && !hit);
    float t = ray.gridZero + n * stepMm;
    float before = max(t - stepMm, ray.first);
    for (int halving = 0; halving < 5; ++halving) {
        const float middle = 0.5 * (before + t);
        const bool inside = segmentationAt(ray.origin + ray.direction * middle) >= 0.5;
        before = inside ? before : middle;
        t = inside ? middle : t;
    }
    return hit ? t : nowhere;
}

/// The colour of the segment that a ray meets at t.
vec3 segmentLook(Ray ray, float t)
{
    const vec3 at = ray.origin + ray.direction * min(t, ray.last);
    const vec3 inward = segmentRise(ray, at);
    const vec3 onBody = normalize(gradientToWorld * -inward - 1e-9 * ray.world);
    const bool onBox = t - ray.first < stepMm * 0.05;
    const vec3 normal = onBox ? faceNormal(ray) : onBody;
    const float open = onBox ? 1.0 : segmentOpenness(at, normal);
    const vec3 own = segmentColour(at);
    meetSegment(t < nowhere);
    return lit(own, lightOn(normal, -ray.world, open, 0.22));
}
#endif

/// Finds the segment that the ray meets, if any, and how much the context counts.
float findSegment(Ray ray)
{
    float segmentAt = nowhere;
#if SEGMENTS
    if (ray.first < ray.last)
        segmentAt = segmentFrom(ray);
#endif
    bool meets = segmentAt < nowhere || pastTranslucent;
#if SHEETS
    meets = meets || surfaceMetAt < nowhere;
#endif
    context = meets ? contextOpacity.y : contextOpacity.x;
    return segmentAt;
}
#endif
