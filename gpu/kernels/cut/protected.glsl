// Tests whether a voxel is protected from carving (core/sculpt/ProtectedLabels.h). The label plane
// is not written at the same time.

layout(binding = 2) uniform usampler3D labelPlane;

uniform bool protectsAny;
uniform uint protectedLabels[8]; // one bit per label

bool isProtected(ivec3 voxel)
{
    if (!protectsAny)
        return false;
    uint label = texelFetch(labelPlane, voxel, 0).r;
    return (protectedLabels[label >> 5] >> (label & 31u) & 1u) != 0u;
}
