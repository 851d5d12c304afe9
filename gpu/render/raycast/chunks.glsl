// Chunks of a box (core/chunks) as translucent bodies: faces where a ray goes from one into another,
// and the section where it enters the box or is clipped. What lies behind tissue shines through
// faintly; nothing does through the cutting plane, which shows its own section.

/* Textures */
layout(binding = 24) uniform usampler3D chunkLeaves; // of their box
layout(binding = 25) uniform sampler2D chunkColours; // row by leaf, all 0: not to be seen
layout(binding = 26) uniform sampler3D chunkBodies;  // colours of voxels, smoothed
layout(binding = 27) uniform usampler3D chunkCells;  // 0: of one colour

/* Uniforms */
uniform ivec3 chunkOrigin; // index
uniform float chunkOpacity;

const float chunkBehind = 0.25;
const float chunkCellSide = 8.0;
const float chunkTie = 0.02; // mm: as far behind the plane is not behind it
const float chunkEnough = 0.04; // what is let through less does not count

vec4 chunkBodyAt(vec3 place)
{
    return texture(chunkBodies, (place + 0.5) / vec3(textureSize(chunkBodies, 0)));
}

/// The colour of the chunk that a place (index of the box) lies in, boundaries smoothed: of those
/// around it the one that is nearest to what is seen there.
/// @param nearness 0: inside … 0.5: where two meet
vec4 chunkColourAt(vec3 place, vec4 seen, out float nearness)
{
    const ivec3 base = ivec3(floor(place));
    const ivec3 last = textureSize(chunkLeaves, 0) - 1;
    vec4 own = vec4(0.0);
    float least = 1e9;
    float other = 1e9;
    for (int corner = 0; corner < 8; ++corner) {
        const ivec3 offset = ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
        const uint leaf
            = texelFetch(chunkLeaves, clamp(base + offset, ivec3(0), last), 0).r;
        const vec4 colour = texelFetch(chunkColours, ivec2(int(leaf), 0), 0);
        const float off = distance(colour, seen);
        const bool nearer = off < least;
        other = nearer && colour != own ? least : colour != own ? min(other, off) : other;
        own = nearer ? colour : own;
        least = min(least, off);
    }
    nearness = other < 1e8 ? least / max(least + other, 1e-6) : 0.0;
    return own;
}

/// World, unit, against the way in which a colour turns into another one.
vec3 chunkNormal(vec3 place, vec4 change)
{
    const float h = 1.5;
    const vec3 rise = vec3(
        dot(chunkBodyAt(place + vec3(h, 0, 0)) - chunkBodyAt(place - vec3(h, 0, 0)), change),
        dot(chunkBodyAt(place + vec3(0, h, 0)) - chunkBodyAt(place - vec3(0, h, 0)), change),
        dot(chunkBodyAt(place + vec3(0, 0, h)) - chunkBodyAt(place - vec3(0, 0, h)), change));
    const vec3 slope = gradientToWorld * -rise;
    return slope * inversesqrt(max(dot(slope, slope), 1e-16));
}

/// What is seen with the chunks before it, and those behind it faintly.
vec3 withChunks(Ray ray, vec3 seen)
{
    const vec3 size = vec3(textureSize(chunkLeaves, 0));
    const vec3 origin = ray.origin / voxel - 0.5 - vec3(chunkOrigin); // index of the box
    const vec3 direction = ray.direction / voxel;
    const vec3 inverse = ray.inverse * voxel;
    const vec3 toLow = (vec3(-0.5) - origin) * inverse;
    const vec3 toHigh = (size - 0.5 - origin) * inverse;
    const vec3 enter = min(toLow, toHigh);
    const vec3 leave = max(toLow, toHigh);
    const float entry = max(max(enter.x, enter.y), enter.z);
    const float first = max(ray.first, entry);
    const float last = min(ray.last, min(min(leave.x, leave.y), leave.z));
    float solid = solidFrom + 3.0 * stepMm;
    float open = 1.0; // so much no plane hides of what lies behind
    float openGate = 1.0; // and of the section
#if SHEETS
    const vec2 plane = planeHere(); // t
    const bool planeSeen = plane.y <= solid;
    open = planeSeen ? 1.0 - plane.x : 1.0;
    openGate = planeSeen && first > plane.y - chunkTie ? open : 1.0;
    solid = planeSeen && plane.x >= 0.5 ? min(solid, plane.y + chunkTie) : solid;
#endif
    const vec3 toViewer = -ray.world;

    // What is before matter, and what behind; a: lets through.
    vec4 front = vec4(0.0, 0.0, 0.0, 1.0);
    vec4 behind = vec4(0.0, 0.0, 0.0, 1.0);

    // The section: as on a slice, with a line where two meet.
    const vec3 gate = origin + direction * (first + 1e-3 * stepMm);
    float nearness;
    vec4 now = chunkColourAt(gate, chunkBodyAt(gate), nearness);
    {
        const float line = smoothstep(0.20, 0.34, nearness);
        const float share
            = first < last ? min(chunkOpacity * (1.4 + 1.2 * line), 1.0) * now.a * openGate : 0.0;
        const vec4 face = vec4(now.rgb * share * mix(0.92, 0.7, line), 1.0 - share);
        const bool hidden = first > solid;
        front = hidden ? front : face;
        behind = hidden ? face : behind;
    }

    float t = first + stepMm * (0.2 + 0.8 * fract(pixelNoise(gl_FragCoord.xy) + jitterPhase));
    for (;;) {
        // To where the colour is not quite that of the body any more.
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
        const vec4 next = chunkColourAt(place, colour, unused);
        const bool meets = next != now;
        vec3 normal = chunkNormal(place, next - now);
        normal = dot(normal, toViewer) < 0.0 ? -normal : normal;
        const bool parts = next.a == 0.0; // from the last body there
        const vec4 body = parts ? now : next;
        // Seen aslant a wall is thicker; the far one of a body is seen through it.
        const float thick = 1.0 / max(dot(normal, toViewer), 0.3);
        const float wall = chunkOpacity * body.a * (parts ? 0.5 : 1.0);
        const float share = meets ? 1.0 - pow(1.0 - min(wall, 0.98), thick) : 0.0;
        const vec3 look = lit(body.rgb, lightOn(normal, toViewer, 1.0, 0.25)) * share;
        if (t > solid)
            behind = vec4(behind.rgb + behind.a * look, behind.a * (1.0 - share));
        else
            front = vec4(front.rgb + front.a * look, front.a * (1.0 - share));
        now = next;
        t += stepMm;
        if (t >= last || front.a < chunkEnough || behind.a < chunkEnough)
            break;
    }
    const vec3 back = mix(seen, behind.rgb + behind.a * seen, chunkBehind * open);
    return front.rgb + front.a * back;
}
