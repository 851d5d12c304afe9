// SPDX-License-Identifier: Apache-2.0
#include "core/volume/VoxelEncoding.h"

namespace core {

double VoxelEncoding::value(int code) const
{
    return rescaleSlope * double(storedAtCodeZero + storedStep * code) + rescaleIntercept;
}

int VoxelEncoding::lowestCodeAtLeast(double bound) const
{
    int below = -1;
    int atLeast = codeCount;
    while (atLeast - below > 1) {
        const int middle = (below + atLeast) / 2;
        (value(middle) >= bound ? atLeast : below) = middle;
    }
    return atLeast;
}

int VoxelEncoding::highestCodeAtMost(double bound) const
{
    int atMost = -1;
    int above = codeCount;
    while (above - atMost > 1) {
        const int middle = (above + atMost) / 2;
        (value(middle) <= bound ? atMost : above) = middle;
    }
    return atMost;
}

} // namespace core
