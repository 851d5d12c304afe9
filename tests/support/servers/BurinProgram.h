// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>
#include <QList>
#include <QMap>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>

#include <cstddef>

namespace test {

/// What a run of the program `burin` left.
struct Outcome {
    static constexpr int hung = -2;
    int status = -1; ///< −1: it crashed; hung: it did not end
    QByteArray output; ///< stdout
    QList<QJsonObject> lines; ///< of stdout, where they are JSON
    QString complaint; ///< stderr
};

/// What a run is given besides its arguments.
struct Surroundings {
    QMap<QString, QString> variables; ///< besides those of this process
    std::size_t addressSpaceBytes = 0; ///< at most; 0: no limit
};

[[nodiscard]] Outcome burin(const QStringList& arguments, const Surroundings& around = {});
[[nodiscard]] Outcome burin(const QStringList& arguments, const QProcessEnvironment& environment);

} // namespace test
