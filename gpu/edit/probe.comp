// Codes and labels at listed voxels.

layout(local_size_x = 64) in;

layout(binding = 0) uniform usampler3D codes;
layout(binding = 1) uniform usampler3D labels;
layout(binding = 0, std430) readonly buffer Voxels { ivec4 voxels[]; };
layout(binding = 1, std430) writeonly buffer Found { uvec2 found[]; };

uniform uint voxelCount;

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i < voxelCount)
        found[i] = uvec2(texelFetch(codes, voxels[i].xyz, 0).r, texelFetch(labels, voxels[i].xyz, 0).r);
}
