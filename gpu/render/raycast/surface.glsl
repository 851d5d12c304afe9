// Shaded surface: the first place along the ray that is dense and not carved, or inside a segment.

/* Uniforms */
uniform float threshold; // code / 65535; values from here on are dense
uniform float denseSpan; // code / 65535 from the threshold to what is certainly solid
uniform float aoRadius;  // mm

const vec3 boneColour = vec3(0.965, 0.895, 0.775);

bool isDense(vec3 at)
{
    return texture(intensity, at).r >= threshold;
}

#if SCULPTED
bool isCarved(vec3 at)
{
    return texture(radiation, at).r >= 0.5;
}
#endif

#if SEGMENTS
bool isSegment(vec3 at)
{
    return segmentationAt(at) >= 0.5;
}
#endif

#if PIECES
bool isPiece(int piece, vec3 at)
{
    return footprintAt(piece, at) >= 0.5 && (isSolid(piece) || isDense(at));
}
#else
const int restOf = -1;
vec3 asShown(int piece, vec3 v)
{
    return v;
}
float gapAt(int piece, vec3 at)
{
    return texture(radiation, at).r;
}
vec3 gapRise(int piece, vec3 at)
{
    return centralDifferences(radiation, at, 1.0);
}
#endif

/// Ambient occlusion: how open the place is, by a few samples along a direction with growing
/// strides.
/// @param directionWorld at the true place
float openness(int piece, vec3 at, vec3 directionWorld)
{
    float hidden = 0.0;
    float stride = aoRadius * 0.22;
    float reached = 0.0;
    for (int look = 0; look < 3; ++look) {
        reached += stride;
        stride *= 1.6;
        const vec3 there = at + worldToTexture * (directionWorld * reached);
        float solid = smoothstep(threshold - denseSpan * 0.8, threshold + denseSpan * 0.5,
            texture(intensity, there).r);
#if SCULPTED
        solid *= 1.0 - smoothstep(0.35, 0.65, gapAt(piece, there));
#endif
#if CLIPPED
        solid = isClipped(there) ? 0.0 : solid;
#endif
        hidden += solid * (0.62 - 0.14 * float(look));
    }
    return 1.0 - clamp(hidden, 0.0, 1.0);
}

/// Where a ray meets matter; t: nowhere if it does not.
struct Hit {
    float t;
    bool segment;
    bool onBox; // on the flat face that the ray enters by
};

Hit firstHit(Ray ray)
{
    const Samples samples = samplesOf(ray, cellSide);
    float n = (ray.first - ray.gridZero) / stepMm; // the side of the box itself may be the surface
    bool hit = false;
    bool segmentHit = false;
    do {
        vec3 cell = vec3(0.0);
        uvec2 skip = uvec2(0u);
        for (;;) {
            cell = cellOf(samples, n);
            skip = skipAt(cell);
            if (skip.x == 0u || n >= samples.last)
                break;
            n = max(floor(n), floor(leaves(samples, cell, float(skip.x) - 1.0))) + 1.0;
        }
        const float end = min(max(leaves(samples, cell, 0.0), n + 0.5), samples.last);
        float plainEnd = end;
#if SCULPTED
        const bool plain = (skip.y & (carvedFlag | segmentFlag)) == 0u;
        const float sculptedEnd = plain ? n : end;
        do {
            const vec3 at = samples.origin + samples.step * n;
#if SEGMENTS
            segmentHit = n < sculptedEnd && isSegment(at);
#endif
            hit = segmentHit || (n < sculptedEnd && isDense(at) && !isCarved(at));
            n = hit || n >= sculptedEnd ? n : floor(n) + 1.0;
        } while (n < sculptedEnd && !hit);
        plainEnd = plain ? end : n;
#endif
        do {
            const bool dense = n < plainEnd && isDense(samples.origin + samples.step * n);
            hit = hit || dense;
            n = hit || n >= plainEnd ? n : floor(n) + 1.0;
        } while (n < plainEnd && !hit);
    } while (n < samples.last && !hit);
    float t = ray.gridZero + n * stepMm;
    // Everything below is executed for all pixels of a group anyway.
    const bool onBox = t - ray.first < stepMm * 0.05;
    float before = max(t - stepMm, ray.first);
    for (int halving = 0; halving < 5; ++halving) {
        const float middle = 0.5 * (before + t);
        const vec3 between = ray.origin + ray.direction * middle;
#if SEGMENTS
        const bool inside = segmentHit ? isSegment(between) : isDense(between) && !isCarved(between);
#elif SCULPTED
        const bool inside = isDense(between) && !isCarved(between);
#else
        const bool inside = isDense(between);
#endif
        before = inside ? before : middle;
        t = inside ? middle : t;
    }
    return Hit(hit ? t : nowhere, segmentHit, onBox);
}

#if CONTEXT == 1
vec3 lookNormal = vec3(0.0); // world, unit: of what lookOf() saw
#endif

/// The colour at a hit.
vec3 lookOf(Ray ray, int piece, Hit hit)
{
    const bool onBox = hit.onBox;
    const bool segmentHit = hit.segment;
    const vec3 at = ray.origin + ray.direction * min(hit.t, ray.last);
#if PIECES
    const vec3 toViewer = asTrue(piece, -ray.world);
#else
    const vec3 toViewer = -ray.world;
#endif
    float value = texture(intensity, at).r;
    const vec3 slope = cubeDifferences(intensity, at, 0.6);
    vec3 normal = normalize(gradientToWorld * -slope + 1e-9 * toViewer);
    vec3 albedo = boneColour;
    float gloss = 0.10;

    // A flat face exists where solid material is cut by a clip plane or by the end of the scan.
    const float flatFace = onBox ? 1.0 : 0.0;
    vec3 cutNormal = faceNormal(ray);
    float cut = flatFace; // how much the normal is that of the cut
    // how much the colour is that of the cut; it begins a little further in, so that edges show no
    // step
    float face = flatFace;
#if SCULPTED
    // The nearer one of the two surfaces decides; in between they blend (distances in voxels).
    const vec3 rise = gapRise(piece, at);
    const float toCut = (0.5 - gapAt(piece, at)) / max(length(rise), 1e-3);
    const float toIso = (value - threshold) / max(length(slope), 1e-5);
    const float carved = length(rise) > 1e-3 ? 1.0 : 0.0;
    cutNormal = onBox ? cutNormal : normalize(gradientToWorld * rise + 1e-9 * toViewer);
    cut = max(cut, carved * smoothstep(-0.4, 0.6, toIso - toCut));
    face = max(face, carved * smoothstep(-0.1, 1.3, toIso - toCut));
    // The material that was cut is right behind the cut: at its rim the surface itself is grey from
    // partial volume.
    const vec3 behindCut = at - worldToTexture * (cutNormal * 0.5 * stepMm);
    value = onBox ? value : max(threshold, texture(intensity, behindCut).r);
#endif
    albedo = mix(albedo, mix(transferAt(value).rgb, faceGrey(value), greyFaces), face);
    normal = normalize(mix(normal, cutNormal, cut) + 1e-6 * toViewer);
    float grey = greyFaces * face;
#if SEGMENTS
    const vec3 inward = segmentRise(ray, at);
    normal = segmentHit && !onBox ? normalize(gradientToWorld * -inward + 1e-9 * toViewer) : normal;
    // If a segment's surface and the tissue's coincide to a fraction of a voxel the segment's
    // colour is shown; otherwise the two would speckle.
    const vec3 behind = at + ray.direction * 2.0 * stepMm;
    const float near = max(segmentationAt(at), segmentationAt(behind));
    float tinted = segmentHit ? 1.0 : smoothstep(0.25, 0.5, near);
#if PIECES
    tinted = piece < 0 ? tinted : 0.0; // segments stay where they are
#endif
    albedo = mix(albedo, segmentColour(segmentHit ? at : behind), tinted);
    meetSegment(tinted > 0.0 && hit.t < nowhere);
    gloss = segmentHit ? 0.22 : gloss;
    grey *= 1.0 - tinted;
#endif
#if PIECES
    if (piece >= 0) {
        const bool solid = isSolid(piece);
        const vec3 outwards = gapRise(piece, at);
        albedo = solid ? pieces[piece].colour.rgb : albedo * pieces[piece].colour.rgb;
        normal = solid && !onBox ? normalize(gradientToWorld * outwards + 1e-9 * toViewer) : normal;
        gloss = solid ? 0.22 : gloss;
        grey = solid ? 0.0 : grey;
    }
#endif
    // A gradient that faces away is noise: it is bent into view instead of giving a black speck.
    const float away = min(dot(normal, toViewer), 0.0);
    normal = normalize(normal - (away - 0.02) * toViewer);
#if CONTEXT == 1
    lookNormal = asShown(piece, normal);
#endif

    const float turn = fract(pixelNoise(gl_FragCoord.yx + 17.0) + jitterPhase) * 6.2831853;
    const vec3 side
        = normalize(cross(normal, abs(normal.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0)));
    const vec3 tilted = normalize(
        normal + aoTilt * (cos(turn) * side + sin(turn) * cross(normal, side)));
    // There is nothing in front of a flat face, whatever the scan holds there. Grey values must be
    // readable, so they are shadowed less.
#if CONTEXT == 2
    const float around = segmentOpenness(at, tilted);
#else
    const float around = openness(piece, at, tilted);
#endif
    const float open = onBox ? 1.0 : mix(around, 1.0, 0.6 * grey);
    const vec4 light = lightOnFace(
        lightOn(asShown(piece, normal), -ray.world, open, gloss), grey, flatFace);
    return lit(albedo, light);
}

#if SHEETS
/// Composites the sheets in front of a place. If a sheet and matter coincide to a fraction of a
/// voxel the sheet is seen; otherwise the two would speckle.
void meetSheetsBefore(float t, inout vec3 seen, inout float through)
{
    meetSheets(t + 2.0 * stepMm, seen, through);
}
#endif

#if CONTEXT == 1
/// The opacity of the context where a ray meets it: a thin layer, which is denser where it is seen
/// aslant, so that its shape is drawn by its outlines.
/// Call it after lookOf().
float layerOpacity(Ray ray, Hit hit)
{
    const float facing = hit.onBox ? 1.0 : max(dot(lookNormal, -ray.world), 0.15);
    return 1.0 - pow(max(1.0 - context, 0.0), 1.0 / facing);
}

/// What a ray meets first in front of a segment. If the surface of the tissue is that of the
/// segment, the segment is seen.
Hit contextHit(Ray ray, float segmentAt)
{
    Hit hit = firstHit(ray);
    hit.t = hit.t + 2.0 * stepMm < segmentAt ? hit.t : nowhere;
    return hit;
}
#endif

#if PIECES
float pieceHit(Ray ray, int piece)
{
    const Samples samples = samplesOf(ray, cellSide);
    float n = (ray.first - ray.gridZero) / stepMm;
    bool hit = false;
    do {
        n = leaveFreeCells(piece, samples, n);
        const float end = min(
            max(leaves(samples, cellOf(samples, n), 0.0), n + 0.5), samples.last);
        do {
            hit = n < end && isPiece(piece, samples.origin + samples.step * n);
            n = hit || n >= end ? n : floor(n) + 1.0;
        } while (n < end && !hit);
    } while (n < samples.last && !hit);
    float t = ray.gridZero + n * stepMm;
    const bool onBox = t - ray.first < stepMm * 0.05;
    float before = max(t - stepMm, ray.first);
    for (int halving = 0; halving < 5; ++halving) {
        const float middle = 0.5 * (before + t);
        const bool inside = isPiece(piece, ray.origin + ray.direction * middle);
        before = inside ? before : middle;
        t = inside ? middle : t;
    }
    return !hit ? nowhere : onBox ? ray.first : t;
}

const int mostHits = 64; // core::DocumentEdits allows no more pieces
#if CONTEXT == 1
const int segmentOf = -2; // place in hits: the segment
#endif

vec3 seenAlong(Ray ray)
{
    // Each piece is hit once: a translucent one shows its front.
    Hit rest = Hit(nowhere, false, false);
#if CONTEXT == 1
    const float segmentAt = findSegment(ray);
    Ray front = ray;
    front.last = min(ray.last, segmentAt);
    if (front.first < front.last)
        rest = contextHit(front, segmentAt);
    float segmentLeft = segmentAt; // nowhere once it was composited
#else
    const Ray front = ray;
    if (ray.first < ray.last)
        rest = firstHit(ray);
#endif
    int met[mostHits];
    float hits[mostHits];
    int metCount = 0;
    for (int k = 0; k < pieceCount; ++k) {
        const Ray own = pieceRay(ray, k);
        if (own.first < own.last) {
            met[metCount] = k;
            ++metCount;
        }
    }
    float nearest = rest.t;
    int next = restOf; // place in hits
    for (int i = 0; i < metCount; ++i) {
        hits[i] = pieceHit(pieceRay(ray, met[i]), met[i]);
        next = hits[i] < nearest ? i : next;
        nearest = min(nearest, hits[i]);
    }
#if CONTEXT == 1
    next = segmentLeft < nearest ? segmentOf : next;
    nearest = min(nearest, segmentLeft);
#elif OVERLAID
    solidFrom = nearest;
#endif
    // Opaque ones are evaluated once: drawing costs far more than finding the next.
    vec3 seen = vec3(0.0);
    float through = 1.0;
    do {
        Ray own = front;
        Hit hit = rest;
        float opacity = 1.0;
        int piece = restOf;
        if (next >= 0) {
            piece = met[next];
            own = pieceRay(ray, piece);
            hit = Hit(nearest, false, nearest <= own.first);
            opacity = pieces[piece].low.w;
            hits[next] = nowhere;
        }
#if SHEETS
        meetSheetsBefore(nearest, seen, through);
#endif
        vec3 look = lookOf(own, piece, hit);
#if CONTEXT == 1 && SEGMENTS
        look = next == segmentOf ? segmentLook(ray, segmentAt) : look;
#endif
#if CONTEXT == 1
        if (next == restOf || (next >= 0 && !isSolid(piece)))
            opacity *= layerOpacity(ray, hit);
#endif
        opacity = nearest < nowhere ? opacity : 0.0;
        seen += opacity > 0.0 ? through * opacity * look : vec3(0.0);
        through *= 1.0 - opacity;
#if CONTEXT == 1
        rest.t = next == restOf ? nowhere : rest.t;
        segmentLeft = next == segmentOf ? nowhere : segmentLeft;
#if OVERLAID
        solidFrom = through < 0.5 ? min(solidFrom, nearest) : solidFrom;
#endif
#endif
        // The rest of the volume is opaque, so nothing is seen behind it.
        nearest = rest.t;
        next = restOf;
        for (int i = 0; i < metCount; ++i) {
            next = hits[i] < nearest ? i : next;
            nearest = min(nearest, hits[i]);
        }
#if CONTEXT == 1
        next = segmentLeft < nearest ? segmentOf : next;
        nearest = min(nearest, segmentLeft);
#endif
    } while (nearest < nowhere && through >= 0.02);
#if SHEETS
    meetSheets(nowhere, seen, through);
#endif
    return seen;
}
#else
#if CONTEXT == 1
vec3 seenInContext(Ray ray)
{
    const float segmentAt = findSegment(ray);
    Ray front = ray;
    front.last = min(ray.last, segmentAt);
    const Hit hit = contextHit(front, segmentAt);
    vec3 seen = vec3(0.0);
    float through = 1.0;
#if SHEETS
    meetSheetsBefore(hit.t, seen, through);
#endif
    const vec3 look = lookOf(front, restOf, hit);
    const float opacity = hit.t < nowhere ? layerOpacity(ray, hit) : 0.0;
    seen += opacity > 0.0 ? through * opacity * look : vec3(0.0);
    through *= 1.0 - opacity;
#if OVERLAID
    solidFrom = through < 0.5 ? min(solidFrom, hit.t) : solidFrom;
#endif
#if SEGMENTS
#if SHEETS
    meetSheetsBefore(segmentAt, seen, through);
#endif
    const vec3 body = segmentLook(ray, segmentAt);
    seen += segmentAt < nowhere ? through * body : vec3(0.0);
    through = segmentAt < nowhere ? 0.0 : through;
#if OVERLAID
    solidFrom = min(solidFrom, segmentAt);
#endif
#endif
#if SHEETS
    meetSheets(nowhere, seen, through);
#endif
    return seen;
}
#endif

vec3 seenAlong(Ray ray)
{
#if SHEETS
    // Nothing is searched behind an opaque sheet.
    ray.last = min(ray.last, opaqueSheetAt() + 2.0 * stepMm);
#endif
#if CONTEXT == 1
    return seenInContext(ray);
#endif
    const Hit hit = firstHit(ray);
#if OVERLAID
    solidFrom = hit.t;
#endif
    const vec3 look = lookOf(ray, restOf, hit);
#if SHEETS
    vec3 seen = vec3(0.0);
    float through = 1.0;
    meetSheetsBefore(hit.t, seen, through);
    seen += hit.t < nowhere ? through * look : vec3(0.0);
    through = hit.t < nowhere ? 0.0 : through;
    meetSheets(nowhere, seen, through);
    return seen;
#else
    return hit.t < nowhere ? look : vec3(0.0);
#endif
}
#endif
