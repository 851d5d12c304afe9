// Carves or restores voxels in the candidate bricks of a brush (CapsuleCut in
// core/engine/LayerCommands.h). One work-group per brick; each voxel is written by one invocation.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "kernels/sculpt/capsule.glsl"
#include "kernels/cut/coverageWrite.glsl"
#include "kernels/cut/hidden.glsl"

uniform int rampHalfWidth;

uint squareRoot(uint value)
{
    // The float is only a first guess; integers decide.
    uint root = uint(sqrt(float(value)));
    while (root * root > value)
        --root;
    while ((root + 1u) * (root + 1u) <= value)
        ++root;
    return root;
}

uint cutAt(uint squared)
{
    int distance = int(squareRoot(squared)) << shift;
    int t = clamp(radius - distance, -rampHalfWidth, rampHalfWidth);
    return uint((t + rampHalfWidth) * 255) / uint(2 * rampHalfWidth);
}

void main()
{
    Candidate candidate = candidates[gl_WorkGroupID.x];
    ivec3 origin = brickPosition(candidate.base.w, volumeBricks) * brickSide;
    uint entry = texelFetch(pageTable, origin >> 4, 0).r;
    bool any = false;
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 local = voxelInBrick(offset);
        if (!inside(origin + local, volumeSize))
            continue;
        uint squared = leastDistance(candidate, local);
        if (squared == farAway || isHidden(gl_WorkGroupID.x, local))
            continue;
        any = writeCut(entry, origin + local, cutAt(squared)) || any;
    }
    if (any)
        changed[gl_WorkGroupID.x] = 1u;
}
