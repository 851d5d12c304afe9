// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "core/session/Keyframe.h"
#include "core/session/SessionSource.h"

#include <QJsonObject>

#include <utility>
#include <vector>

namespace core {

/// Everything of a session file but the differences, which are read one by one.
struct SessionContents {
    SessionSource source;
    std::vector<HistoryRow> rows; ///< those without second half have an empty stateHash
    std::vector<std::pair<RowId, RowId>> visited; ///< parent, child
    RowId position = 0;
    std::vector<int> hiddenSegments;
    std::vector<Keyframe> keyframes; ///< by row; without their pictures
    QString chainEnd; ///< hex; it covers the source and every row
    QJsonObject display; ///< as the window put it together; empty: none kept
};

} // namespace core
