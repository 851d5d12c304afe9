// Counts how many voxels have each tolerance, and finds the least and greatest tolerance of each
// brick (core/growth/Tolerance.h). One work-group per brick.

layout(local_size_x = 64) in;

#include "kernels/spread/tolerance.glsl"

layout(binding = 2, std430) buffer Sizes { uint sizes[]; };
layout(binding = 3, std430) writeonly buffer Ranges { uint ranges[]; }; // least | greatest << 16

uniform uint firstBrick; // index of the first brick in the volume

shared uint low;
shared uint high;

void main()
{
    if (gl_LocalInvocationIndex == 0u) {
        low = wall;
        high = 0u;
    }
    barrier();
    uint slot = firstBrick + gl_WorkGroupID.x;
    ivec3 origin = brickPosition(int(slot), volumeBricks) * brickSide;
    uint least = wall;
    uint greatest = 0u;
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        uint tolerance = imageLoad(tolerances, origin + voxelInBrick(offset)).r;
        if (tolerance >= nowhere)
            continue;
        atomicAdd(sizes[tolerance], 1u);
        least = min(least, tolerance);
        greatest = max(greatest, tolerance);
    }
    if (least != wall) {
        atomicMin(low, least);
        atomicMax(high, greatest);
    }
    barrier();
    if (gl_LocalInvocationIndex == 0u)
        ranges[slot] = low | high << 16;
}
