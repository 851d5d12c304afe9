// Volume rendering with pieces: all that a ray meets at one place counts at once, whatever the order
// of the pieces, so that they are translucent to each other. Light falls as in dvr.glsl, on groups
// of samples of which one piece, or the rest of the volume, shows most.

const int mostMet = 64; // core::DocumentEdits allows no more pieces

/// What one ray meets: the rest of the volume first, then pieces.
struct Way {
    int piece;
    float first; // number of its first sample
    float last;  // it ends before
    float next;  // before this one there is nothing
    vec3 origin; // texture: of sample 0
    vec3 step;   // texture
};
Way ways[mostMet + 1];
int wayCount = 0;

struct Joint {
    vec3 colour;   // light that all of it gives
    float opacity; // of one step, of all
    int owner;     // place in ways of what shows most
    int solid;     // place in ways of a solid surface here, −1: none
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

/// @return number of the first sample at or after n that is in no free cell
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

/// Leaves free cells behind. @return the first sample at or after n that may show something
float soonest(float n)
{
    float next = nowhere;
    for (int i = 0; i < wayCount; ++i) {
        const float from = max(ways[i].next, n);
        float free = from;
        if (from <= n && from < ways[i].last)
            free = leaveFree(samplesOfWay(i), ways[i].piece, from);
        ways[i].next = free;
        next = min(next, free < ways[i].last ? free : nowhere);
    }
    return next;
}

/// The next of the ways after one on which something may be at n; −1: none. Few looks: what a
/// sample costs is done for these only.
int wayAt(float n, int after)
{
    int found = -1;
    for (int i = wayCount - 1; i > after; --i)
        found = ways[i].next <= n && n < ways[i].last ? i : found;
    return found;
}

/// What all ways have at sample n, where soonest(n) has been.
Joint jointAt(float n)
{
    Joint joint = Joint(vec3(0.0), 0.0, 0, -1);
    float most = 0.0;
    float through = 1.0;
    vec3 sum = vec3(0.0);
    float weight = 0.0;
    for (int i = wayAt(n, -1); i >= 0; i = wayAt(n, i)) {
        const int piece = ways[i].piece;
        const Samples samples = samplesOfWay(i);
        const vec3 at = samples.origin + samples.step * n;
        const float code = texture(intensity, at).r;
        vec4 colour = transferAt(code);
        const float gap = gapAt(piece, at);
        float kept = 1.0;
        if (piece < 0) {
            const bool segment = texture(segmentation, at).r >= 0.5;
            kept = segment ? 0.0 : 1.0 - smoothstep(0.45, 0.55, texture(radiation, at).r);
            joint.solid = segment ? i : joint.solid;
        } else {
            const float own = footprintAt(piece, at);
            if (isSolid(piece)) {
                kept = 0.0;
                joint.solid = own >= 0.5 && joint.solid < 0 ? i : joint.solid;
            } else {
                kept = pieces[piece].low.w * smoothstep(0.45, 0.55, own);
                const float row = pieces[piece].atlasHigh.w;
                if (row >= 0.0) {
                    const float last = float(textureSize(pieceTransfers, 0).x - 1);
                    const float entry = code * pieces[piece].cellLow.w + pieces[piece].cellHigh.w;
                    colour = texelFetch(
                        pieceTransfers, ivec2(clamp(entry, 0.0, last), int(row)), 0);
                }
                // Magnified matter is as dense as it was.
                const float shrink = pieces[piece].high.w;
                colour.a = shrink == 1.0 ? colour.a : 1.0 - pow(1.0 - colour.a, shrink);
                colour.rgb *= pieces[piece].colour.rgb;
            }
        }
        float face = nearCarved(gap);
#if CLIPPED
        face = max(face, nearFace(n - ways[i].first + 1.0));
#endif
        colour.rgb = mix(colour.rgb, faceGrey(code), face * greyFaces);
        const float opacity = colour.a * kept;
        sum += opacity * colour.rgb;
        weight += opacity;
        through *= 1.0 - opacity;
        joint.owner = opacity > most ? i : joint.owner;
        most = max(most, opacity);
    }
    joint.opacity = 1.0 - through;
    joint.colour = weight > 0.0 ? sum * (joint.opacity / weight) : vec3(0.0);
    return joint;
}

vec4 lightAt(Ray ray, int way, float n, float change)
{
    const int piece = ways[way].piece;
    const Samples samples = samplesOfWay(way);
    const vec3 at = samples.origin + samples.step * n;
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

/// Colour of the surface of a segment, or of a solid piece.
vec3 solidAt(Ray ray, int way, float n)
{
    const int piece = ways[way].piece;
    const Samples samples = samplesOfWay(way);
    const vec3 at = samples.origin + samples.step * n;
    vec3 inward = vec3(0.0);
    vec3 colour = vec3(0.0);
    if (piece < 0) {
        inward = centralDifferences(segmentation, at, 1.0);
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
    if (wayCount == 0)
        return vec3(0.0);
    if (wayCount == 1 && ways[0].piece < 0)
        return restAlong(ray);
    float n = nowhere;
    float last = -nowhere;
    for (int i = 0; i < wayCount; ++i) {
        n = min(n, ways[i].first);
        last = max(last, ways[i].last);
    }
    vec3 seen = vec3(0.0);
    float through = 1.0;
    vec4 light = unlit;
    float lastOpacity = 0.0;
    const float firstGroup
        = 1.0 + floor(samplesPerGroup * fract(pixelNoise(gl_FragCoord.yx + 31.0) + jitterPhase));
    while (n < last && through > enough) {
        const float start = n;
        n = soonest(n);
        Joint joint = jointAt(n);
        while (joint.opacity <= 0.0 && joint.solid < 0 && n < last) {
            n = soonest(n + 1.0);
            joint = jointAt(n);
        }
        if (n >= last)
            break;
        lastOpacity = n > start ? 0.0 : lastOpacity;
        const float groupEnd = min(last, n + (n > start ? firstGroup : samplesPerGroup) - 0.5);
        const int owner = joint.owner;
        vec3 glow = vec3(0.0);
        float glowOpacity = 0.0;
        float groupThrough = 1.0;
        float change = 0.0;
        float changeAt = 0.0;
        float most = 1e-4;
        int solid = -1;
        do {
            const float share = groupThrough * joint.opacity;
            glow += groupThrough * joint.colour;
            glowOpacity += share;
            groupThrough *= 1.0 - joint.opacity;
            const float jump = abs(joint.opacity - lastOpacity) * groupThrough;
            change += jump;
            changeAt += jump * n;
            most = max(most, max(joint.opacity, lastOpacity));
            lastOpacity = joint.opacity;
            solid = joint.solid;
            if (solid >= 0)
                break;
            n += 1.0;
            soonest(n);
            joint = jointAt(n);
        } while (n < groupEnd && through * groupThrough > enough
            && (joint.opacity <= 0.0 || joint.owner == owner));
        const float changeN = change > 1e-6 ? changeAt / change : n;
        light = mix(light, lightAt(ray, owner, changeN, change), clamp(change / most, 0.0, 1.0));
        seen += through * (glow * light.rgb + glowOpacity * light.a);
        through *= groupThrough;
        if (solid >= 0) {
            const int piece = ways[solid].piece;
            const float opacity = piece < 0 ? 1.0 : pieces[piece].low.w;
            seen += through * opacity * solidAt(ray, solid, n);
            through *= 1.0 - opacity;
            ways[solid].last = -nowhere; // of a translucent one the front is seen
            n += 1.0;
        }
    }
    return seen;
}
