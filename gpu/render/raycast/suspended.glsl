// What another interval has suspended (gpu/kernels/shrink/PreviewMarks) as translucent bodies
// beside the segment, striped as in slices. Those behind tissue shine through faintly. Include
// render/raycast/cutPreview.glsl before this file.

/* Uniforms */
uniform vec3 suspendedLow; // index: low corner of a box around all that is suspended
uniform vec3 suspendedHigh;

const float suspendedOpacity = 0.6;
const float suspendedBehind = 0.25;
const float suspendedBrick = 16.0;

/// 1 at the centre of a suspended voxel, interpolated to 0 at the centre of another.
float suspendedAt(vec3 place)
{
    const ivec3 base = ivec3(floor(place));
    const vec3 part = place - vec3(base);
    const ivec3 last = textureSize(labels, 0) - 1;
    float sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const ivec3 offset = ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
        const vec3 share = mix(1.0 - part, part, vec3(offset));
        const uint mark = previewMarkAt(clamp(base + offset, ivec3(0), last));
        sum += mark == growthSuspended ? share.x * share.y * share.z : 0.0;
    }
    return sum;
}

/// Adds what is suspended to what is seen: in front of it, and behind it faintly.
vec3 withSuspended(Ray ray, vec3 seen)
{
    const vec3 origin = ray.origin / voxel - 0.5; // index
    const vec3 direction = ray.direction / voxel;
    const vec3 inverse = ray.inverse * voxel;
    const vec3 toLow = (suspendedLow - origin) * inverse;
    const vec3 toHigh = (suspendedHigh - origin) * inverse;
    const vec3 enter = min(toLow, toHigh);
    const vec3 leave = max(toLow, toHigh);
    float t = max(ray.first, max(max(enter.x, enter.y), enter.z));
    const float last = min(ray.last, min(min(leave.x, leave.y), leave.z));
    const float step = 0.75 * stepMm;
    t += step * fract(pixelNoise(gl_FragCoord.xy) + jitterPhase);

    // The brick of the nearest voxel is used, because bodies reach half a voxel beyond their brick.
    const ivec3 lastBrick = textureSize(cutPreviewPages, 0) - 1;
    bool found = false;
    for (;;) {
        if (found || t >= last)
            break;
        const vec3 place = origin + direction * t;
        const vec3 inBricks = floor((place + 0.5) / suspendedBrick);
        const ivec3 brick = clamp(ivec3(inBricks), ivec3(0), lastBrick);
        const bool held = texelFetch(cutPreviewPages, brick, 0).r != 0u;
        const vec3 border
            = (inBricks + vec3(greaterThan(inverse, vec3(0.0)))) * suspendedBrick - 0.5;
        const vec3 times = (border - origin) * inverse;
        const float leaving = min(min(times.x, times.y), times.z);
        found = held && suspendedAt(place) >= 0.5;
        const float next = held ? t + step : max(t, leaving) + 0.01 * step;
        t = found ? t : next;
    }
    float before = t - step;
    for (int halving = 0; halving < 4; ++halving) {
        const float middle = 0.5 * (before + t);
        const bool inside = suspendedAt(origin + direction * middle) >= 0.5;
        before = inside ? before : middle;
        t = inside ? middle : t;
    }
    const vec3 place = origin + direction * t;
    const float h = 1.2; // voxels
    const vec3 rise
        = vec3(suspendedAt(place + vec3(h, 0, 0)) - suspendedAt(place - vec3(h, 0, 0)),
            suspendedAt(place + vec3(0, h, 0)) - suspendedAt(place - vec3(0, h, 0)),
            suspendedAt(place + vec3(0, 0, h)) - suspendedAt(place - vec3(0, 0, h)));
    const vec3 normal = normalize(gradientToWorld * -rise - 1e-9 * ray.world);
    const vec3 own
        = previewMarkColour(growthSuspended, gl_FragCoord.xy * pixelScale, suspendedColour);
    const vec3 look = lit(own, lightOn(normal, -ray.world, 1.0, 0.15));
    const bool hidden = t > solidFrom + 2.0 * stepMm;
    return mix(seen, look, found ? (hidden ? suspendedBehind : suspendedOpacity) : 0.0);
}
