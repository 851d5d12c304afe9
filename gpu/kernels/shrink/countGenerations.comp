// Counts members by generation (CountGenerations in core/engine/GrowthForesight.h).

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "fields/bricks/seedWord.glsl"

layout(binding = 0) uniform usampler3D words; // atlas
layout(binding = 1) uniform usampler3D pageTable;
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };
layout(binding = 1, std430) buffer Sizes { uint sizes[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint brickCount;

void main()
{
    for (uint slot = gl_WorkGroupID.x; slot < brickCount; slot += gl_NumWorkGroups.x) {
        ivec3 brick = brickPosition(int(bricks[slot]), volumeBricks);
        uint entry = texelFetch(pageTable, brick, 0).r;
        for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
            ivec3 voxel = brick * brickSide + voxelInBrick(offset);
            uint word = texelFetch(words, atlasTexel(entry, voxel), 0).r;
            if (isMember(word) && inside(voxel, volumeSize))
                atomicAdd(sizes[generationOf(word)], 1u);
        }
    }
}
