// Casts rays into what is seen (core/engine/VoxelReads.h, PickVoxels). One invocation a ray.
// FURTHER_PLANES: there are label planes beside plane 0.

layout(local_size_x = 64) in;

layout(binding = 0) uniform usampler3D codes;
layout(binding = 1) uniform usampler3D radiation;
layout(binding = 2) uniform usampler3D labels;
#ifdef FURTHER_PLANES // plane 0 stands for each that is not in use
layout(binding = 3) uniform usampler3D labels1;
layout(binding = 4) uniform usampler3D labels2;
layout(binding = 5) uniform usampler3D labels3;
#endif
struct Ray {
    ivec4 origin;   // index16; w: samples
    ivec4 perSample; // index16
};
layout(binding = 0, std430) readonly buffer Rays { Ray rays[]; };
layout(binding = 1, std430) writeonly buffer Hits { ivec4 hits[]; }; // nearest voxel; w: 1 if hit
layout(binding = 2, std430) readonly buffer Opacities { uint opacityOfCode[256]; };

uniform ivec3 volumeSize;
uniform uint rayCount;
uniform int seenBy; // core::SeenBy
uniform int thresholdCode;
uniform uint segments[8]; // one bit per label

uint codeAt(ivec3 voxel)
{
    return texelFetch(codes, voxel, 0).r;
}

uint radiationAt(ivec3 voxel)
{
    return texelFetch(radiation, voxel, 0).r;
}

#include "kernels/cut/interpolate.glsl"

bool ofSegment(uint label)
{
    return (segments[label >> 5] >> (label & 31u) & 1u) != 0u;
}

bool ofSegments(ivec3 voxel)
{
    bool found = ofSegment(texelFetch(labels, voxel, 0).r);
#ifdef FURTHER_PLANES
    found = found || ofSegment(texelFetch(labels1, voxel, 0).r)
        || ofSegment(texelFetch(labels2, voxel, 0).r)
        || ofSegment(texelFetch(labels3, voxel, 0).r);
#endif
    return found;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= rayCount)
        return;
    Ray ray = rays[i];
    hits[i] = ivec4(0);
    uint transparency = 65535u;
    uint brightest = 0u;
    bool found = false;
    for (int n = 0; n < ray.origin.w; ++n) {
        ivec3 p = ray.origin.xyz + n * ray.perSample.xyz;
        if (!insideVolume(p))
            continue;
        bool seen = false;
        if (seenBy == 0) {
            seen = material(p, thresholdCode);
        } else if (seenBy == 3) {
            seen = ofSegments((p + (1 << 15)) >> 16);
        } else {
            uint code = interpolatedCode(p);
            if (carved(p))
                continue;
            if (seenBy == 1) {
                transparency = transparency * (65535u - opacityOfCode[code >> 24]) / 65535u;
                seen = transparency <= 32767u;
            } else if (!found || code > brightest) {
                found = true;
                brightest = code;
                hits[i] = ivec4((p + (1 << 15)) >> 16, 1);
            }
        }
        if (seen) {
            hits[i] = ivec4((p + (1 << 15)) >> 16, 1);
            return;
        }
    }
}
