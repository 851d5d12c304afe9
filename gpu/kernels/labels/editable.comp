// Which voxels of listed bricks an edit of labels may change, as bits, by the rules of
// core/sculpt/labels/EditableVoxels.h. Each run asks one question of all of them, by VALUES or by one plane of labels, and joins the
// answer to what earlier runs found. One work-group a brick, one invocation a word of 32 voxels.

layout(local_size_x = 128) in;

#include "fields/bricks/bricks.glsl"

#ifdef VALUES
layout(binding = 0) uniform usampler3D codes;
uniform uint lowCode;
uniform uint highCode;
uniform ivec3 boxFrom;
uniform ivec3 boxTo; // one past the last voxel
#else
layout(binding = 0) uniform usampler3D labels;
uniform uint listed[8]; // a bit for each label
#endif
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };
layout(binding = 1, std430) buffer Editable { uint editable[]; }; // 128 words a brick

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint how; // Join in EditableBits.cpp

const uint joinSet = 0u;
const uint joinAdd = 1u;
const uint joinKeep = 2u;

bool holds(ivec3 voxel)
{
#ifdef VALUES
    uint code = texelFetch(codes, voxel, 0).r;
    return code >= lowCode && code <= highCode && all(greaterThanEqual(voxel, boxFrom))
        && all(lessThan(voxel, boxTo));
#else
    uint label = texelFetch(labels, voxel, 0).r;
    return (listed[label >> 5] >> (label & 31u) & 1u) != 0u;
#endif
}

void main()
{
    ivec3 origin = brickPosition(int(bricks[gl_WorkGroupID.x]), volumeBricks) * brickSide;
    int first = int(gl_LocalInvocationID.x) * 32;
    uint found = 0u;
    for (int bit = 0; bit < 32; ++bit) {
        ivec3 voxel = origin + voxelInBrick(first + bit);
        if (inside(voxel, volumeSize) && holds(voxel))
            found |= 1u << uint(bit);
    }
    uint word = gl_WorkGroupID.x * 128u + gl_LocalInvocationID.x;
    uint before = how == joinSet ? 0u : editable[word];
    if (how == joinSet || how == joinAdd)
        editable[word] = before | found;
    else
        editable[word] = how == joinKeep ? before & found : before & ~found;
}
