// First stage of radiation: the field around each listed brick, four voxels beyond it, into scratch.
// SOURCE_COVERAGE: max with one layer's coverage (one dispatch a layer); otherwise 255 where the
// label plane holds a shown label. 24³ words a brick.

layout(local_size_x = 64) in;

#include "edit/bricks.glsl"

layout(binding = 0) uniform usampler3D source;
layout(binding = 1) uniform usampler3D pageTable;
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };
layout(binding = 1, std430) buffer Field { uint field[]; };
// Bit 0: some voxel is not 0; bit 1: some voxel is not 255. Where one is clear the brick is uniform.
layout(binding = 2, std430) buffer Summaries { uint summaries[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform bool firstLayer;
uniform uint shown[8]; // one bit a label

uint valueAt(ivec3 voxel)
{
    if (!inside(voxel, volumeSize))
        return 0u;
#ifdef SOURCE_COVERAGE
    uint entry = texelFetch(pageTable, voxel >> 4, 0).r;
    return entry == 0u ? 0u : texelFetch(source, atlasTexel(entry, voxel), 0).r;
#else
    uint label = texelFetch(source, voxel, 0).r;
    return (shown[label >> 5] >> (label & 31u) & 1u) * 255u;
#endif
}

void main()
{
    // Nine groups a brick, each invocation one row of 24.
    uint slot = gl_WorkGroupID.x / 9u;
    int row = int(gl_WorkGroupID.x % 9u * 64u + gl_LocalInvocationID.x);
    ivec3 start = brickPosition(int(bricks[slot]), volumeBricks) * brickSide + ivec3(0, row % 24, row / 24)
        - 4;
    uint base = slot * 13824u + uint(row) * 24u;
    uint seen = 0u;
    for (int x = 0; x < 24; ++x) {
        uint value = valueAt(start + ivec3(x, 0, 0));
        if (!firstLayer)
            value = max(value, field[base + uint(x)]);
        field[base + uint(x)] = value;
        seen |= (value != 0u ? 1u : 0u) | (value != 255u ? 2u : 0u);
    }
    if (seen != 0u)
        atomicOr(summaries[slot], seen);
}
