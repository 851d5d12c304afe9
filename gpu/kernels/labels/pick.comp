// Casts rays into what is seen (core/engine/VoxelReads.h, PickVoxels). One invocation a ray.
// SEEN_BY: core::SeenBy. FURTHER_PLANES: there are label planes beside plane 0.

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

// A sample of the ray, index16.
ivec3 sampleOf(Ray ray, int n)
{
    return ray.origin.xyz + n * ray.perSample.xyz;
}

ivec4 hitAt(ivec3 p)
{
    return ivec4((p + (1 << 15)) >> 16, 1);
}

#if SEEN_BY == 0
ivec4 hitOf(Ray ray)
{
    int n = 0;
    bool seen = false;
    while (n < ray.origin.w && !seen) {
        while (n < ray.origin.w && !dense(sampleOf(ray, n), thresholdCode))
            ++n;
        // Whether a place is carved away costs as much as its value, and is asked at few.
        seen = n < ray.origin.w && !carved(sampleOf(ray, n));
        n += seen ? 0 : 1;
    }
    return seen ? hitAt(sampleOf(ray, n)) : ivec4(0);
}
#elif SEEN_BY == 3
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

ivec4 hitOf(Ray ray)
{
    for (int n = 0; n < ray.origin.w; ++n) {
        const ivec4 hit = hitAt(sampleOf(ray, n));
        if (insideVolume(sampleOf(ray, n)) && ofSegments(hit.xyz))
            return hit;
    }
    return ivec4(0);
}
#else
ivec4 hitOf(Ray ray)
{
    ivec4 hit = ivec4(0);
    uint transparency = 65535u;
    uint brightest = 0u;
    for (int n = 0; n < ray.origin.w; ++n) {
        const ivec3 p = sampleOf(ray, n);
        if (!insideVolume(p) || carved(p))
            continue;
        const uint code = interpolatedCode(p);
#if SEEN_BY == 1
        transparency = transparency * (65535u - opacityOfCode[code >> 24]) / 65535u;
        if (transparency <= 32767u)
            return hitAt(p);
#else
        if (hit.w == 0 || code > brightest) {
            brightest = code;
            hit = hitAt(p);
        }
#endif
    }
    return hit;
}
#endif

void main()
{
    const uint i = gl_GlobalInvocationID.x;
    if (i < rayCount)
        hits[i] = hitOf(rays[i]);
}
