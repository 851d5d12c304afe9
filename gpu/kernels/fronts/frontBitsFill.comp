// Puts the front that a queue lists into bits (FrontBits), which are 0 before. One invocation a
// voxel of it.

layout(local_size_x = 64) in;

#include "kernels/growth/growth.glsl"
#include "kernels/fronts/frontBits.glsl"

layout(binding = 2, std430) restrict buffer Front { uint front[]; };
layout(binding = 7, std430) restrict buffer Open { uint open[]; };

uniform uint baseGeneration; // the front's

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= state.counts[0])
        return;
    uint entry = queues[frontSlot(0u, i)];
    uint owner = pageOwners[entry >> 12];
    uint brick = uint(brickIndex(
        ivec3(owner & 1023u, owner >> 10 & 1023u, owner >> 20), volumeBricks));
    uint offset = entry & 4095u;
    // Whether it lies at an end is not looked at.
    for (uint i = 0u; i < 7u; ++i)
        open[brick * wordsOfOpen + lastFront + i] = baseGeneration;
    atomicOr(front[brick * wordsOfFront + (offset >> 5)], 1u << (offset & 31u));
}
