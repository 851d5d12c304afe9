// Carves or restores voxels in the candidate bricks of a brush (CapsuleCut in
// core/engine/LayerCommands.h). One work-group per brick; each voxel is written by one invocation.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "kernels/sculpt/capsule.glsl"
#include "kernels/cut/coverageWrite.glsl"
#include "kernels/cut/hidden.glsl"

uniform int rampHalfWidth;
uniform bool pressed; // the radii of pieces differ

const int noDepth = -0x7FFFFFFF;

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

// How deep in a piece near the candidate the voxel lies, mm16: below 0 outside of all of them;
// noDepth if none has a distance.
int depthAt(Candidate candidate, ivec3 local)
{
    if (!pressed) {
        uint squared = leastDistance(candidate, local);
        return squared == farAway ? noDepth : radius - (int(squareRoot(squared)) << shift);
    }
    ivec3 position = strokePosition(candidate, local);
    int deepest = noDepth;
    if (!inSlab(position))
        return deepest;
    for (uint i = candidate.span.x; i < candidate.span.y; ++i) {
        Capsule capsule = capsules[near[i]];
        uint squared = squaredDistance(capsule, position);
        if (squared != farAway)
            deepest =
                max(deepest, radiusOf(capsule) - (int(squareRoot(squared)) << shift));
    }
    return deepest;
}

uint cutAt(int depth)
{
    int t = clamp(depth, -rampHalfWidth, rampHalfWidth);
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
        int depth = depthAt(candidate, local);
        if (depth == noDepth || isHidden(gl_WorkGroupID.x, local))
            continue;
        any = writeCut(entry, origin + local, cutAt(depth)) || any;
    }
    if (any)
        changed[gl_WorkGroupID.x] = 1u;
}
