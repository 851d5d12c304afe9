// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// One report of the pen: place, pressure and time.
struct PenSample {
    double xMm = 0.0; ///< in the view plane, right of the target
    double yMm = 0.0; ///< up from the target
    double pressure = 1.0; ///< 0 … 1
    double tSeconds = 0.0;
};

} // namespace core
