// Shuts voxels of listed bricks to growth, or opens them again (BarrierListed in
// core/growth/GrowthCommands.h). One work-group a brick, each voxel written by one invocation.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "fields/bricks/seedWord.glsl"
#include "kernels/labels/barrierVoxel.glsl"

layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };
layout(binding = 1, std430) buffer Changed { uint changed[]; };
layout(binding = 2, std430) readonly buffer Places { uint places[]; }; // a bit a voxel, by brick

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;

void main()
{
    ivec3 brick = brickPosition(int(bricks[gl_WorkGroupID.x]), volumeBricks);
    uint entry = texelFetch(pageTable, brick, 0).r;
    uint found = 0u;
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 voxel = brick * brickSide + voxelInBrick(offset);
        uint listed = places[gl_WorkGroupID.x * 128u + uint(offset >> 5)];
        if ((listed >> (offset & 31) & 1u) != 0u && inside(voxel, volumeSize))
            found |= setOrClearBarrier(voxel, entry);
    }
    if (found != 0u)
        atomicOr(changed[gl_WorkGroupID.x], found);
}
