// One generation: every voxel of the front offers itself as parent to its face neighbours.
//
// The least word wins a voxel (earlier generation, lower label, lower direction), so the result is
// the same on every device. Of all claims on a voxel exactly one finds a word that is no member's;
// that one puts the voxel into the next front.

layout(local_size_x = 64) in;

#include "edit/growth.glsl"

void main()
{
    uint generation = state.generation + 1u;
    uint stride = gl_NumWorkGroups.x * 64u;
    for (uint i = gl_GlobalInvocationID.x; i < state.frontCount; i += stride) {
        ivec3 voxel = voxelAt(front[i]);
        uint label = labelOf(imageLoad(words, atlasTexel(pageEntry(voxel), voxel)).r);
        // A word is final one generation after its claim: now the label plane may show it.
        imageStore(labels, voxel, uvec4(label));
        for (uint direction = 0u; direction < 6u; ++direction) {
            ivec3 neighbour = voxel + faceOffsets[direction];
            if (!inside(neighbour, volumeSize))
                continue;
            ivec3 texel = atlasTexel(pageEntry(neighbour), neighbour);
            uint claim = memberWord(generation, label, direction);
            if (imageLoad(words, texel).r <= claim || !accepts(label, neighbour))
                continue;
            uint before = imageAtomicMin(words, texel, claim);
            if (isMember(before))
                continue;
            enqueue(neighbour);
            markTouched(neighbour);
        }
    }
}
