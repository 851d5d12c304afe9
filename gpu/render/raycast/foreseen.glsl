// Marks what a cut of a growth would remove (gpu/kernels/shrink/CutForesight) by hatching, so that
// no segment's colour can hide it. Include fields/bricks/bricks.glsl before this file.

layout(binding = 16) uniform usampler3D foreseenPages; // page + 1, by bricks
layout(binding = 17) uniform usampler3D foreseenAtlas; // 1: would be removed

const vec3 foreseenColour = vec3(1.0, 0.30, 0.86);
const vec3 foreseenDark = vec3(0.45, 0.02, 0.40);

bool isForeseen(ivec3 voxel)
{
    const uint entry = texelFetch(foreseenPages, voxel >> 4, 0).r;
    return entry != 0u && texelFetch(foreseenAtlas, atlasTexel(max(entry, 1u), voxel), 0).r != 0u;
}

/// @param pixel of the frame, from its top left
vec3 foreseenAt(vec2 pixel)
{
    return fract((pixel.x - pixel.y) / 7.0) < 0.6 ? foreseenColour : foreseenDark;
}
