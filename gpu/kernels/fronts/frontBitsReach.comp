// Finds which listed bricks a generation may change (FrontBits): those that had a front in one of
// the last two generations (because the bits of the one before the last are overwritten), and those
// whose neighbour has a front at the end that faces them. One invocation per brick.

layout(local_size_x = 64) in;

#include "kernels/criterion/growth.glsl"
#include "kernels/fronts/frontBits.glsl"

layout(binding = 6, std430) restrict buffer Reach {
    uint count; // the groups.x of the list
    uint one[2];
    uint padding;
    ListedBrick inReach[];
};
layout(binding = 7, std430) restrict readonly buffer Open { uint open[]; };

uniform uint baseGeneration;
uniform uint ring;

// Whether the front may come over from the brick at this offset.
bool comesFrom(ivec3 brick, ivec3 step, uint last)
{
    ivec3 at = brick + step;
    if (any(lessThan(at, ivec3(0))) || any(greaterThanEqual(at, volumeBricks)))
        return false;
    uint ends = uint(brickIndex(at, volumeBricks)) * wordsOfOpen + lastFrontAtEnd;
    for (int axis = 0; axis < 3; ++axis) {
        if (step[axis] != 0 && open[ends + uint(2 * axis) + (step[axis] < 0 ? 1u : 0u)] != last)
            return false;
    }
    return true;
}

bool isInReach(ListedBrick brick)
{
    uint last = baseGeneration + ring;
    if (open[brick.index * wordsOfOpen + lastFront] + 1u >= last)
        return true;
    for (uint direction = 0u; direction < uint(CONNECTIVITY); ++direction) {
        if (comesFrom(positionOf(brick), neighbourOffsets[direction], last))
            return true;
    }
    return false;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= groups.x || !isInReach(bricks[i]))
        return;
    inReach[atomicAdd(count, 1u)] = bricks[i];
}
