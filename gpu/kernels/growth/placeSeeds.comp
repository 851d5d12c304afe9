// Marks voxels as pending seeds of a label, or removes pending seeds.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "fields/bricks/seedWord.glsl"

layout(binding = 1) uniform usampler3D pageTable;
layout(binding = 0, r32ui) uniform uimage3D words;
layout(binding = 0, std430) readonly buffer Voxels { ivec4 voxels[]; };

uniform uint voxelCount;
uniform uint label;
uniform bool take;

void main()
{
    if (gl_GlobalInvocationID.x >= voxelCount)
        return;
    ivec3 voxel = voxels[gl_GlobalInvocationID.x].xyz;
    ivec3 texel = atlasTexel(texelFetch(pageTable, voxel >> 4, 0).r, voxel);
    if (take) {
        imageAtomicCompSwap(words, texel, pendingSeedWord(label), unvisited);
        return;
    }
    // A member's word is less than that of any pending seed, so the minimum does not change
    // members.
    imageAtomicMin(words, texel, pendingSeedWord(label));
}
