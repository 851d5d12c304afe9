// Tests whether a voxel is protected from carving (core/sculpt/ProtectedLabels.h). The label planes
// are not written at the same time.

// Plane 0 stands for each that is not asked.
layout(binding = 2) uniform usampler3D labelPlane0;
layout(binding = 3) uniform usampler3D labelPlane1;
layout(binding = 4) uniform usampler3D labelPlane2;
layout(binding = 5) uniform usampler3D labelPlane3;

uniform uint protectedPlanes; // one bit per plane that is asked; 0: no label is protected
uniform uint protectedLabels[8]; // one bit per label

bool protectsLabel(uint label)
{
    return (protectedLabels[label >> 5] >> (label & 31u) & 1u) != 0u;
}

bool isProtected(ivec3 voxel)
{
    return ((protectedPlanes & 1u) != 0u && protectsLabel(texelFetch(labelPlane0, voxel, 0).r))
        || ((protectedPlanes & 2u) != 0u && protectsLabel(texelFetch(labelPlane1, voxel, 0).r))
        || ((protectedPlanes & 4u) != 0u && protectsLabel(texelFetch(labelPlane2, voxel, 0).r))
        || ((protectedPlanes & 8u) != 0u && protectsLabel(texelFetch(labelPlane3, voxel, 0).r));
}
