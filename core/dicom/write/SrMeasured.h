// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/measure/region/Measured.h"
#include "core/volume/VolumeGeometry.h"

#include <QString>

class DcmItem;

namespace core {

class SrTree;

/// What all measurements of a structured report have in common.
struct SrMeasuredSource {
    const VolumeGeometry& geometry;
    QString frameOfReferenceUid; ///< empty: no coordinates are written
    QString series; ///< Series Instance UID of the images
    QString unit; ///< unit of the voxel values, such as "HU"
    QString modality;
};

/// Adds a measurement group (PS3.16 TID 1501; TID 1410 for a region of a plane, TID 1411 for a
/// ball). It contains
/// - a tracking identifier ("Measurement 3"), which says "projected" for a measurement that was
///   drawn over a picture without depth, and a new tracking UID;
/// - the position in the patient as SCOORD3D, with the true places of unevenly spaced slices;
/// - the results: length, angle, area, volume, axes, and mean, standard deviation, minimum and
///   maximum of the values. Sizes in voxels have the unit {voxels}.
///
/// Arrows and texts measure nothing and add nothing.
void putMeasured(DcmItem* measurements, const Measured& measured, const SrMeasuredSource& source,
    const SrTree& tree);

} // namespace core
