// The seed words of the plane that is shown (core/growth/SeedWord.h), by voxels.
#include "fields/bricks/bricks.glsl"
#include "fields/bricks/seedWord.glsl"

/* Textures */
layout(binding = 14) uniform usampler3D wordAtlas;
layout(binding = 15) uniform usampler3D wordPages;

/* Uniforms */
uniform uint warnAfter; // generation

uint wordAt(ivec3 voxel)
{
    const uint entry = texelFetch(wordPages, voxel >> 4, 0).r;
    return entry != 0u ? texelFetch(wordAtlas, atlasTexel(max(entry, 1u), voxel), 0).r : unvisited;
}

/// Whether growth came to it after the generation that warns.
bool warns(ivec3 voxel)
{
    const uint word = wordAt(voxel);
    return isMember(word) && generationOf(word) > warnAfter;
}
