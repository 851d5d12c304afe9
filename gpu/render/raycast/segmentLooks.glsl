// Where segments are, and how they look beside their colour. With SEGMENT_LOOKS a ray may look twice:
// first at everything; then, if it met a translucent segment first, past all that are translucent. So
// what lies behind a translucent segment is tissue and opaque segments.

#if SEGMENT_LOOKS
/* Uniforms */
uniform bool voxelTrue; // segments are drawn as their voxels are, without smoothing
uniform uint bodiless;  // label of a segment that has no body; 0: none

bool pastTranslucent = false; // this is the second look
float segmentOpacity = 1.0; // of what segmentColour() saw last
float metOpacity = 1.0; // of the segment that the first look met first; 1: none

/// Whether a segment of this opacity counts in this look: 0 or 1.
float counted(float opacity)
{
    return pastTranslucent ? floor(opacity) : ceil(opacity);
}

/// Notes that this look ends at the segment that segmentColour() saw last.
void meetSegment(bool met)
{
    metOpacity = met && !pastTranslucent ? segmentOpacity : metOpacity;
}

/// Along each axis, the share of one of the eight voxels around a place.
/// @param part of the way from the low corner of the eight to the high one
vec3 cornerShare(vec3 part, ivec3 offset)
{
    const vec3 share = mix(1.0 - part, part, vec3(offset));
    return voxelTrue ? step(0.5, share) : share;
}

/// The opacity of the segment of the voxel at a place; 0: there is none that is shown.
float opacityAt(vec3 at)
{
    const ivec3 last = textureSize(labels, 0) - 1;
    const ivec3 there = clamp(ivec3(floor(at / voxel)), ivec3(0), last);
    const uint label = texelFetch(labels, there, 0).r;
    return label == bodiless ? 0.0 : texelFetch(palette, ivec2(int(label), 0), 0).a;
}

/// 1 where only opaque segments are around a place, 0 where only translucent ones or none are; 0.5
/// in the middle between the two.
float opaqueShare(vec3 at)
{
    const vec3 place = at / voxel - 0.5;
    const vec3 base = floor(place);
    vec2 sum = vec2(0.0); // of opaque ones, of all
    for (int corner = 0; corner < 8; ++corner) {
        const ivec3 offset = ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
        const vec3 share = cornerShare(place - base, offset);
        const float opacity = opacityAt((base + vec3(offset) + 0.5) * voxel);
        sum += vec2(floor(opacity), ceil(opacity)) * (share.x * share.y * share.z + 1e-4);
    }
    return sum.y > 0.0 ? sum.x / sum.y : 0.0;
}

/// ≥ 0.5: inside a segment.
float segmentationAt(vec3 at)
{
    float body = texture(segmentation, at).r;
    if (voxelTrue)
        return counted(opacityAt(at));
    if (pastTranslucent)
        body = min(body, opaqueShare(at));
    return body;
}

/// The outer face of the voxels by which a ray came to a place in a segment, as a step inwards.
vec3 faceRise(Ray ray, vec3 at)
{
    const vec3 place = at / voxel;
    const vec3 towards = sign(ray.inverse);
    vec3 cube = floor(place);
    vec3 face = vec3(0.0);
    bool within = true;
    // A step of the ray passes few voxels.
    for (int back = 0; back < 4; ++back) {
        const vec3 border = cube + vec3(lessThan(towards, vec3(0.0)));
        vec3 times = (place - border) * voxel * ray.inverse;
        // A ray along an axis comes by no face beside it.
        times = mix(times, vec3(nowhere), greaterThan(abs(ray.inverse), vec3(1e8)));
        const float least = min(min(times.x, times.y), times.z);
        const vec3 entered = times.x <= least ? vec3(1, 0, 0)
            : times.y <= least                ? vec3(0, 1, 0)
                                              : vec3(0, 0, 1);
        face = within ? entered * towards : face;
        cube -= within ? face : vec3(0.0);
        const bool outside = any(lessThan(cube, vec3(0.0)))
            || any(greaterThanEqual(cube, vec3(textureSize(labels, 0))));
        within = within && !outside && counted(opacityAt((cube + 0.5) * voxel)) > 0.0;
    }
    return face;
}

/// Points from a place to the opaque voxels within three voxels of it. Steps of single voxels, of
/// which alone the border of an opaque segment within a translucent one is known, do not show in it.
vec3 opaqueRise(vec3 at)
{
    const vec3 place = at / voxel - 0.5;
    const vec3 base = floor(place);
    vec3 rise = vec3(0.0);
    for (int i = 0; i < 216; ++i) {
        const vec3 there = base + vec3(i % 6 - 2, i / 6 % 6 - 2, i / 36 - 2);
        const vec3 away = there - place;
        const float near = max(0.0, 1.0 - dot(away, away) / 9.0);
        rise += away * (near * near * floor(opacityAt((there + 0.5) * voxel)));
    }
    return rise;
}

/// Differences per voxel of what segmentationAt() returns where a ray meets a segment, or others in
/// their direction: they point inwards.
vec3 segmentRise(Ray ray, vec3 at)
{
    if (voxelTrue)
        return faceRise(ray, at);
    if (pastTranslucent) {
        const float share = opaqueShare(at);
        if (share > 0.0 && share <= texture(segmentation, at).r)
            return opaqueRise(at);
    }
    return 0.5
        * vec3(segmentationAt(at + vec3(voxel.x, 0, 0)) - segmentationAt(at - vec3(voxel.x, 0, 0)),
            segmentationAt(at + vec3(0, voxel.y, 0)) - segmentationAt(at - vec3(0, voxel.y, 0)),
            segmentationAt(at + vec3(0, 0, voxel.z)) - segmentationAt(at - vec3(0, 0, voxel.z)));
}
#else
const bool pastTranslucent = false;

void meetSegment(bool met)
{
}

float segmentationAt(vec3 at)
{
    return texture(segmentation, at).r;
}

vec3 segmentRise(Ray ray, vec3 at)
{
    return centralDifferences(segmentation, at, 1.0);
}
#endif
