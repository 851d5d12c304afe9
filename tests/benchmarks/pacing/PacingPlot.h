// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/pacing/PacingRecord.h"

#include <QImage>

namespace bench {

/// Time against milliseconds between pictures, phase after phase, with the gaps of the event loop
/// below and a line where pictures come fifteen times a second.
[[nodiscard]] QImage pacingPlot(const PacingRecord& record);

} // namespace bench
