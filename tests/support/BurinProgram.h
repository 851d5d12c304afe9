// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>
#include <QList>
#include <QString>
#include <QStringList>

namespace test {

/// What a run of the program `burin` left.
struct Outcome {
    int status = -1; ///< −1: it crashed
    QByteArray output; ///< stdout
    QList<QJsonObject> lines; ///< of stdout, where they are JSON
    QString complaint; ///< stderr
};

[[nodiscard]] Outcome burin(const QStringList& arguments);

} // namespace test
