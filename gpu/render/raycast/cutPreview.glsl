// Marks what a cut of a growth would remove (gpu/kernels/shrink/CutPreviewer) by hatching, so that
// no segment's colour can hide it. Include fields/bricks/bricks.glsl before this file.

layout(binding = 16) uniform usampler3D cutPreviewPages; // page + 1, by bricks
layout(binding = 17) uniform usampler3D cutPreviewAtlas; // 1: would be removed

const vec3 cutPreviewColour = vec3(1.0, 0.30, 0.86);
const vec3 cutPreviewDark = vec3(0.45, 0.02, 0.40);

bool isInCutPreview(ivec3 voxel)
{
    const uint entry = texelFetch(cutPreviewPages, voxel >> 4, 0).r;
    return entry != 0u && texelFetch(cutPreviewAtlas, atlasTexel(max(entry, 1u), voxel), 0).r != 0u;
}

/// @param pixel of the frame, from its top left
vec3 cutPreviewAt(vec2 pixel)
{
    return fract((pixel.x - pixel.y) / 7.0) < 0.6 ? cutPreviewColour : cutPreviewDark;
}
