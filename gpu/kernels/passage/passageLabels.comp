// Finds which labels have members or seeds in a brick, except labels that do not grow: one bit per
// label. One work-group per listed brick.

layout(local_size_x = 64) in;

#include "kernels/criterion/growth.glsl"

layout(binding = 4, std430) readonly buffer Bricks { uint bricks[]; };
layout(binding = 6, std430) writeonly buffer Found { uint found[]; };

shared uint labelBits[8];

void main()
{
    ivec3 origin = brickPosition(int(bricks[gl_WorkGroupID.x]), volumeBricks) * brickSide;
    uint entry = pageEntry(origin);
    if (gl_LocalInvocationID.x < 8u)
        labelBits[gl_LocalInvocationID.x] = 0u;
    barrier();
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        if (entry == 0u || !inside(origin + voxelInBrick(offset), volumeSize))
            continue;
        uint word = imageLoad(words, pageTexel(entry - 1u, offset)).r;
        uint label = labelOf(word);
        if ((isMember(word) || isPendingSeed(word)) && mayGrow(label))
            atomicOr(labelBits[label >> 5], 1u << (label & 31u));
    }
    barrier();
    if (gl_LocalInvocationID.x < 8u)
        found[gl_WorkGroupID.x * 8u + gl_LocalInvocationID.x] = labelBits[gl_LocalInvocationID.x];
}
