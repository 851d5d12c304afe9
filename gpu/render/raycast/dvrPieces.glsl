// Volume rendering with pieces: everything that a ray meets at one place counts together, whatever
// the order of the pieces, so that they are translucent to each other. Lighting is as in dvr.glsl,
// on groups of samples in which one piece, or the rest of the volume, is dominant.

const int mostMet = 64; // core::DocumentEdits allows no more pieces

/// What a ray passes through: the rest of the volume first, then pieces.
struct Way {
    int piece;
    float first; // number of its first sample
    float last; // one past the number of its last sample
    float next; // there is nothing before this sample
    vec3 origin; // texture: position of sample 0
    vec3 step;   // texture
};
Way ways[mostMet + 1];
int wayCount = 0;

struct Joint {
    vec3 colour; // emitted light of all ways together
    float opacity; // opacity of one step of all ways together
    int owner; // index in `ways` of the dominant one
    int solid; // index in `ways` of a solid surface here, −1: none
};

void meet(Ray own, int piece)
{
    if (own.first >= own.last)
        return;
    const float first = floor((own.first - own.gridZero) / stepMm) + 1.0;
    ways[wayCount] = Way(piece, first, (own.last - own.gridZero) / stepMm, first,
        own.origin + own.direction * own.gridZero, own.direction * stepMm);
    ++wayCount;
}

/// As samplesOf() has it.
Samples samplesOfWay(int way)
{
    Samples samples;
    const vec3 cellsPerTexture = 1.0 / (voxel * cellSide);
    samples.origin = ways[way].origin;
    samples.step = ways[way].step;
    samples.last = ways[way].last;
    samples.cellOrigin = samples.origin * cellsPerTexture - 0.5 / cellSide;
    samples.cellStep = samples.step * cellsPerTexture;
    const vec3 tiny = vec3(1e-9);
    samples.leavePerCell
        = 1.0 / mix(samples.cellStep, tiny, lessThan(abs(samples.cellStep), tiny));
    samples.leaveOrigin
        = (vec3(greaterThan(samples.leavePerCell, vec3(0.0))) - samples.cellOrigin)
        * samples.leavePerCell;
    return samples;
}

/// @return the first sample at or after n that is in no free cell
float leaveFree(Samples samples, int piece, float n)
{
    if (piece >= 0)
        return leaveFreeCells(piece, samples, n);
    for (;;) {
        const vec3 cell = cellOf(samples, n);
        const float distance = float(skipAt(cell).x);
        if (distance == 0.0 || n >= samples.last)
            break;
        n = max(n, floor(leaves(samples, cell, distance - 1.0))) + 1.0;
    }
    return n;
}

/// Skips free cells.
/// @return the first sample at or after n that may show something
/// @param until out: up to here no way enters another cell that may be free
float soonest(float n, out float until)
{
    float next = nowhere;
    until = nowhere;
    for (int i = 0; i < wayCount; ++i) {
        const Samples samples = samplesOfWay(i);
        const float from = max(ways[i].next, n);
        float free = from;
        if (from <= n && from < ways[i].last)
            free = leaveFree(samples, ways[i].piece, from);
        ways[i].next = free;
        const bool ends = free >= ways[i].last;
        next = min(next, ends ? nowhere : free);
        until = min(until, ends ? nowhere : max(leaves(samples, cellOf(samples, free), 0.0), free));
    }
    return next;
}

/// The next way after one that may have something at sample n; −1: none. Skips ways cheaply, since
/// the cost of a sample is spent on the result only.
int wayAt(float n, int after)
{
    int found = -1;
    for (int i = wayCount - 1; i > after; --i)
        found = ways[i].next <= n && n < ways[i].last ? i : found;
    return found;
}

/// What all ways together have at sample n, for which soonest() of it or of an earlier sample was
/// called.
Joint jointAt(float n)
{
    Joint joint = Joint(vec3(0.0), 0.0, 0, -1);
    float most = 0.0;
    float through = 1.0;
    vec3 sum = vec3(0.0);
    float weight = 0.0;
    int found = wayAt(n, -1);
    do {
        const bool here = found >= 0;
        const int i = max(found, 0);
        const int piece = ways[i].piece;
        const vec3 at = ways[i].origin + ways[i].step * n;
        const float code = texture(intensity, at).r;
        const float carved = texture(radiation, at).r;
        vec4 colour = transferAt(code);
        float own = 0.0;
        float kept = 1.0;
        bool solid = false;
        if (piece < 0) {
            solid = segmentationAt(at) >= 0.5;
            kept = solid ? 0.0 : 1.0 - smoothstep(0.45, 0.55, carved);
        } else {
            own = footprintAt(piece, at);
            const bool body = isSolid(piece);
            solid = body && own >= 0.5;
            kept = body ? 0.0 : opacityAt(piece, own) * smoothstep(0.45, 0.55, own);
            const float row = pieces[piece].atlasHigh.w;
            const float last = float(textureSize(pieceTransfers, 0).x - 1);
            const float entry = code * pieces[piece].cellLow.w + pieces[piece].cellHigh.w;
            const vec4 special = texelFetch(
                pieceTransfers, ivec2(clamp(entry, 0.0, last), int(max(row, 0.0))), 0);
            colour = row >= 0.0 ? special : colour;
            // Magnified matter keeps its density.
            const float shrink = pieces[piece].high.w;
            colour.a = shrink == 1.0 ? colour.a : 1.0 - pow(1.0 - colour.a, shrink);
            colour.rgb *= pieces[piece].colour.rgb;
        }
        float face = nearCarved(gapOf(piece, own, carved, at));
#if CLIPPED
        face = max(face, nearFace(n - ways[i].first + 1.0));
#endif
        colour.rgb = mix(colour.rgb, faceGrey(code), face * greyFaces);
        const float opacity = here ? colour.a * kept : 0.0;
        sum += opacity * colour.rgb;
        weight += opacity;
        through *= 1.0 - opacity;
        joint.solid = here && solid && joint.solid < 0 ? i : joint.solid;
        joint.owner = opacity > most ? i : joint.owner;
        most = max(most, opacity);
        found = here ? wayAt(n, found) : -1;
    } while (found >= 0);
    joint.opacity = 1.0 - through;
    joint.colour = weight > 0.0 ? sum * (joint.opacity / weight) : vec3(0.0);
    return joint;
}

vec4 lightAt(Ray ray, int way, float n, float change)
{
    const int piece = ways[way].piece;
    const vec3 at = ways[way].origin + ways[way].step * n;
    vec3 rise = tetrahedronDifferences(intensity, at);
    const vec3 gap = gapRise(piece, at);
    float face = nearCarved(gapAt(piece, at)) * smoothstep(0.02, 0.10, length(gap));
    vec3 faceRise = -gap / max(length(gap), 1e-6);
#if CLIPPED
    Ray own = ray;
    if (piece >= 0)
        own = pieceRay(ray, piece);
    const vec3 gateRise = normalize(transpose(textureToWorld) * -faceNormal(own) * voxel);
    const float clipped = nearFace(n - ways[way].first + 1.0) * (change > 1e-6 ? 1.0 : 0.0);
    faceRise = mix(faceRise, gateRise, clipped);
    face = max(face, clipped);
#endif
    rise = mix(rise, faceRise * gradientFull, face);
    const vec3 slope = gradientToWorld * -rise;
    const vec3 normal = asShown(piece, slope * inversesqrt(max(dot(slope, slope), 1e-16)));
    const vec3 front = dot(normal, -ray.world) < 0.0 ? -normal : normal;
    return mix(unlit, lightOn(front, -ray.world, 1.0, 0.10),
        clamp(length(rise) / gradientFull, 0.0, 1.0));
}

/// The colour of the surface of a segment, or of a solid piece.
vec3 solidAt(Ray ray, int way, float n)
{
    const int piece = ways[way].piece;
    const vec3 at = ways[way].origin + ways[way].step * n;
    vec3 inward = vec3(0.0);
    vec3 colour = vec3(0.0);
    if (piece < 0) {
        inward = segmentRise(ray, at);
        colour = segmentColour(at);
    } else {
        inward = footprintRise(piece, at);
        colour = pieces[piece].colour.rgb;
    }
    const vec3 outward
        = asShown(piece, normalize(gradientToWorld * -inward + 1e-9 * asTrue(piece, -ray.world)));
    return lit(colour, lightOn(outward, -ray.world, 1.0, 0.22));
}

vec3 seenAlong(Ray ray)
{
    const float enough = 0.02;
    wayCount = 0;
    meet(ray, restOf);
    for (int k = 0; k < pieceCount; ++k)
        meet(pieceRay(ray, k), k);
    if (wayCount == 0) {
        vec3 nothing = vec3(0.0);
#if SHEETS
        float all = 1.0;
        meetSheets(nowhere, nothing, all);
#endif
        return nothing;
    }
#if CONTEXT == 1
    if (wayCount == 1 && ways[0].piece < 0)
        return restAlong(ray);
    const float segmentAt = findSegment(ray);
#endif
    if (wayCount == 1 && ways[0].piece < 0)
        return restAlong(ray);
    float n = nowhere;
    float last = -nowhere;
    for (int i = 0; i < wayCount; ++i) {
        n = min(n, ways[i].first);
        last = max(last, ways[i].last);
    }
#if CONTEXT == 1
    last = min(last, (segmentAt - ray.gridZero) / stepMm);
#endif
    vec3 seen = vec3(0.0);
    float through = 1.0;
    vec4 light = unlit;
    float lastOpacity = 0.0;
    const float firstGroup
        = 1.0 + floor(samplesPerGroup * fract(pixelNoise(gl_FragCoord.yx + 31.0) + jitterPhase));
    // Surfaces of segments and solid pieces are rare and costly, so each ends the inner loop.
    do {
        int solid = -1;
        do {
            const float start = n;
            Joint joint;
            bool found = false;
            do {
                float until;
                n = soonest(n, until);
                do {
                    joint = jointAt(n);
                    found = joint.opacity > 0.0 || joint.solid >= 0;
                    n += found || n >= last ? 0.0 : 1.0;
                } while (!found && n < until && n < last);
            } while (!found && n < last);
            lastOpacity = n > start ? 0.0 : lastOpacity;
            float groupEnd = min(last, n + (n > start ? firstGroup : samplesPerGroup) - 0.5);
#if SHEETS
            meetSheetsBefore(n, ray.gridZero, seen, through);
            groupEnd = min(groupEnd, sheetSample(ray.gridZero));
#endif
            const int owner = joint.owner;
            vec3 glow = vec3(0.0);
            float glowOpacity = 0.0;
            float groupThrough = 1.0;
            float change = 0.0;
            float changeAt = 0.0;
            float most = 1e-4;
            bool goesOn = found;
            do {
                const float opacity = goesOn ? joint.opacity : 0.0;
                glow += goesOn ? groupThrough * joint.colour : vec3(0.0);
                glowOpacity += groupThrough * opacity;
                groupThrough *= 1.0 - opacity;
                const float jump = goesOn ? abs(opacity - lastOpacity) * groupThrough : 0.0;
                change += jump;
                changeAt += jump * n;
                most = max(most, max(opacity, lastOpacity));
                lastOpacity = goesOn ? opacity : lastOpacity;
                solid = goesOn ? joint.solid : -1;
                n += goesOn && solid < 0 ? 1.0 : 0.0;
                joint = jointAt(n);
                goesOn = goesOn && solid < 0 && n < groupEnd && through * groupThrough > enough
                    && (joint.opacity <= 0.0 || joint.owner == owner);
            } while (goesOn);
            const float changeN = change > 1e-6 ? changeAt / change : n;
            light = mix(
                light, lightAt(ray, owner, changeN, change), clamp(change / most, 0.0, 1.0));
            seen += through * shareOfContext() * (glow * light.rgb + glowOpacity * light.a);
            through *= groupThrough;
#if OVERLAID
            solidFrom = solidFrom == nowhere && leftBehind(through) < 0.5 ? ray.gridZero + stepMm * n : solidFrom;
#endif
        } while (solid < 0 && n < last && leftBehind(through) > enough);
        const int way = max(solid, 0);
        const int piece = ways[way].piece;
        const float opacity = solid < 0 ? 0.0 : piece < 0 ? 1.0 : pieces[piece].low.w;
        const float left = leftBehind(through);
        seen += opacity > 0.0 ? left * opacity * solidAt(ray, way, n) : vec3(0.0);
        meetSegment(solid >= 0 && piece < 0);
#if CONTEXT == 1
        besides *= 1.0 - opacity;
#else
        through *= 1.0 - opacity;
#endif
        if (solid >= 0) {
            ways[way].last = -nowhere; // only the front of a translucent one is seen
            n += 1.0;
        }
#if OVERLAID
        solidFrom
            = solidFrom == nowhere && leftBehind(through) < 0.5 ? ray.gridZero + stepMm * n : solidFrom;
#endif
    } while (n < last && leftBehind(through) > enough);
#if CONTEXT == 1
    return withSegment(ray, segmentAt, seen, through > enough ? through : 0.0);
#endif
#if SHEETS
    through = through > enough ? through : 0.0;
    meetSheets(nowhere, seen, through);
#endif
    return seen;
}
