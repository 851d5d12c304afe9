// Marks what a cut of a growth would remove, and what a moving interval changes in one
// (gpu/kernels/shrink/PreviewMarks), by hatching, so that no segment's colour can hide it. Include
// fields/bricks/bricks.glsl before this file.

layout(binding = 16) uniform usampler3D cutPreviewPages; // page + 1, by bricks
layout(binding = 17) uniform usampler3D cutPreviewAtlas; // PreviewMarks::Mark

const uint cutGoes = 1u; // a cut would remove it
const uint growthSuspended = 2u; // it has left the growth
const uint growthReached = 3u; // the growth has claimed it
const uint growthReinstated = 4u; // the same, after an earlier growth had suspended it
const vec3 cutPreviewColour = vec3(1.0, 0.30, 0.86);
const vec3 cutPreviewDark = vec3(0.45, 0.02, 0.40);
const vec3 suspendedColour = vec3(0.94, 0.25, 0.20);
const vec3 suspendedDark = vec3(0.38, 0.04, 0.03);

uint previewMarkAt(ivec3 voxel)
{
    const uint entry = texelFetch(cutPreviewPages, voxel >> 4, 0).r;
    return entry != 0u ? texelFetch(cutPreviewAtlas, atlasTexel(max(entry, 1u), voxel), 0).r : 0u;
}

/// Whether a pixel lies on one of the bright stripes.
/// @param pixel of the frame, from its top left
bool isBrightStripe(vec2 pixel)
{
    return fract((pixel.x - pixel.y) / 7.0) < 0.6;
}

/// @param own the segment's colour
vec3 previewMarkColour(uint mark, vec2 pixel, vec3 own)
{
    const bool bright = isBrightStripe(pixel);
    if (mark == growthReached)
        return bright ? own : mix(own, vec3(1.0), 0.55);
    if (mark == growthReinstated)
        return bright ? own : suspendedColour;
    if (mark == growthSuspended)
        return bright ? suspendedColour : suspendedDark;
    return bright ? cutPreviewColour : cutPreviewDark;
}

vec3 previewMarkLine(uint mark, vec3 own)
{
    return mark == growthReached || mark == growthReinstated ? own
        : mark == growthSuspended ? suspendedColour
                                  : cutPreviewColour;
}
