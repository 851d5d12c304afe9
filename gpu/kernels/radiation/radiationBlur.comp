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
    // others. An invocation goes along a row, so that each word is read once, not seven times.
    const ivec3 extent = region.size + (ivec3(targetSize) - 16);
    ivec3 across = extent;
    across[AXIS] = 1;
    const Box rows = boxOf(across);
    for (uint row = gl_LocalInvocationID.x; row < rows.count; row += 64u) {
        const uvec3 first = uvec3(region.low + voxelOf(row, rows));
        uint from = slot * sourceCount + first.x + first.y * strides.y + first.z * strides.z;
        uint to = slot * targetCount + first.x + first.y * targetStrides.y
            + first.z * targetStrides.z;
        uint a = source[from];
        uint b = source[from + stride];
        uint c = source[from + 2u * stride];
        uint d = source[from + 3u * stride];
        uint e = source[from + 4u * stride];
        uint f = source[from + 5u * stride];
        from += 6u * stride;
        for (int i = 0; i < extent[AXIS]; ++i) {
            const uint g = source[from];
            uint sum = 4u * (a + g) + 21u * (b + f) + 60u * (c + e) + 86u * d;
#if AXIS == 2
            sum = (sum + (1u << 23)) >> 24;
#endif
            target[to] = sum;
            a = b;
            b = c;
            c = d;
            d = e;
            e = f;
            f = g;
            from += stride;
            to += targetStrides[AXIS];
        }
    }
}
