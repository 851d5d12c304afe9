// Codes and labels at listed voxels, and tolerances where there is a field of them.

layout(local_size_x = 64) in;

layout(binding = 0) uniform usampler3D codes;
layout(binding = 1) uniform usampler3D labels;
layout(binding = 0, std430) readonly buffer Voxels { ivec4 voxels[]; };
layout(binding = 1, std430) writeonly buffer Found { uvec4 found[]; };
layout(binding = 2) uniform usampler3D tolerances;

uniform uint voxelCount;
uniform bool hasTolerances;

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= voxelCount)
        return;
    ivec3 voxel = voxels[i].xyz;
    uint tolerance = hasTolerances ? texelFetch(tolerances, voxel, 0).r : 0xFFFFu;
    found[i] = uvec4(texelFetch(codes, voxel, 0).r, texelFetch(labels, voxel, 0).r, tolerance, 0u);
}
