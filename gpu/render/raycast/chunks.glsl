// Chunks of a box (core/chunks) as translucent bodies: faces where a ray goes from one chunk into
// another, and a section where it enters the box or is clipped. Chunks behind tissue shine through
// faintly; nothing shines through the cutting plane, which shows its own section. Where they are
// known by cells of several voxels, "voxels" below are these cells.

/* Textures */
layout(binding = 24) uniform usampler3D chunkLeaves; // leaf + 1 by cell of their box
layout(binding = 25) uniform sampler2D chunkColours; // by leaf; all 0: invisible; above it the rims
layout(binding = 26) uniform sampler3D chunkBodies; // smoothed colours of voxels
layout(binding = 27) uniform usampler3D chunkCells; // 0: the cell has a single colour

/* Uniforms */
uniform ivec3 chunkOrigin; // index: the box, up to one before the second
uniform ivec3 chunkEnd;
uniform ivec3 chunkCell;   // voxels
uniform float chunkOpacity;

const float chunkBehind = 0.25;
const float chunkCellSide = 8.0;
const float chunkTie = 0.02; // mm: up to this far behind the plane counts as not behind it
const float chunkEnough = 0.04; // a lower transmittance does not count
// Chunks with a rim have it where they are seen obliquely: wholly below the first, not beyond the
// second (cosine of the angle between the boundary's normal and the viewer).
const float chunkRimInner = 0.30;
const float chunkRimOuter = 0.50;

vec4 chunkBodyAt(vec3 place)
{
    return texture(chunkBodies, (place + 0.5) / vec3(textureSize(chunkBodies, 0)));
}

/// The colour of the chunk at a place (index of the box), with smooth boundaries: of the chunks
/// around it the one whose colour is nearest to the smoothed one.
/// @param nearness 0: inside … 0.5: at the boundary between two
/// @param rim of that chunk, all 0: none
vec4 chunkColourAt(vec3 place, vec4 seen, out float nearness, out vec4 rim)
{
    const ivec3 base = ivec3(floor(place));
    const ivec3 last = textureSize(chunkLeaves, 0) - 1;
    vec4 own = vec4(0.0);
    float least = 1e9;
    float other = 1e9;
    uint ownLeaf = 0u;
    for (int corner = 0; corner < 8; ++corner) {
        const ivec3 offset = ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
        const uint leaf
            = texelFetch(chunkLeaves, clamp(base + offset, ivec3(0), last), 0).r;
        const vec4 colour = texelFetch(chunkColours, ivec2(int(leaf), 0), 0);
        const float off = distance(colour, seen);
        const bool nearer = off < least;
        other = nearer && colour != own ? least : colour != own ? min(other, off) : other;
        own = nearer ? colour : own;
        ownLeaf = nearer ? leaf : ownLeaf;
        least = min(least, off);
    }
    nearness = other < 1e8 ? least / max(least + other, 1e-6) : 0.0;
    rim = texelFetch(chunkColours, ivec2(int(ownLeaf), 1), 0);
    return own;
}

/// The unit normal (world) of a boundary, opposite to the direction in which the colour changes.
vec3 chunkNormal(vec3 place, vec4 change)
{
    const float h = 1.5;
    const vec3 rise = vec3(
        dot(chunkBodyAt(place + vec3(h, 0, 0)) - chunkBodyAt(place - vec3(h, 0, 0)), change),
        dot(chunkBodyAt(place + vec3(0, h, 0)) - chunkBodyAt(place - vec3(0, h, 0)), change),
        dot(chunkBodyAt(place + vec3(0, 0, h)) - chunkBodyAt(place - vec3(0, 0, h)), change));
    const vec3 slope = gradientToWorld * (-rise / vec3(chunkCell));
    return slope * inversesqrt(max(dot(slope, slope), 1e-16));
}

/// Adds the chunks to what is seen: those in front of it, and those behind it faintly.
vec3 withChunks(Ray ray, vec3 seen)
{
    // The last cells may be cut off.
    const vec3 size = vec3(chunkEnd - chunkOrigin) / vec3(chunkCell);
    const vec3 side = voxel * vec3(chunkCell);
    const vec3 origin // index of the box
        = ray.origin / side - 0.5 - vec3(chunkOrigin) / vec3(chunkCell);
    const vec3 direction = ray.direction / side;
    const vec3 inverse = ray.inverse * side;
    const vec3 toLow = (vec3(-0.5) - origin) * inverse;
    const vec3 toHigh = (size - 0.5 - origin) * inverse;
    const vec3 enter = min(toLow, toHigh);
    const vec3 leave = max(toLow, toHigh);
    const float entry = max(max(enter.x, enter.y), enter.z);
    const float first = max(ray.first, entry);
    const float last = min(ray.last, min(min(leave.x, leave.y), leave.z));
    float solid = solidFrom + 3.0 * stepMm;
    float open = 1.0; // how much of what lies behind no plane hides
    float openGate = 1.0; // the same for the section
#if SHEETS
    const vec2 plane = planeHere(); // t
    const bool planeSeen = plane.y <= solid;
    open = planeSeen ? 1.0 - plane.x : 1.0;
    openGate = planeSeen && first > plane.y - chunkTie ? open : 1.0;
    solid = planeSeen && plane.x >= 0.5 ? min(solid, plane.y + chunkTie) : solid;
#endif
    const vec3 toViewer = -ray.world;

    // What lies in front of matter, and what behind; alpha is the transmittance.
    vec4 front = vec4(0.0, 0.0, 0.0, 1.0);
    vec4 behind = vec4(0.0, 0.0, 0.0, 1.0);

    // The section is drawn as on a slice, with a line where two chunks meet.
    const vec3 gate = origin + direction * (first + 1e-3 * stepMm);
    float nearness;
    vec4 rimNow;
    vec4 now = chunkColourAt(gate, chunkBodyAt(gate), nearness, rimNow);
    {
        const float line = smoothstep(0.20, 0.34, nearness);
        const float rim = rimNow.a * line;
        const float plain = min(chunkOpacity * (1.4 + 1.2 * line), 1.0) * now.a;
        const float share = first < last ? mix(plain, 1.0, rim) * openGate : 0.0;
        const vec3 look = now.rgb * share * mix(0.92, 0.7, line);
        const vec4 face = vec4(mix(look, rimNow.rgb * share, rim), 1.0 - share);
        const bool hidden = first > solid;
        front = hidden ? front : face;
        behind = hidden ? face : behind;
    }

    float t = first + stepMm * (0.2 + 0.8 * fract(pixelNoise(gl_FragCoord.xy) + jitterPhase));
    for (;;) {
        // Goes on to where the colour begins to differ from that of the body.
        bool off = false;
        vec4 colour = now;
        for (;;) {
            if (off || t >= last)
                break;
            const vec3 place = origin + direction * t;
            const vec3 cell = floor(max(place, 0.0) / chunkCellSide);
            const bool mixed = texelFetch(chunkCells, ivec3(cell), 0).r != 0u;
            colour = chunkBodyAt(place);
            const vec4 change = colour - now;
            off = dot(change, change) > 0.004;
            const vec3 border
                = (cell + vec3(greaterThan(inverse, vec3(0.0)))) * chunkCellSide;
            const vec3 times = (border - origin) * inverse;
            const float leaving = min(min(times.x, times.y), times.z);
            t = off ? t : mixed ? t + stepMm : max(t, leaving) + 0.05 * stepMm;
        }
        if (!off)
            break;
        const vec3 place = origin + direction * t;
        float unused;
        vec4 rimNext;
        const vec4 next = chunkColourAt(place, colour, unused, rimNext);
        const bool meets = next != now;
        vec3 normal = chunkNormal(place, next - now);
        normal = dot(normal, toViewer) < 0.0 ? -normal : normal;
        const bool parts = next.a == 0.0; // from the last body there
        const vec4 body = parts ? now : next;
        // A wall seen obliquely is thicker; the far wall of a body is seen through the body.
        const float thick = 1.0 / max(dot(normal, toViewer), 0.3);
        const float wall = chunkOpacity * body.a * (parts ? 0.5 : 1.0);
        const vec4 rimThere = parts ? rimNow : rimNext;
        // Where the colour does not change, as in a sheet of one voxel, no direction is known.
        const float rim = rimThere.a * step(0.25, dot(normal, normal))
            * (1.0 - smoothstep(chunkRimInner, chunkRimOuter, dot(normal, toViewer)));
        const float plain = 1.0 - pow(1.0 - min(wall, 0.98), thick);
        const float share = meets ? mix(plain, 1.0, rim) : 0.0;
        const vec3 shaded = lit(body.rgb, lightOn(normal, toViewer, 1.0, 0.25)) * share;
        const vec3 look = mix(shaded, rimThere.rgb * share, rim);
        if (t > solid)
            behind = vec4(behind.rgb + behind.a * look, behind.a * (1.0 - share));
        else
            front = vec4(front.rgb + front.a * look, front.a * (1.0 - share));
        now = next;
        rimNow = rimNext;
        t += stepMm;
        if (t >= last || front.a < chunkEnough || behind.a < chunkEnough)
            break;
    }
    const vec3 back = mix(seen, behind.rgb + behind.a * seen, chunkBehind * open);
    return front.rgb + front.a * back;
}
