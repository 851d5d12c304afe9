// Computes the range of radiation and the greatest segmentation in cells of 8³ voxels: one
// invocation per cell of a box of cells, or several cells one after the other.
layout(local_size_x = 64) in;

/* Textures */
layout(binding = 0) uniform sampler3D radiation;
layout(binding = 1) uniform sampler3D segmentation;

/* Uniforms, in cells */
uniform ivec3 firstCell;
uniform ivec3 cellCount;

/* Output: least radiation | greatest radiation << 8 | greatest segmentation << 16 */
layout(std430, binding = 0) writeonly buffer Result { uint words[]; };

const int side = 8;

void look(int i)
{
    const ivec3 cell = firstCell
        + ivec3(i % cellCount.x, i / cellCount.x % cellCount.y, i / (cellCount.x * cellCount.y));
    const ivec3 first = cell * side;
    // One voxel further than the cell, because interpolated samples read it.
    const ivec3 last = min(first + side, textureSize(radiation, 0) - 1);
    float leastRadiation = 1.0;
    float greatestRadiation = 0.0;
    float greatestSegmentation = 0.0;
    for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                const float carved = texelFetch(radiation, ivec3(x, y, z), 0).r;
                leastRadiation = min(leastRadiation, carved);
                greatestRadiation = max(greatestRadiation, carved);
                greatestSegmentation
                    = max(greatestSegmentation, texelFetch(segmentation, ivec3(x, y, z), 0).r);
            }
        }
    }
    const uvec3 bytes
        = uvec3(vec3(leastRadiation, greatestRadiation, greatestSegmentation) * 255.0 + 0.5);
    words[i] = bytes.x | bytes.y << 8 | bytes.z << 16;
}

void main()
{
    const int cells = cellCount.x * cellCount.y * cellCount.z;
    const int atOnce = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = int(gl_GlobalInvocationID.x); i < cells; i += atOnce)
        look(i);
}
