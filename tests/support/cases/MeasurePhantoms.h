// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <vector>

namespace test {

/// A volume in which lengths are known.
struct MeasurePhantom {
    const char* name = "";
    core::Volume volume;

    /// Where a view shows a place of the patient: elsewhere only between uneven slices.
    [[nodiscard]] glm::dvec3 shown(const glm::dvec3& trueLps) const;
};

/// Isotropic, slices eight times as far apart as pixels, tilted, uneven, oblique. Around the origin
/// each reaches 30 mm in all directions.
[[nodiscard]] std::vector<MeasurePhantom> measurePhantoms();

} // namespace test
