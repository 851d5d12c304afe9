// Maximum intensity projection: the greatest interpolated value that is not carved away.

/* Uniforms */
uniform vec2 window;     // grey = code / 65535 · x + y
uniform float saturated; // code / 65535 from which on every grey is the same

vec3 seenAlong(Ray ray)
{
    float t = ray.gridZero + stepMm;
    float greatest = -1.0;
#if SCULPTED
    float segmentAt = nowhere;
#endif
    while (t < ray.last) {
        const float start = t;
        const Stretch stretch = stretchAt(ray, t);
        const bool wanted = stretch.distance == 0u && greatest < saturated
            && texelFetch(cellRanges, stretch.cell, 0).g > greatest;
#if SCULPTED
        const bool plain = (stretch.flags & (carvedFlag | segmentFlag)) == 0u;
        const bool segments = (stretch.flags & segmentFlag) != 0u && segmentAt == nowhere;
        float end = !plain && (wanted || segments) ? stretch.end : t;
        while (t < end) {
            const vec3 at = ray.origin + ray.direction * t;
            const bool kept = texture(radiation, at).r < 0.5;
            greatest = max(greatest, kept ? texture(intensity, at).r : -1.0);
            segmentAt = segmentAt == nowhere && texture(segmentation, at).r >= 0.5 ? t : segmentAt;
            t += stepMm;
        }
        end = wanted && plain ? stretch.end : t;
#else
        const float end = wanted ? stretch.end : t;
#endif
        while (t < end) {
            greatest = max(greatest, texture(intensity, ray.origin + ray.direction * t).r);
            t += stepMm;
        }
        t = t == start ? gridAfter(ray, t, stretch.end) : t;
    }
    vec3 result = vec3(greatest < 0.0 ? 0.0 : clamp(greatest * window.x + window.y, 0.0, 1.0));
#if SCULPTED
    const vec3 at = ray.origin + ray.direction * segmentAt;
    const vec3 inward = centralDifferences(segmentation, at, 1.0);
    const vec3 normal = normalize(gradientToWorld * -inward - 1e-9 * ray.world);
    const vec3 segment = lit(segmentColour(at), lightOn(normal, -ray.world, 1.0, 0.15));
    result = segmentAt != nowhere ? mix(result, segment, 0.7) : result;
#endif
    return result;
}
