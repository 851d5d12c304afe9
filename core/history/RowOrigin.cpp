// SPDX-License-Identifier: Apache-2.0
#include "core/history/RowOrigin.h"

#include <QCoreApplication>

namespace core {

RowOrigin presentOrigin(const QString& author)
{
    const QString program =
        QCoreApplication::applicationName() + u' ' + QCoreApplication::applicationVersion();
    return {.at = QDateTime::currentDateTimeUtc(),
        .author = author.simplified(),
        .program = program.simplified()};
}

} // namespace core
