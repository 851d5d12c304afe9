// Converts the front in a queue to bits (FrontBits), which are all 0 before. One invocation per
// voxel of the front.

layout(local_size_x = 64) in;

#include "kernels/criterion/growth.glsl"
#include "kernels/fronts/frontBits.glsl"

layout(binding = 2, std430) restrict buffer Front { uint front[]; };
layout(binding = 7, std430) restrict buffer Open { uint open[]; };

uniform uint baseGeneration; // generation of the front

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
    // Sets all ends without testing at which of them the voxel lies.
    for (uint i = 0u; i < 7u; ++i)
        open[brick * wordsOfOpen + lastFront + i] = baseGeneration;
    atomicOr(front[brick * wordsOfFront + (offset >> 5)], 1u << (offset & 31u));
}
