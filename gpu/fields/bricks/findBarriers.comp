// Finds which of the listed bricks of seed words hold a barrier, a voxel that is closed to growth.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "fields/bricks/seedWord.glsl"

layout(binding = 0) uniform usampler3D words; // atlas
layout(binding = 1) uniform usampler3D pageTable;
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };
layout(binding = 1, std430) writeonly buffer Found { uint found[]; };

uniform ivec3 volumeBricks;
uniform uint brickCount;

void main()
{
    for (uint slot = gl_WorkGroupID.x; slot < brickCount; slot += gl_NumWorkGroups.x) {
        uint entry = texelFetch(pageTable, brickPosition(int(bricks[slot]), volumeBricks), 0).r;
        bool any = false;
        for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64)
            any = any || texelFetch(words, pageTexel(entry - 1u, offset), 0).r == barrierWord;
        if (any)
            found[slot] = 1u;
    }
}
