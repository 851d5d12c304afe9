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

/// What a measurement comes to by its points, in lines: "120.4 mm²", "20.0 × 7.7 mm". In voxels
/// where the spacing of the volume is unknown; the last line is "projected" if it was drawn over a
/// picture without depth.
[[nodiscard]] QStringList sizeLines(
    const core::Measurement& measurement, const core::MeasuredSize& size);

/// "mean 41.2 ± 12.0 HU", "−20 … 88 HU in 240". Of a probe only its value.
[[nodiscard]] QStringList valueLines(const core::Measurement& measurement,
    const core::RegionStatistics& values, const core::Volume& volume);

/// Where a view is led to: its middle, or the vertex of an angle.
[[nodiscard]] glm::dvec3 middleOf(const core::Measurement& measurement);

} // namespace ui
