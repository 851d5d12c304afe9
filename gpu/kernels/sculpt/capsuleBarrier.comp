// Closes voxels to growth in the candidate bricks of a brush, or opens them again (PaintBarrier in
// core/growth/GrowthCommands.h). One work-group per brick; each voxel is written by one invocation.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "kernels/sculpt/capsule.glsl"
#include "fields/bricks/seedWord.glsl"
#include "kernels/labels/barrierVoxel.glsl"

void main()
{
    Candidate candidate = candidates[gl_WorkGroupID.x];
    ivec3 origin = brickPosition(candidate.base.w, volumeBricks) * brickSide;
    uint entry = texelFetch(pageTable, origin >> 4, 0).r;
    uint found = 0u;
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 local = voxelInBrick(offset);
        ivec3 voxel = origin + local;
        if (!inside(voxel, volumeSize))
            continue;
        if (!isWithin(candidate, local))
            continue;
        found |= setOrClearBarrier(voxel, entry);
    }
    if (found != 0u)
        atomicOr(changed[gl_WorkGroupID.x], found);
}
