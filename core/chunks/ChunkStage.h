// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

/// The progress of computing chunks.
struct ChunkStage {
    QString step;
    int percent = 0; ///< of all steps, approximately
};

} // namespace core
