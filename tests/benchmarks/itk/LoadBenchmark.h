// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/common/PeerReport.h"

#include <QString>

namespace bench {

/// load.*: a folder with a CT series of 450 slices of 512 × 512 voxels, from nothing to voxels in
/// the layout that goes to the GPU (values, histogram and hash included); native and in JPEG
/// lossless; warm, and cold with the files out of the system's cache. Against ITK with GDCM (series
/// sorted, one volume) and dcm2niix (a NIfTI file on disk). load.*.firstSlice: until there is a
/// slice to see, against the whole. load.window.longestStall: the longest event of the window while
/// it opens that series (of three times), by the program's own trace; load.window.refined: until
/// all views are refined.
///
/// Adds its figures to @p report. Prints to stderr what it does. JPEG lossless needs dcmcjpeg.
/// @return why the results are not right, so that there are no figures; empty: there are
QString measureLoading(PeerReport& report);

} // namespace bench
