// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

/// Where the working out of chunks is.
struct ChunkStage {
    QString step;
    int percent = 0; ///< of all steps, about
};

} // namespace core
