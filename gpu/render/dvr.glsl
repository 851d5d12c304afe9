// Direct volume rendering: front to back through a transfer function, lit by the gradient.

/* Uniforms */
uniform vec2 lookup;        // transfer function coordinate = code / 65535 · x + y
uniform float gradientFull; // length of a per-voxel difference that is certainly a surface

vec3 seenAlong(Ray ray)
{
    float t = ray.gridZero + stepMm;
    vec3 light = vec3(0.0);
    float through = 1.0;
    const float enough = 0.015;
    const vec3 toViewer = -ray.world;
    while (t < ray.last && through > enough) {
        const float start = t;
        const Stretch stretch = stretchAt(ray, t);
        const bool plain = (stretch.flags & (carvedFlag | segmentFlag)) == 0u;
        const float end = stretch.distance == 0u ? stretch.end : t;
        while (t < end && through > enough) {
            const vec3 at = ray.origin + ray.direction * t;
            const float value = texture(intensity, at).r;
            vec4 sampled = texture(transferFunction, vec2(value * lookup.x + lookup.y, 0.5));
            bool inSegment = false;
            bool ask = !plain;
            while (ask) {
                const float carved = texture(radiation, at).r;
                sampled.a *= 1.0 - smoothstep(0.45, 0.55, carved);
                inSegment = texture(segmentation, at).r >= 0.5;
                ask = false;
            }
            bool shade = sampled.a * through > 0.004;
            while (shade) {
                const vec3 h = voxel;
                const vec3 rise = vec3(texture(intensity, at + vec3(h.x, 0, 0)).r,
                                      texture(intensity, at + vec3(0, h.y, 0)).r,
                                      texture(intensity, at + vec3(0, 0, h.z)).r)
                    - value;
                const vec3 slope = gradientToWorld * -rise;
                const float steep = length(slope);
                const vec3 normal = slope / max(steep, 1e-9);
                const float surface = clamp(length(rise) / gradientFull, 0.0, 1.0);
                // Translucent matter has no front: what faces away is lit from behind.
                const vec3 front = dot(normal, toViewer) < 0.0 ? -normal : normal;
                sampled.rgb = mix(sampled.rgb * 0.82, lit(sampled.rgb, front, toViewer, 1.0, 0.10),
                    surface);
                shade = false;
            }
            light += through * sampled.a * sampled.rgb;
            through *= 1.0 - sampled.a;
            while (inSegment) {
                const vec3 rise = centralDifferences(segmentation, at, 1.0);
                const vec3 normal = normalize(gradientToWorld * -rise + 1e-9 * toViewer);
                light += through * lit(segmentColour(at), normal, toViewer, 1.0, 0.22);
                through = 0.0;
                inSegment = false;
            }
            t += stepMm;
        }
        if (t == start)
            t = gridAfter(ray, t, stretch.end);
    }
    return light;
}
