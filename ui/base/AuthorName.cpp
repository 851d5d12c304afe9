// SPDX-License-Identifier: Apache-2.0
#include "ui/base/AuthorName.h"

#include <QSettings>

namespace ui {

namespace {

const QString settingsKey = QStringLiteral("audit/author");

} // namespace

QString authorName()
{
    return QSettings().value(settingsKey).toString();
}

void setAuthorName(const QString& name)
{
    QSettings().setValue(settingsKey, name.simplified());
}

} // namespace ui
