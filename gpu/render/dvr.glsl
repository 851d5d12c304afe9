// Direct volume rendering: front to back through a transfer function, lit by the gradient.

/* Uniforms */
uniform vec2 lookup;        // entry of the transfer function = code / 65535 · x + y
uniform float gradientFull; // length of a per-voxel difference that is certainly a surface

const float samplesPerGroup = 3.0;
const vec4 unlit = vec4(vec3(0.82), 0.0);

vec3 seenAlong(Ray ray)
{
    const vec3 toViewer = -ray.world;
    const float lastEntry = float(textureSize(transferFunction, 0).x - 1);
    const float enough = 0.02;
    float t = ray.gridZero + stepMm;
    vec3 seen = vec3(0.0);
    float through = 1.0;
    vec4 light = unlit;
    float lastOpacity = 0.0;
    // Where groups begin differs from pixel to pixel and from picture to picture: it averages out.
    const float firstGroup
        = 1.0 + floor(samplesPerGroup * fract(pixelNoise(gl_FragCoord.yx + 31.0) + jitterPhase));
    float groupSize = firstGroup;
    while (t < ray.last && through > enough) {
        const float start = t;
        const Stretch stretch = stretchAt(ray, t);
        // A group is not cut at its cell's border, or the borders would show.
        const float end = stretch.distance == 0u
            ? min(ray.last, t + stepMm * (groupSize - 0.5)) : t;
        // Samples are classified one by one but lit together, since lighting costs several samples:
        // matter keeps the light that fell on the surface before it, and a new surface is where
        // opacity changes most.
        vec3 glow = vec3(0.0);
        float glowOpacity = 0.0;
        float groupThrough = 1.0;
        float change = 0.0;
        float changeAt = 0.0;
        float most = 1e-4;
#if SCULPTED
        float segmentAt = nowhere;
#endif
        while (t < end && through * groupThrough > enough) {
            const vec3 at = ray.origin + ray.direction * t;
            const float entry = texture(intensity, at).r * lookup.x + lookup.y;
            vec4 matter = texelFetch(
                transferFunction, ivec2(clamp(entry, 0.0, lastEntry), 0), 0);
#if SCULPTED
            matter.a *= 1.0 - smoothstep(0.45, 0.55, texture(radiation, at).r);
            const bool inSegment = texture(segmentation, at).r >= 0.5;
            segmentAt = inSegment ? t : segmentAt;
            matter.a = inSegment ? 0.0 : matter.a;
#endif
            const float share = groupThrough * matter.a;
            glow += share * matter.rgb;
            glowOpacity += share;
            groupThrough *= 1.0 - matter.a;
            const float jump = abs(matter.a - lastOpacity) * groupThrough;
            change += jump;
            changeAt += jump * t;
            most = max(most, max(matter.a, lastOpacity));
            lastOpacity = matter.a;
#if SCULPTED
            if (inSegment)
                break;
#endif
            t += stepMm;
        }
        const vec3 at = ray.origin + ray.direction * (changeAt / max(change, 1e-6));
        const vec3 rise = tetrahedronDifferences(intensity, at);
        const vec3 slope = gradientToWorld * -rise;
        const vec3 normal = slope * inversesqrt(max(dot(slope, slope), 1e-16));
        // Translucent matter has no front: what faces away is lit from behind.
        const vec3 front = dot(normal, toViewer) < 0.0 ? -normal : normal;
        const vec4 onSurface = mix(unlit, lightOn(front, toViewer, 1.0, 0.10),
            clamp(length(rise) / gradientFull, 0.0, 1.0));
        light = mix(light, onSurface, clamp(change / most, 0.0, 1.0));
        seen += through * (glow * light.rgb + glowOpacity * light.a);
        through *= groupThrough;
#if SCULPTED
        const vec3 place = ray.origin + ray.direction * segmentAt;
        const vec3 inward = centralDifferences(segmentation, place, 1.0);
        const vec3 outward = normalize(gradientToWorld * -inward + 1e-9 * toViewer);
        const vec3 segment = lit(segmentColour(place), lightOn(outward, toViewer, 1.0, 0.22));
        seen += segmentAt != nowhere ? through * segment : vec3(0.0);
        through = segmentAt != nowhere ? 0.0 : through;
#endif
        const bool skipped = t == start;
        t = skipped ? gridAfter(ray, t, stretch.end) : t;
        lastOpacity = skipped ? 0.0 : lastOpacity;
        groupSize = skipped ? firstGroup : samplesPerGroup;
    }
    return seen;
}
