// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/measure/region/Measured.h"
#include "core/volume/VolumeGeometry.h"

#include <QString>

class DcmItem;

namespace core {

class SrTree;

/// What the measurements of a report have in common.
struct SrMeasuredSource {
    const VolumeGeometry& geometry;
    QString frameOfReferenceUid; ///< empty: where they lie is left out
    QString series; ///< its UID
    QString unit; ///< of the values
    QString modality;
};

/// Adds a measurement group (PS3.16 TID 1501; of a region TID 1410, of a ball TID 1411) with
/// tracking ("Measurement 3"), where it lies in the patient (SCOORD3D, at its true places), and
/// what it comes to: length, angle, area, volume, axes, and mean, standard deviation, minimum and
/// maximum of the values. Sizes in voxels have the unit {voxels}. What was drawn over a picture
/// without depth says so in its tracking identifier. Arrows and texts measure nothing and add
/// nothing.
void putMeasured(DcmItem* measurements, const Measured& measured, const SrMeasuredSource& source,
    const SrTree& tree);

} // namespace core
