// The inverse of packBricks.comp: writes packed bricks into a field.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"

#ifdef FIELD_WORDS
layout(binding = 0, r32ui) uniform writeonly uimage3D target;
#else
layout(binding = 0, r8ui) uniform writeonly uimage3D target;
#endif
layout(binding = 1) uniform usampler3D pageTable;
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };
layout(binding = 1, std430) readonly buffer Packed { uint packedVoxels[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;

const uint skipped = 0xFFFFFFFFu; // BrickCopier::skipped

void main()
{
    if (bricks[gl_WorkGroupID.x] == skipped)
        return;
    ivec3 brick = brickPosition(int(bricks[gl_WorkGroupID.x]), volumeBricks);
#ifdef FIELD_DENSE
    ivec3 origin = brick * brickSide;
#else
    uint page = texelFetch(pageTable, brick, 0).r - 1u;
#endif
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
#ifdef FIELD_WORDS
        uint value = packedVoxels[gl_WorkGroupID.x * 4096u + uint(offset)];
#else
        uint value = packedVoxels[gl_WorkGroupID.x * 1024u + uint(offset >> 2)] >> ((offset & 3) * 8) & 0xFFu;
#endif
#ifdef FIELD_DENSE
        ivec3 texel = origin + voxelInBrick(offset);
        if (!inside(texel, volumeSize))
            continue;
#else
        ivec3 texel = pageTexel(page, offset);
#endif
        imageStore(target, texel, uvec4(value));
    }
}
