// Composes the label planes of listed bricks to what the 3D view sees (gpu/fields/textures/ShownLabels.h).

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"

layout(binding = 0) uniform usampler3D plane0;
layout(binding = 1) uniform usampler3D plane1;
layout(binding = 2) uniform usampler3D plane2;
layout(binding = 3) uniform usampler3D plane3;
layout(binding = 0, r8ui) uniform writeonly uimage3D seen;
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint brickCount;
uniform uint planeCount;
uniform uint shown[8];  // one bit per label
uniform uint opaque[8]; // some of those that are shown

bool isShown(uint label)
{
    return (shown[label >> 5] >> (label & 31u) & 1u) != 0u;
}

bool isOpaque(uint label)
{
    return (opaque[label >> 5] >> (label & 31u) & 1u) != 0u;
}

/// What is seen of a label and of what is seen of all planes below.
uint over(uint label, uint below)
{
    return isShown(label) && (isOpaque(label) || !isOpaque(below)) ? label : below;
}

void main()
{
    for (uint slot = gl_WorkGroupID.x; slot < brickCount; slot += gl_NumWorkGroups.x) {
        ivec3 origin = brickPosition(int(bricks[slot]), volumeBricks) * brickSide;
        for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
            ivec3 voxel = origin + voxelInBrick(offset);
            if (!inside(voxel, volumeSize))
                continue;
            uint label = over(texelFetch(plane0, voxel, 0).r, 0u);
            if (planeCount > 1u)
                label = over(texelFetch(plane1, voxel, 0).r, label);
            if (planeCount > 2u)
                label = over(texelFetch(plane2, voxel, 0).r, label);
            if (planeCount > 3u)
                label = over(texelFetch(plane3, voxel, 0).r, label);
            imageStore(seen, voxel, uvec4(label));
        }
    }
}
