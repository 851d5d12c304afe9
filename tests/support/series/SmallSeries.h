// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <glm/glm.hpp>

#include <QString>

#include <string>
#include <vector>

namespace test {

/// A small CT series with an arbitrary geometry, for tests of export. Pixels are zero.
struct SmallSeries {
    glm::ivec3 size{12, 9, 6};
    glm::dvec2 spacing{0.7, 0.9}; ///< columns (x), rows (y)
    glm::dvec3 rowDirection{1, 0, 0};
    glm::dvec3 columnDirection{0, 1, 0};
    std::vector<glm::dvec3> positions; ///< per slice, ascending along row × column
    std::string characterSet = "ISO_IR 100";
    std::string patientName = "M\xfcller^J\xf6rg";
    std::string patientId = "P-0815";
    std::string birthDate = "19500102";
    std::string sex = "M";
    std::string studyDate = "20200304";
    bool frameOfReference = true;

    /// Places the slices at equal steps from @p first.
    void placeEvenly(const glm::dvec3& first, const glm::dvec3& step);
    /// Writes one file per slice; the names are unrelated to the order.
    /// @returns the volume as a loader would describe it
    [[nodiscard]] core::Volume write(const QString& folder) const;
    /// The same as one Enhanced CT file whose frames store their positions in functional groups, in
    /// no order; it contains only what these tests need.
    [[nodiscard]] core::Volume writeMultiFrame(const QString& folder) const;

private:
    [[nodiscard]] core::VolumeGeometry geometry() const;
};

} // namespace test
