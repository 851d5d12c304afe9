// Ends a batch of generations (FrontBits): reports which listed bricks hold the front, and clears
// the bits of the previous front, which the next batch will write. One work-group per brick, or
// several bricks one after the other; one invocation per word.

layout(local_size_x = 128) in;

#include "kernels/criterion/growth.glsl"
#include "kernels/fronts/frontBits.glsl"

layout(binding = 6, std430) restrict writeonly buffer Before { uint before[]; };
layout(binding = 7, std430) restrict readonly buffer Open { uint open[]; };

uniform uint generation;

void main()
{
    for (uint slot = gl_WorkGroupID.x; slot < groups.x; slot += gl_NumWorkGroups.x) {
        ListedBrick brick = bricks[slot];
        uint last = open[brick.index * wordsOfOpen + lastFront];
        if (last + 1u >= generation)
            before[brick.index * wordsOfFront + gl_LocalInvocationID.x] = 0u;
        if (last == generation)
            reached[brick.page] = holdsFront;
    }
}
