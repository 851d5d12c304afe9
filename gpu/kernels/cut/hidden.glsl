// Tests whether a voxel lay in a half space that was hidden from a cut
// (core/sculpt/IntegerHalfSpace.h).

// perVoxel · p − offset for the first voxel of each candidate brick, hiddenCount values per brick
layout(binding = 6, std430) readonly buffer HiddenBases { int hiddenBases[]; };

uniform int hiddenCount;
uniform ivec4 hiddenPerVoxel[16];

bool isHidden(uint candidate, ivec3 local)
{
    for (int i = 0; i < hiddenCount; ++i) {
        ivec3 terms = hiddenPerVoxel[i].xyz * local;
        if (hiddenBases[candidate * uint(hiddenCount) + uint(i)] + terms.x + terms.y + terms.z > 0)
            return true;
    }
    return false;
}
