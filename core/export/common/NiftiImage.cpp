// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/NiftiImage.h"

namespace core {

glm::dmat4 lpsFrom(const mat44& ras, int units)
{
    const double scale = units == NIFTI_UNITS_METER ? 1000.0
        : units == NIFTI_UNITS_MICRON               ? 0.001
                                                    : 1.0;
    glm::dmat4 lps(1.0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column)
            lps[column][row] = (row < 2 ? -scale : scale) * double(ras.m[row][column]);
    }
    return lps;
}

} // namespace core
