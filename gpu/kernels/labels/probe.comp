// Codes, labels of all planes and pending seeds at listed voxels, and tolerances where there is a field
// of them.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "fields/bricks/seedWord.glsl"

layout(binding = 0) uniform usampler3D codes;
layout(binding = 1) uniform usampler3D labels0;
layout(binding = 2) uniform usampler3D tolerances;
layout(binding = 3) uniform usampler3D wordPages;
layout(binding = 4) uniform usampler3D words;
// Planes that are not in use are plane 0 again.
layout(binding = 5) uniform usampler3D labels1;
layout(binding = 6) uniform usampler3D labels2;
layout(binding = 7) uniform usampler3D labels3;
layout(binding = 0, std430) readonly buffer Voxels { ivec4 voxels[]; };
layout(binding = 1, std430) writeonly buffer Found { uvec4 found[]; };

uniform uint voxelCount;
uniform bool hasTolerances;

uint seedOf(ivec3 voxel)
{
    uint entry = texelFetch(wordPages, voxel >> 4, 0).r;
    uint word = unvisited;
    if (entry != 0u)
        word = texelFetch(words, atlasTexel(entry, voxel), 0).r;
    return isPendingSeed(word) ? labelOf(word) : 0u;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= voxelCount)
        return;
    ivec3 voxel = voxels[i].xyz;
    uint tolerance = hasTolerances ? texelFetch(tolerances, voxel, 0).r : 0xFFFFu;
    uint labels = texelFetch(labels0, voxel, 0).r | texelFetch(labels1, voxel, 0).r << 8
        | texelFetch(labels2, voxel, 0).r << 16 | texelFetch(labels3, voxel, 0).r << 24;
    found[i] = uvec4(texelFetch(codes, voxel, 0).r, labels, tolerance, seedOf(voxel));
}
