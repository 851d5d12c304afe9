// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/HistoryMemory.h"

#include <QSettings>

#include <algorithm>

namespace ui {

namespace {

const QString memoryKey = QStringLiteral("history/memoryMebibytes");

int bounded(int mebibytes)
{
    return std::clamp(mebibytes, leastHistoryMebibytes, mostHistoryMebibytes);
}

} // namespace

int historyMebibytes()
{
    bool isNumber = false;
    const int kept = QSettings().value(memoryKey).toInt(&isNumber);
    return isNumber ? bounded(kept) : usualHistoryMebibytes;
}

void setHistoryMebibytes(int mebibytes)
{
    QSettings().setValue(memoryKey, bounded(mebibytes));
}

} // namespace ui
