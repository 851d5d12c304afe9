// Ends a batch of rings (FrontBits): tells which listed bricks hold the front, and empties the bits
// of the one before, which the next batch writes. One work-group a brick, one invocation a word.

layout(local_size_x = 128) in;

#include "kernels/growth/growth.glsl"
#include "kernels/fronts/frontBits.glsl"

layout(binding = 6, std430) restrict writeonly buffer Before { uint before[]; };
layout(binding = 7, std430) restrict readonly buffer Open { uint open[]; };

uniform uint generation;

void main()
{
    ListedBrick brick = bricks[gl_WorkGroupID.x];
    uint last = open[brick.index * wordsOfOpen + lastFront];
    if (last + 1u >= generation)
        before[brick.index * wordsOfFront + gl_LocalInvocationID.x] = 0u;
    if (last == generation)
        reached[brick.page] = holdsFront;
}
