// Converts the front in a queue to bits (FrontBits), which are all 0 before. One invocation per
// voxel of the front, or several voxels one after the other.

layout(local_size_x = 64) in;

#include "kernels/criterion/growth.glsl"
#include "kernels/fronts/frontBits.glsl"

layout(binding = 2, std430) restrict buffer Front { uint front[]; };
layout(binding = 7, std430) restrict buffer Open { uint open[]; };

uniform uint baseGeneration; // generation of the front

void fill(uint place)
{
    uint entry = queues[frontSlot(0u, place)];
    uint owner = pageOwners[entry >> 12];
    uint brick = uint(brickIndex(
        ivec3(owner & 1023u, owner >> 10 & 1023u, owner >> 20), volumeBricks));
    uint offset = entry & 4095u;
    // Sets all ends without testing at which of them the voxel lies.
    for (uint i = 0u; i < 7u; ++i)
        open[brick * wordsOfOpen + lastFront + i] = baseGeneration;
    atomicOr(front[brick * wordsOfFront + (offset >> 5)], 1u << (offset & 31u));
}

void main()
{
    uint atOnce = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint place = gl_GlobalInvocationID.x; place < state.counts[0]; place += atOnce)
        fill(place);
}
