// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <vector>

namespace test {

/// A volume in which true lengths are known.
struct MeasurePhantom {
    const char* name = "";
    core::Volume volume;

    /// Returns the place at which a view shows a true place (both LPS mm). They differ only in a
    /// volume with uneven distances between slices.
    [[nodiscard]] glm::dvec3 shown(const glm::dvec3& trueLps) const;
};

/// Returns five phantoms: isotropic, slices eight times as far apart as pixels, tilted, unevenly
/// spaced, oblique. Each reaches at least 30 mm from the origin in all directions.
[[nodiscard]] std::vector<MeasurePhantom> measurePhantoms();

} // namespace test
