// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QByteArray>
#include <QDateTime>

namespace core {

/// A small picture of what the user saw at a row. It is not part of the chain, since a picture
/// proves nothing.
struct Keyframe {
    RowId row = 0; ///< 0: the study as it was opened
    QDateTime at; ///< UTC
    QByteArray png; ///< about 256 × 192 pixels; empty if only its row is listed
};

} // namespace core
