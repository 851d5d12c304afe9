// Applies one axis of the integer Gaussian (core/sculpt/radiation/Radiation.h). AXIS 0: 24³ → 18·24·24, 1: →
// 18·18·24, 2: → 18³ and rounding to a byte. Sums stay below 2³², so nothing is rounded in between.

layout(local_size_x = 64) in;

#include "kernels/radiation/radiationRegion.glsl"

layout(binding = 2, std430) readonly buffer Summaries { uint summaries[]; };
layout(binding = 3, std430) readonly buffer Source { uint source[]; };
layout(binding = 4, std430) writeonly buffer Target { uint target[]; };

#if AXIS == 0
const uvec3 sourceSize = uvec3(24, 24, 24);
const uvec3 targetSize = uvec3(18, 24, 24);
#elif AXIS == 1
const uvec3 sourceSize = uvec3(18, 24, 24);
const uvec3 targetSize = uvec3(18, 18, 24);
#else
const uvec3 sourceSize = uvec3(18, 18, 24);
const uvec3 targetSize = uvec3(18, 18, 18);
#endif
const uvec3 strides = uvec3(1u, sourceSize.x, sourceSize.x * sourceSize.y);
const uvec3 targetStrides = uvec3(1u, targetSize.x, targetSize.x * targetSize.y);
const uint targetCount = targetSize.x * targetSize.y * targetSize.z;
const uint sourceCount = sourceSize.x * sourceSize.y * sourceSize.z;

void main()
{
    uint slot = gl_WorkGroupID.x;
    if (summaries[slot] != 3u)
        return;
    uint stride = strides[AXIS];
    Region region = regionOf(slot);
    // The box is extended by one voxel on both sides along axes that are blurred, by four along the
    // others.
    Box box = boxOf(region.size + (ivec3(targetSize) - 16));
    for (uint i = gl_LocalInvocationID.x; i < box.count; i += 64u) {
        uvec3 voxel = uvec3(region.low + voxelOf(i, box));
        uint at = slot * sourceCount + voxel.x + voxel.y * strides.y + voxel.z * strides.z;
        uint sum = 4u * (source[at] + source[at + 6u * stride])
            + 21u * (source[at + stride] + source[at + 5u * stride])
            + 60u * (source[at + 2u * stride] + source[at + 4u * stride]) + 86u * source[at + 3u * stride];
#if AXIS == 2
        sum = (sum + (1u << 23)) >> 24;
#endif
        target[slot * targetCount + voxel.x + voxel.y * targetStrides.y + voxel.z * targetStrides.z] = sum;
    }
}
