// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QByteArray>
#include <QDateTime>

namespace core {

/// A small picture of what the user saw at a row. No part of the chain: a picture proves nothing.
struct Keyframe {
    RowId row = 0; ///< 0: the study as it was opened
    QDateTime at; ///< UTC
    QByteArray png; ///< about 256 × 192 pixels; empty where only the place is told
};

} // namespace core
