// Shaded surface: the first place that is dense and not carved, or inside a segment.

/* Uniforms */
uniform float threshold; // code / 65535; dense from there on
uniform float denseSpan; // code / 65535 from the threshold to what is certainly solid
uniform float aoRadius;  // mm

const vec3 boneColour = vec3(0.965, 0.895, 0.775);
const vec3 marrowColour = vec3(0.70, 0.44, 0.35);

bool isTissue(vec3 at)
{
    return texture(intensity, at).r >= threshold && texture(radiation, at).r < 0.5;
}

/// How open the place is, by a few looks along a direction. Cheap: one path, growing strides.
float openness(vec3 at, vec3 directionWorld, bool carved)
{
    float hidden = 0.0;
    float stride = aoRadius * 0.22;
    float reached = 0.0;
    for (int look = 0; look < 3; ++look) {
        reached += stride;
        stride *= 1.6;
        const vec3 there = at + worldToTexture * (directionWorld * reached);
        float solid = smoothstep(threshold - denseSpan * 0.35, threshold + denseSpan * 0.35,
            texture(intensity, there).r);
        bool ask = carved;
        while (ask) {
            solid *= 1.0 - smoothstep(0.35, 0.65, texture(radiation, there).r);
            ask = false;
        }
        hidden += solid * (0.62 - 0.14 * float(look));
    }
    return 1.0 - clamp(hidden, 0.0, 1.0);
}

vec3 seenAlong(Ray ray)
{
    float t = ray.first;
    bool hit = false;
    bool segmentHit = false;
    uint flags = 0u;
    while (t < ray.last && !hit) {
        const float start = t;
        const Stretch stretch = stretchAt(ray, t);
        flags = stretch.flags;
        const bool plain = (flags & (carvedFlag | segmentFlag)) == 0u;
        float end = stretch.distance == 0u && plain ? stretch.end : t;
        while (t < end) {
            if (texture(intensity, ray.origin + ray.direction * t).r >= threshold) {
                hit = true;
                break;
            }
            t += stepMm;
        }
        end = stretch.distance == 0u && !plain ? stretch.end : t;
        while (t < end && !hit) {
            const vec3 at = ray.origin + ray.direction * t;
            segmentHit = texture(segmentation, at).r >= 0.5;
            hit = segmentHit || isTissue(at);
            if (hit)
                break;
            t += stepMm;
        }
        if (t == start && !hit)
            t = gridAfter(ray, t, stretch.end);
    }

    vec3 result = vec3(0.0);
    bool shade = hit;
    while (shade) {
        shade = false;
        // Between the last empty sample and this one.
        float before = max(t - stepMm, ray.first);
        const bool plain = (flags & (carvedFlag | segmentFlag)) == 0u;
        for (int halving = 0; halving < 5; ++halving) {
            const float middle = 0.5 * (before + t);
            const vec3 at = ray.origin + ray.direction * middle;
            bool inside = texture(intensity, at).r >= threshold;
            bool ask = !plain;
            while (ask) {
                const bool inSegment = texture(segmentation, at).r >= 0.5;
                inside = segmentHit ? inSegment : inside && texture(radiation, at).r < 0.5;
                ask = false;
            }
            before = inside ? before : middle;
            t = inside ? middle : t;
        }
        const vec3 at = ray.origin + ray.direction * t;
        const vec3 toViewer = -ray.world;
        const float value = texture(intensity, at).r;
        const vec3 slope = centralDifferences(intensity, at, 1.0);
        vec3 normal = gradientToWorld * -slope;
        normal = dot(normal, normal) > 0.0 ? normalize(normal) : toViewer;
        vec3 albedo = boneColour;
        float gloss = 0.10;

        // The flat side of the scanned box: solid material is cut there by nature.
        const bool onBox = t - ray.first < stepMm * 0.05;
        float cut = onBox ? 1.0 : 0.0;
        vec3 cutNormal = toViewer;
        bool faceOfBox = onBox;
        while (faceOfBox) {
            const vec3 fromCentre = (at - 0.5) * 2.0;
            const vec3 size = abs(fromCentre);
            const float most = max(max(size.x, size.y), size.z);
            cutNormal = normalize(gradientToWorld
                * (vec3(greaterThanEqual(size, vec3(most))) * sign(fromCentre)));
            faceOfBox = false;
        }
        bool carved = (flags & carvedFlag) != 0u && !segmentHit && !onBox;
        while (carved) {
            // Which of the two surfaces is nearer decides; in between they blend (voxels).
            const vec3 rise = centralDifferences(radiation, at, 1.0);
            const float toCut = (0.5 - texture(radiation, at).r) / max(length(rise), 1e-3);
            const float toIso = (value - threshold) / max(length(slope), 1e-5);
            cut = length(rise) > 1e-3 ? smoothstep(-0.4, 0.6, toIso - toCut) : 0.0;
            cutNormal = normalize(gradientToWorld * rise + 1e-9 * toViewer);
            carved = false;
        }
        const float solid = smoothstep(0.0, 1.0, (value - threshold) / denseSpan);
        const vec3 cutColour = mix(marrowColour, boneColour * vec3(1.0, 0.99, 0.97), solid);
        albedo = mix(albedo, cutColour, cut);
        normal = normalize(mix(normal, cutNormal, cut) + 1e-6 * toViewer);

        bool inSegment = segmentHit;
        while (inSegment) {
            const vec3 rise = centralDifferences(segmentation, at, 1.0);
            normal = normalize(gradientToWorld * -rise + 1e-9 * toViewer);
            albedo = segmentColour(at);
            gloss = 0.22;
            inSegment = false;
        }
        // A gradient that looks away is noise: bend it back into sight instead of a black speck.
        const float away = min(dot(normal, toViewer), 0.0);
        normal = normalize(normal - (away - 0.02) * toViewer);

        const float turn = fract(pixelNoise(gl_FragCoord.yx + 17.0) + jitterPhase) * 6.2831853;
        const vec3 side = normalize(cross(normal, abs(normal.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0)));
        const vec3 tilted = normalize(
            normal + aoTilt * (cos(turn) * side + sin(turn) * cross(normal, side)));
        const float open = openness(at, tilted, (flags & carvedFlag) != 0u);
        result = lit(albedo, normal, toViewer, open, gloss);
    }
    return result;
}
