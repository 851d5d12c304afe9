// Copies listed bricks of one field into a buffer, brick after brick: for readback, undo and
// hashes. FIELD_DENSE: the field is an R8UI texture of the volume; otherwise it is the atlas of a
// BrickField. FIELD_WORDS: 32 bits per voxel; otherwise 8, four voxels per word.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"

layout(binding = 0) uniform usampler3D source;
layout(binding = 1) uniform usampler3D pageTable;
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };
layout(binding = 1, std430) writeonly buffer Packed { uint packedVoxels[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint emptyVoxel;

uint fetch(ivec3 voxel, uint entry)
{
#ifdef FIELD_DENSE
    return inside(voxel, volumeSize) ? texelFetch(source, voxel, 0).r : 0u;
#else
    return entry == 0u ? emptyVoxel : texelFetch(source, atlasTexel(entry, voxel), 0).r;
#endif
}

void main()
{
    ivec3 brick = brickPosition(int(bricks[gl_WorkGroupID.x]), volumeBricks);
    uint entry = 0u;
#ifndef FIELD_DENSE
    entry = texelFetch(pageTable, brick, 0).r;
#endif
#ifdef FIELD_WORDS
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64)
        packedVoxels[gl_WorkGroupID.x * 4096u + uint(offset)]
            = fetch(brick * brickSide + voxelInBrick(offset), entry);
#else
    for (int group = int(gl_LocalInvocationID.x); group < 1024; group += 64) {
        ivec3 voxel = brick * brickSide + voxelInBrick(group * 4);
        packedVoxels[gl_WorkGroupID.x * 1024u + uint(group)] = fetch(voxel, entry)
            | fetch(voxel + ivec3(1, 0, 0), entry) << 8 | fetch(voxel + ivec3(2, 0, 0), entry) << 16
            | fetch(voxel + ivec3(3, 0, 0), entry) << 24;
    }
#endif
}
