// Last stage of radiation: makes sure that no voxel is hidden or invented, and keeps thin parts
// visible (core/sculpt/radiation/Radiation.h). Writes the dense radiation texture.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "kernels/radiation/radiationRegion.glsl"

layout(binding = 0, r8ui) uniform writeonly uimage3D radiation;
layout(binding = 1, std430) readonly buffer Field { uint field[]; };
layout(binding = 2, std430) readonly buffer Summaries { uint summaries[]; };
layout(binding = 3, std430) readonly buffer Blurred { uint blurred[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform ivec3 targetShift;

const uint thinBelow = 192u;
const uint thinLift = 88u;

// The blurred value at a voxel, local coordinates −1 … 16.
uint blurAt(uint slot, ivec3 local)
{
    ivec3 at = local + 1;
    return blurred[slot * 5832u + uint(at.x + 18 * (at.y + 18 * at.z))];
}

// The greatest blurred value at a voxel and around it, within the volume. A software driver carries
// out all that is behind a condition, but of a loop no more than its first round: hence `wanted`.
uint greatestAround(uint slot, ivec3 origin, ivec3 local, bool wanted)
{
    const ivec3 low = -origin;
    const ivec3 high = volumeSize - 1 - origin;
    const int last = wanted ? 1 : -2;
    uint greatest = 0u;
    for (int z = -1; z <= last; ++z)
        for (int y = -1; y <= last; ++y)
            for (int x = -1; x <= last; ++x)
                greatest = max(greatest, blurAt(slot, clamp(local + ivec3(x, y, z), low, high)));
    return greatest;
}

void main()
{
    uint slot = gl_WorkGroupID.x;
    uint summary = summaries[slot];
    Region region = regionOf(slot);
    ivec3 origin = brickPosition(region.brick, volumeBricks) * brickSide;
    Box box = boxOf(region.size);
    for (uint i = gl_LocalInvocationID.x; i < box.count; i += 64u) {
        ivec3 local = region.low + voxelOf(i, box);
        if (!inside(origin + local, volumeSize))
            continue;
        const ivec3 at = local + 4;
        const bool member = field[slot * 13824u + uint(at.x + 24 * (at.y + 24 * at.z))] >= 128u;
        const uint blur = blurAt(slot, local);
        uint value = member ? max(blur, 128u) : min(blur, 127u);
        // If the voxel itself is deep inside, the greatest value around is at least as great.
        const bool mayBeThin = summary == 3u && member && value < thinBelow;
        const uint greatest = greatestAround(slot, origin, local, mayBeThin);
        if (mayBeThin && greatest < thinBelow)
            value = max(value, 128u + thinLift * (thinBelow - greatest) / thinBelow);
        if (summary != 3u)
            value = summary == 1u ? 255u : 0u;
        imageStore(radiation, origin + local + targetShift, uvec4(value));
    }
}
