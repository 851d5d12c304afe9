// First stage of radiation: copies the field around each listed box, with a margin of four voxels,
// into scratch memory, 24³ words per brick. SOURCE_COVERAGE: the maximum with one layer's coverage
// (one dispatch per layer). Otherwise: the maximum with 255 where a label plane holds a shown label
// (one dispatch per plane). AT_TOLERANCE: where it would hold one if a segment had grown to a
// tolerance.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "kernels/radiation/radiationRegion.glsl"
#ifdef AT_TOLERANCE
#include "kernels/spread/toleranceLabel.glsl"
#endif

layout(binding = 0) uniform usampler3D source;
layout(binding = 1) uniform usampler3D pageTable;
layout(binding = 1, std430) buffer Field { uint field[]; };
// Bit 0: some voxel is not 0. Bit 1: some voxel is not 255. If one of them is clear the box is
// uniform.
layout(binding = 2, std430) buffer Summaries { uint summaries[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform bool firstLayer;
uniform bool subtract; // subtract what an earlier layer has carved
uniform uint shown[8]; // one bit per label

void main()
{
    // Nine groups per brick; each invocation handles one row of up to 24 voxels.
    uint slot = gl_WorkGroupID.x / 9u;
    Region region = regionOf(slot);
    ivec3 size = region.size + 8;
    Box rows = boxOf(ivec3(size.yz, 1));
    uint number = gl_WorkGroupID.x % 9u * 64u + gl_LocalInvocationID.x;
    if (number >= rows.count)
        return;
    ivec3 at = region.low + ivec3(0, voxelOf(number, rows).xy);
    ivec3 start = brickPosition(region.brick, volumeBricks) * brickSide + at - 4;
    bool rowInside = inside(ivec3(0, start.yz), volumeSize);
    uint base = slot * 13824u + uint(at.x + 24 * (at.y + 24 * at.z));
    uint seen = 0u;
#ifdef SOURCE_COVERAGE
    uint entry = 0u;
#endif
    for (int x = 0; x < size.x; ++x) {
        ivec3 voxel = start + ivec3(x, 0, 0);
        uint value = 0u;
        if (rowInside && voxel.x >= 0 && voxel.x < volumeSize.x) {
#ifdef SOURCE_COVERAGE
            if (x == 0 || voxel.x % brickSide == 0)
                entry = texelFetch(pageTable, voxel / brickSide, 0).r;
            if (entry != 0u)
                value = texelFetch(source, atlasTexel(entry, voxel), 0).r;
#else
            uint label = texelFetch(source, voxel, 0).r;
#ifdef AT_TOLERANCE
            label = labelAtTolerance(label, voxel);
#endif
            value = (shown[label >> 5] >> (label & 31u) & 1u) * 255u;
#endif
        }
        if (!firstLayer) {
            uint known = field[base + uint(x)];
            value = subtract ? min(known, 255u - value) : max(value, known);
        }
        field[base + uint(x)] = value;
        seen |= (value != 0u ? 1u : 0u) | (value != 255u ? 2u : 0u);
    }
    if (seen != 0u)
        atomicOr(summaries[slot], seen);
}
