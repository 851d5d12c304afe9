// Barriers (voxels closed to growth) as translucent bodies whose front is seen. Those behind tissue
// shine through faintly. Include kernels/labels/memberWords.glsl before this file.

/* Textures */
layout(binding = 18) uniform usampler3D barrierBricks; // 1: the brick holds barriers

/* Uniforms */
uniform vec3 barrierLow; // index: low corner of the box around all barriers
uniform vec3 barrierHigh;

const vec3 barrierColour = vec3(0.93, 0.25, 0.36); // as in slices
const float barrierOpacity = 0.6;
const float barrierBehind = 0.2;
const float barrierBrick = 16.0;

/// 1 at the centre of a barrier voxel, interpolated to 0 at the centre of another.
float barrierAt(vec3 place)
{
    const ivec3 base = ivec3(floor(place));
    const vec3 part = place - vec3(base);
    const ivec3 last = textureSize(labels, 0) - 1;
    float sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const ivec3 offset = ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
        const vec3 share = mix(1.0 - part, part, vec3(offset));
        const uint word = wordAt(clamp(base + offset, ivec3(0), last));
        sum += word == barrierWord ? share.x * share.y * share.z : 0.0;
    }
    return sum;
}

/// Adds the barriers to what is seen: those in front of it, and those behind it faintly.
vec3 withBarriers(Ray ray, vec3 seen)
{
    const vec3 origin = ray.origin / voxel - 0.5; // index
    const vec3 direction = ray.direction / voxel;
    const vec3 inverse = ray.inverse * voxel;
    const vec3 toLow = (barrierLow - origin) * inverse;
    const vec3 toHigh = (barrierHigh - origin) * inverse;
    const vec3 enter = min(toLow, toHigh);
    const vec3 leave = max(toLow, toHigh);
    float t = max(ray.first, max(max(enter.x, enter.y), enter.z));
    const float last = min(ray.last, min(min(leave.x, leave.y), leave.z));
    const float step = 0.75 * stepMm;
    t += step * fract(pixelNoise(gl_FragCoord.xy) + jitterPhase);

    // The brick of the nearest voxel is used, because bodies reach half a voxel beyond their brick.
    const ivec3 lastBrick = textureSize(barrierBricks, 0) - 1;
    bool found = false;
    for (;;) {
        if (found || t >= last)
            break;
        const vec3 place = origin + direction * t;
        const vec3 inBricks = floor((place + 0.5) / barrierBrick);
        const ivec3 brick = clamp(ivec3(inBricks), ivec3(0), lastBrick);
        const bool held = texelFetch(barrierBricks, brick, 0).r != 0u;
        const vec3 border
            = (inBricks + vec3(greaterThan(inverse, vec3(0.0)))) * barrierBrick - 0.5;
        const vec3 times = (border - origin) * inverse;
        const float leaving = min(min(times.x, times.y), times.z);
        found = held && barrierAt(place) >= 0.5;
        const float next = held ? t + step : max(t, leaving) + 0.01 * step;
        t = found ? t : next;
    }
    float before = t - step;
    for (int halving = 0; halving < 4; ++halving) {
        const float middle = 0.5 * (before + t);
        const bool inside = barrierAt(origin + direction * middle) >= 0.5;
        before = inside ? before : middle;
        t = inside ? middle : t;
    }
    const vec3 place = origin + direction * t;
    const vec3 rise = vec3(barrierAt(place + vec3(1.2, 0, 0)) - barrierAt(place - vec3(1.2, 0, 0)),
        barrierAt(place + vec3(0, 1.2, 0)) - barrierAt(place - vec3(0, 1.2, 0)),
        barrierAt(place + vec3(0, 0, 1.2)) - barrierAt(place - vec3(0, 0, 1.2)));
    const vec3 normal = normalize(gradientToWorld * -rise - 1e-9 * ray.world);
    const vec3 look = lit(barrierColour, lightOn(normal, -ray.world, 1.0, 0.15));
    const bool hidden = t > solidFrom + 2.0 * stepMm;
    return mix(seen, look, found ? (hidden ? barrierBehind : barrierOpacity) : 0.0);
}
