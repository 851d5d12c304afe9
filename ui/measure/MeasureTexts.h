// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"
#include "core/measure/MeasuredSize.h"
#include "core/measure/region/RegionStatistics.h"
#include "core/volume/Volume.h"

#include <QString>
#include <QStringList>

namespace ui {

/// "34.2 mm".
[[nodiscard]] QString lengthText(double mm);

/// "ellipse", "angle" …
[[nodiscard]] QString kindText(core::Measurement::Kind kind);

/// The size of a measurement in lines of text, after its own text if it has one: "120.4 mm²", "20.0
/// × 7.7 mm". Units are voxels if the spacing of the volume is unknown. The last line is
/// "projected" if the measurement was drawn on a picture without depth.
[[nodiscard]] QStringList sizeLines(
    const core::Measurement& measurement, const core::MeasuredSize& size);

/// The values in a region in lines of text: "mean 41.2 ± 12.0 HU", "−20 … 88 HU in 240" (voxels).
/// For a probe only its value.
[[nodiscard]] QStringList valueLines(const core::Measurement& measurement,
    const core::RegionStatistics& values, const core::Volume& volume);

/// The place (LPS mm) to which views go when the measurement is chosen in a list: its centre; for
/// an angle, its vertex; for an arrow or text, its first point.
[[nodiscard]] glm::dvec3 middleOf(const core::Measurement& measurement);

} // namespace ui
