// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/Volume.h"

#include <glm/glm.hpp>

#include <QString>

#include <vector>

namespace core {

/// The patient in the header of an object. Dates are digits only (YYYYMMDD).
struct HeaderPatient {
    QString name;
    QString id;
    QString birthDate;
};

/// The position of a plane of pixels in a header. LPS mm; directions as stored.
struct HeaderPlane {
    glm::dvec3 position{0.0}; ///< centre of the first pixel
    glm::dvec3 rowDirection{0.0}; ///< along a row, with increasing column index
    glm::dvec3 columnDirection{0.0}; ///< down a column, with increasing row index
    double rowSpacing = 0.0; ///< from row to row
    double columnSpacing = 0.0; ///< from column to column

    /// Centre of a pixel.
    [[nodiscard]] glm::dvec3 at(double column, double row) const;
};

/// What the header of a slice's instance states about itself.
struct SourceHeader {
    HeaderPatient patient;
    QString studyUid;
    QString seriesUid;
    QString frameOfReferenceUid;
    QString sopInstanceUid;
    int rows = 0;
    int columns = 0;
    HeaderPlane plane;
};

/// Reads the headers of the slices' files without pixel data, each file once, or those that were @p
/// kept (visitSourceFiles()).
/// Errors: FileNotFound, FileUnreadable, InvalidGeometry (no position, orientation or spacing),
/// Cancelled.
Result<std::vector<SourceHeader>> readSourceHeaders(
    const std::vector<SourceSlice>& slices, const KeptHeaders* kept, const Progress& progress);

} // namespace core
