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

/// The result of a run of the program `burin`.
struct Outcome {
    static constexpr int hung = -2;
    int status = -1; ///< −1: it crashed; `hung`: it did not end
    QByteArray output; ///< stdout
    QList<QJsonObject> lines; ///< lines of stdout that are JSON
    QString complaint; ///< stderr
};

/// The environment of a run besides its arguments.
struct Surroundings {
    QMap<QString, QString> variables; ///< in addition to those of this process
    std::size_t addressSpaceBytes = 0; ///< upper limit; 0: none
    int openFiles = 0; ///< most file handles at once; 0: as this process
};

[[nodiscard]] Outcome burin(const QStringList& arguments, const Surroundings& around = {});
[[nodiscard]] Outcome burin(const QStringList& arguments, const QProcessEnvironment& environment);
/// A run that is ended by SIGKILL after @p afterMs: its status is −1 if that came in time. A line
/// that was cut off is not among its lines.
[[nodiscard]] Outcome burinKilled(
    const QStringList& arguments, const QProcessEnvironment& environment, int afterMs);

} // namespace test
