// The last front of a batch shows its labels too (growRing writes those of the fronts before).

layout(local_size_x = 64) in;

#include "edit/growth.glsl"

void main()
{
    uint stride = gl_NumWorkGroups.x * 64u;
    for (uint i = gl_GlobalInvocationID.x; i < state.frontCount; i += stride) {
        ivec3 voxel = voxelAt(front[i]);
        imageStore(labels, voxel,
            uvec4(labelOf(imageLoad(words, atlasTexel(pageEntry(voxel), voxel)).r)));
    }
}
