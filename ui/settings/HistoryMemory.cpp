// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/HistoryMemory.h"

#include <QSettings>

#include <algorithm>

namespace ui {

namespace {

const QString settingsKey = QStringLiteral("history/memoryMebibytes");

int bounded(int mebibytes)
{
    return std::clamp(mebibytes, leastHistoryMebibytes, mostHistoryMebibytes);
}

} // namespace

int historyMebibytes()
{
    bool isNumber = false;
    const int kept = QSettings().value(settingsKey).toInt(&isNumber);
    return isNumber ? bounded(kept) : usualHistoryMebibytes;
}

void setHistoryMebibytes(int mebibytes)
{
    QSettings().setValue(settingsKey, bounded(mebibytes));
}

} // namespace ui
