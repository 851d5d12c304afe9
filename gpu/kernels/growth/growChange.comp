// Writes voxels that an interval changes, one by one (core::IntervalOpener): word, label and, where
// labels that were overwritten are kept, that one.

layout(local_size_x = 64) in;

#include "kernels/criterion/growth.glsl"

// Like core::GrowthChange.
struct Change {
    uint brick;
    uint word;
    uint labelsAndOffset; // label | overwritten << 8 | offset in the brick << 16
};
layout(binding = 4, std430) readonly buffer Changes { Change changes[]; };

uniform uint changeCount;

void main()
{
    uint stride = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    uint i = gl_GlobalInvocationID.x;
    if (i < changeCount) do {
        Change change = changes[i];
        ivec3 voxel = brickPosition(int(change.brick), volumeBricks) * brickSide
            + voxelInBrick(int(change.labelsAndOffset >> 16));
        uint entry = pageEntry(voxel);
        imageStore(words, atlasTexel(entry, voxel), uvec4(change.word));
        imageStore(labels, voxel, uvec4(change.labelsAndOffset & 255u));
#ifdef OVERWRITTEN
        uint there = texelFetch(overwrittenPages, voxel >> 4, 0).r;
        if (there != 0u)
            imageStore(overwritten, atlasTexel(there, voxel), uvec4(change.labelsAndOffset >> 8 & 255u));
#endif
        reached[entry - 1u] = heldFront;
        i += stride;
    } while (i < changeCount);
}
