// Translucent bodies of voxels beside the segments, whose front is seen: barriers, and what another
// interval has suspended. How a ray walks to them is the same; isOfBody() and bodyHasBrick() tell
// them apart. Include render/raycast/raycast.glsl before this file.

#if BARRIERS
/* Textures */
layout(binding = 18) uniform usampler3D barrierBricks; // 1: the brick holds barriers
#endif

const int barrierBody = 0;
const int suspendedBody = 1;
const float bodyBrick = 16.0;

/// Where a ray meets a body.
struct MetBody
{
    bool found;
    bool hidden; // by tissue
    vec3 normal; // world; defined if found
};

bool isOfBody(int kind, ivec3 there)
{
    bool is = false;
#if BARRIERS
    if (kind == barrierBody)
        is = wordAt(there) == barrierWord;
#endif
#if CUT_PREVIEW == 2
    if (kind == suspendedBody)
        is = previewMarkAt(there) == growthSuspended;
#endif
    return is;
}

/// Whether a brick, clamped to those that there are, may hold any of it.
bool bodyHasBrick(int kind, vec3 inBricks)
{
    bool has = false;
#if BARRIERS
    if (kind == barrierBody) {
        const ivec3 last = textureSize(barrierBricks, 0) - 1;
        has = texelFetch(barrierBricks, clamp(ivec3(inBricks), ivec3(0), last), 0).r != 0u;
    }
#endif
#if CUT_PREVIEW == 2
    if (kind == suspendedBody) {
        const ivec3 last = textureSize(cutPreviewPages, 0) - 1;
        has = texelFetch(cutPreviewPages, clamp(ivec3(inBricks), ivec3(0), last), 0).r != 0u;
    }
#endif
    return has;
}

/// 1 at the centre of a voxel of the body, interpolated to 0 at the centre of another.
float bodyAt(int kind, vec3 place)
{
    const ivec3 base = ivec3(floor(place));
    const vec3 part = place - vec3(base);
    const ivec3 last = textureSize(labels, 0) - 1;
    float sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const ivec3 offset = ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
        const vec3 share = mix(1.0 - part, part, vec3(offset));
        const bool is = isOfBody(kind, clamp(base + offset, ivec3(0), last));
        sum += is ? share.x * share.y * share.z : 0.0;
    }
    return sum;
}

/// @param low corners of a box around all of the body, index
MetBody bodyAlong(Ray ray, int kind, vec3 low, vec3 high)
{
    const vec3 origin = ray.origin / voxel - 0.5; // index
    const vec3 direction = ray.direction / voxel;
    const vec3 inverse = ray.inverse * voxel;
    const vec3 toLow = (low - origin) * inverse;
    const vec3 toHigh = (high - origin) * inverse;
    const vec3 enter = min(toLow, toHigh);
    const vec3 leave = max(toLow, toHigh);
    float t = max(ray.first, max(max(enter.x, enter.y), enter.z));
    const float last = min(ray.last, min(min(leave.x, leave.y), leave.z));
    const float step = 0.75 * stepMm;
    t += step * fract(pixelNoise(gl_FragCoord.xy) + jitterPhase);

    // The brick of the nearest voxel is used, because bodies reach half a voxel beyond their brick.
    MetBody met;
    met.found = false;
    for (;;) {
        if (met.found || t >= last)
            break;
        const vec3 place = origin + direction * t;
        const vec3 inBricks = floor((place + 0.5) / bodyBrick);
        const bool held = bodyHasBrick(kind, inBricks);
        const vec3 border = (inBricks + vec3(greaterThan(inverse, vec3(0.0)))) * bodyBrick - 0.5;
        const vec3 times = (border - origin) * inverse;
        const float leaving = min(min(times.x, times.y), times.z);
        met.found = held && bodyAt(kind, place) >= 0.5;
        const float next = held ? t + step : max(t, leaving) + 0.01 * step;
        t = met.found ? t : next;
    }
    float before = t - step;
    for (int halving = 0; halving < 4; ++halving) {
        const float middle = 0.5 * (before + t);
        const bool inside = bodyAt(kind, origin + direction * middle) >= 0.5;
        before = inside ? before : middle;
        t = inside ? middle : t;
    }
    const vec3 place = origin + direction * t;
    const float h = 1.2; // voxels
    const vec3 rise
        = vec3(bodyAt(kind, place + vec3(h, 0, 0)) - bodyAt(kind, place - vec3(h, 0, 0)),
            bodyAt(kind, place + vec3(0, h, 0)) - bodyAt(kind, place - vec3(0, h, 0)),
            bodyAt(kind, place + vec3(0, 0, h)) - bodyAt(kind, place - vec3(0, 0, h)));
    met.normal = normalize(gradientToWorld * -rise - 1e-9 * ray.world);
    met.hidden = t > solidFrom + 2.0 * stepMm;
    return met;
}
