// Computes the greatest footprint in each cell of one piece's box: one invocation per cell, or
// several cells one after the other.
layout(local_size_x = 64) in;

/* Textures */
layout(binding = 0) uniform usampler3D footprints;
layout(binding = 0, r8ui) uniform writeonly uimage3D cells;

/* Uniforms */
uniform ivec3 firstTexel; // of the box
uniform ivec3 texelCount;
uniform ivec3 cellCount;

const int side = 8;

void look(int i)
{
    const ivec3 cell
        = ivec3(i % cellCount.x, i / cellCount.x % cellCount.y, i / (cellCount.x * cellCount.y));
    const ivec3 first = cell * side;
    // One voxel further than the cell, because interpolated samples read it.
    const ivec3 last = min(first + side, texelCount - 1);
    uint greatest = 0u;
    for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x)
                greatest = max(
                    greatest, texelFetch(footprints, firstTexel + ivec3(x, y, z), 0).r);
    imageStore(cells, firstTexel / side + cell, uvec4(greatest));
}

void main()
{
    const int cells = cellCount.x * cellCount.y * cellCount.z;
    const int atOnce = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = int(gl_GlobalInvocationID.x); i < cells; i += atOnce)
        look(i);
}
