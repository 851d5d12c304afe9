// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/FileShim.h"

#include <QJsonObject>
#include <QMap>

#include <vector>

namespace test {

/// A folder with a session and exports of it, on which commands of the program are disturbed: calls
/// that fail, kills. Afterwards everything there must be as it was or whole and new, and what was
/// told must be there.
class StormStage {
public:
    /// A command, what it writes, and what came of it undisturbed.
    struct Scene {
        const char* name = "";
        QStringList words;
        QStringList targets; ///< files, and the folder of a series
        QString session; ///< of the targets, the one that rows are told of; empty: none is
        QMap<QString, QByteArray> made; ///< its targets, by path
        int milliseconds = 0;
    };

    /// Writes study, session and exports, and carries out every command once, each on what was
    /// there before. Ends the program where that fails.
    explicit StormStage(const WatchedHome& home);

    [[nodiscard]] const std::vector<Scene>& scenes() const { return m_scenes; }
    [[nodiscard]] QString folder() const { return m_home.path(QStringLiteral("out")); }
    /// Everything as it was before the first command.
    void restore() const;
    /// What a disturbed command did wrong; empty: nothing.
    /// @param killed it did not end by itself
    [[nodiscard]] QStringList wrongs(const Scene& scene, const Outcome& outcome, bool killed) const;
    /// Also by the program itself: `burin history`, `burin replay --verify`.
    [[nodiscard]] QStringList wrongsOfSessions(const Scene& scene) const;

private:
    [[nodiscard]] QString at(const char* name) const;
    [[nodiscard]] QString text(const char* name, const QJsonObject& content) const;
    void makeOld();
    void addScene(Scene scene);
    [[nodiscard]] bool isWholeExport(const Scene& scene, const QString& file) const;
    [[nodiscard]] QString wrongOfSession(
        const QString& file, const QList<QJsonObject>& told, bool isWhole) const;
    [[nodiscard]] QStringList sessionsIn(const Scene& scene) const;

    const WatchedHome& m_home;
    QString m_study;
    QMap<QString, QByteArray> m_old; ///< by path
    std::vector<Scene> m_scenes;
};

} // namespace test
