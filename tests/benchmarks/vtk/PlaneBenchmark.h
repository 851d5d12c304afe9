// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/common/PeerReport.h"

#include <QString>

namespace bench {

/// plane.linear, plane.cubic: an oblique plane of 1024 × 1024 pixels through the demonstration head
/// with the contour of a surface of 20 000 vertices, as a finished picture with window and level,
/// against VTK's vtkImageReslice and vtkCutter, which draw nothing. plane.view: the same plane as
/// the cutting plane of a 3D view, rays and all, linear; no peer draws that. The median of nine
/// turns, by turns.
///
/// Adds its figures to @p report. Prints to stderr how far values and lines agree.
/// @return why they do not, so that there are no figures; empty: there are
QString measurePlanes(PeerReport& report);

} // namespace bench
