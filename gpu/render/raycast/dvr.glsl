// Direct volume rendering: front-to-back compositing through a transfer function, lit by the
// gradient.

/* Uniforms */
uniform float gradientFull; // length of the per-voxel difference that certainly is a surface

const float samplesPerGroup = 3.0;
const vec4 unlit = vec4(vec3(0.82), 0.0);

/// The matter that is seen at one sample.
struct Matter {
    vec4 colour; // alpha: opacity of one step
    bool inSegment;
};

/// How much a place with this radiation belongs to a cut face: the one or two voxels behind the
/// cut.
float nearCarved(float carved)
{
    return smoothstep(0.06, 0.35, carved);
}

/// The same for the flat face of a clip plane, n samples behind the start of the ray.
float nearFace(float n)
{
    return 1.0 - smoothstep(1.5, 3.0, n);
}

/// @param n number of samples behind the start of the ray
Matter matterAt(vec3 at, float n)
{
    Matter matter;
    const float code = texture(intensity, at).r;
    matter.colour = transferAt(code);
    matter.inSegment = false;
#if SCULPTED || CLIPPED
    float face = 0.0;
#endif
#if SCULPTED
    const float carved = texture(radiation, at).r;
    face = nearCarved(carved);
    matter.colour.a *= 1.0 - smoothstep(0.45, 0.55, carved);
#endif
#if SEGMENTS
    matter.inSegment = segmentationAt(at) >= 0.5;
    matter.colour.a = matter.inSegment ? 0.0 : matter.colour.a;
#endif
#if CLIPPED
    face = max(face, nearFace(n));
#endif
#if SCULPTED || CLIPPED
    matter.colour.rgb = mix(matter.colour.rgb, faceGrey(code), face * greyFaces);
#endif
    return matter;
}

#if SHEETS
/// The number of the sample in front of which the next sheet lies; matter that begins at that
/// sample is behind the sheet.
float sheetSample(float gridZero)
{
    return (nextSheetAt - gridZero) / stepMm - 2.0;
}

/// Composites the sheets in front of a sample.
void meetSheetsBefore(float n, float gridZero, inout vec3 seen, inout float through)
{
#if CONTEXT == 1
    meetSheetsIn(gridZero + (n + 2.0) * stepMm, seen, through);
#else
    for (int i = 0; i < 2; ++i) {
        if (sheetsMet < 2 && n >= sheetSample(gridZero))
            meetSheet(seen, through);
    }
#endif
}
#endif

#if CONTEXT == 1
/// How much what a ray sees of the context counts.
float shareOfContext()
{
    return context * besides;
}

float leftBehind(float through)
{
    return seenThrough(through);
}

/// Composites what is behind the context: the segment, and sheets.
vec3 withSegment(Ray ray, float segmentAt, vec3 seen, float through)
{
#if SEGMENTS
#if SHEETS
    meetSheetsIn(segmentAt + 2.0 * stepMm, seen, through);
#endif
    const vec3 body = segmentLook(ray, segmentAt);
    seen += segmentAt < nowhere ? seenThrough(through) * body : vec3(0.0);
    besides = segmentAt < nowhere ? 0.0 : besides;
#if OVERLAID
    solidFrom = min(solidFrom, segmentAt);
#endif
#endif
#if SHEETS
    meetSheetsIn(nowhere, seen, through);
#endif
    return seen;
}
#else
float shareOfContext()
{
    return 1.0;
}

float leftBehind(float through)
{
    return through;
}
#endif

/// The picture of the volume without its pieces.
vec3 restAlong(Ray ray)
{
    const vec3 toViewer = -ray.world;
#if SHEETS
    // Nothing is searched behind an opaque sheet.
    ray.last = min(ray.last, opaqueSheetAt() + 2.0 * stepMm);
#endif
#if CONTEXT == 1
    const Ray whole = ray;
    const float segmentAt = findSegment(ray);
    ray.last = min(ray.last, segmentAt);
#endif
    const Samples samples = samplesOf(ray, cellSide);
    const float enough = 0.02;
#if CLIPPED
    const vec3 gateRise = normalize(transpose(textureToWorld) * -faceNormal(ray) * voxel);
#endif
    float n = 1.0;
    vec3 seen = vec3(0.0);
    float through = 1.0;
    vec4 light = unlit;
    float lastOpacity = 0.0;
    // The ends of groups differ from pixel to pixel and from picture to picture, so that artefacts
    // average out.
    const float firstGroup
        = 1.0 + floor(samplesPerGroup * fract(pixelNoise(gl_FragCoord.yx + 31.0) + jitterPhase));
    do {
        // Goes to the first sample that shows anything.
        const float start = n;
        bool found = false;
        do {
            vec3 cell = vec3(0.0);
            for (;;) {
                cell = cellOf(samples, n);
                const float distance = float(skipAt(cell).x);
                if (distance == 0.0 || n >= samples.last)
                    break;
                n = max(n, floor(leaves(samples, cell, distance - 1.0))) + 1.0;
            }
            const float end = min(max(leaves(samples, cell, 0.0), n + 0.5), samples.last);
            do {
                const Matter matter = matterAt(samples.origin + samples.step * n, n);
                found = n < end && (matter.colour.a > 0.0 || matter.inSegment);
                n += found ? 0.0 : 1.0;
            } while (n < end && !found);
        } while (n < samples.last && !found);
        lastOpacity = n > start ? 0.0 : lastOpacity;
        float groupEnd = min(samples.last, n + (n > start ? firstGroup : samplesPerGroup) - 0.5);
#if SHEETS
        meetSheetsBefore(n, ray.gridZero, seen, through);
        groupEnd = min(groupEnd, sheetSample(ray.gridZero));
#endif
        // Samples are classified individually but lit in groups, since lighting costs several
        // samples: matter keeps the light of the surface in front of it, and a new surface is where
        // the opacity changes most.
        vec3 glow = vec3(0.0);
        float glowOpacity = 0.0;
        float groupThrough = 1.0;
        float change = 0.0;
        float changeAt = 0.0;
        float most = 1e-4;
        bool segmentSeen = false;
        do {
            const Matter matter = matterAt(samples.origin + samples.step * n, n);
            const float opacity = found ? matter.colour.a : 0.0;
            const float share = groupThrough * opacity;
            glow += share * matter.colour.rgb;
            glowOpacity += share;
            groupThrough *= 1.0 - opacity;
            const float jump = abs(opacity - lastOpacity) * groupThrough;
            change += jump;
            changeAt += jump * n;
            most = max(most, max(opacity, lastOpacity));
            lastOpacity = opacity;
            segmentSeen = found && matter.inSegment;
            n += segmentSeen ? 0.0 : 1.0;
        } while (n < groupEnd && through * groupThrough > enough && !segmentSeen);
        const float changeN = changeAt / max(change, 1e-6);
        const vec3 at = samples.origin + samples.step * changeN;
        vec3 rise = tetrahedronDifferences(intensity, at);
#if SCULPTED || CLIPPED
        // At a cut the normal comes from the field that cut it, because the matter that was cut
        // need not have one.
        float face = 0.0;
        vec3 faceRise = vec3(0.0);
#endif
#if SCULPTED
        const vec3 carvedRise = centralDifferences(radiation, at, 1.0);
        face = nearCarved(texture(radiation, at).r) * smoothstep(0.02, 0.10, length(carvedRise));
        faceRise = -carvedRise / max(length(carvedRise), 1e-6);
#endif
#if CLIPPED
        const float clipped = nearFace(changeN) * (change > 1e-6 ? 1.0 : 0.0);
        faceRise = mix(faceRise, gateRise, clipped);
        face = max(face, clipped);
#endif
#if SCULPTED || CLIPPED
        rise = mix(rise, faceRise * gradientFull, face);
#endif
        const vec3 slope = gradientToWorld * -rise;
        const vec3 normal = slope * inversesqrt(max(dot(slope, slope), 1e-16));
        // Translucent matter has no front: where its normal faces away it is lit from behind.
        const vec3 front = dot(normal, toViewer) < 0.0 ? -normal : normal;
        const vec4 onSurface = mix(unlit, lightOn(front, toViewer, 1.0, 0.10),
            clamp(length(rise) / gradientFull, 0.0, 1.0));
        light = mix(light, onSurface, clamp(change / most, 0.0, 1.0));
        seen += through * shareOfContext() * (glow * light.rgb + glowOpacity * light.a);
        through *= groupThrough;
#if OVERLAID
        const bool solid = solidFrom == nowhere && (leftBehind(through) < 0.5 || segmentSeen);
        solidFrom = solid ? ray.gridZero + stepMm * n : solidFrom;
#endif
#if SEGMENTS
        const vec3 place = samples.origin + samples.step * n;
        const vec3 inward = segmentRise(ray, place);
        const vec3 outward = normalize(gradientToWorld * -inward + 1e-9 * toViewer);
        const vec3 segment = lit(segmentColour(place), lightOn(outward, toViewer, 1.0, 0.22));
        seen += segmentSeen ? through * segment : vec3(0.0);
        meetSegment(segmentSeen);
        through = segmentSeen ? 0.0 : through;
#endif
    } while (n < samples.last && through > enough);
#if CONTEXT == 1
    return withSegment(whole, segmentAt, seen, through > enough ? through : 0.0);
#endif
#if SHEETS
    through = through > enough ? through : 0.0;
    meetSheets(nowhere, seen, through);
#endif
    return seen;
}

#if PIECES
#include "render/raycast/dvrPieces.glsl"
#else
vec3 seenAlong(Ray ray)
{
    return restAlong(ray);
}
#endif
