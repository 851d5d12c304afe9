// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"
#include "core/volume/Volume.h"

#include <QMap>
#include <QString>
#include <QStringList>

#include <optional>

namespace app {

/// The words after a verb: options with and without a value, and the rest.
class Arguments {
public:
    /// @param valued options that take a value, @param flags options that do not, without "--"
    Arguments(const QStringList& words, const QStringList& valued, const QStringList& flags);

    /// Why the words cannot be understood; empty if they can.
    [[nodiscard]] const QString& problem() const { return m_problem; }
    [[nodiscard]] QString value(const char* option) const;
    [[nodiscard]] bool has(const char* option) const;
    [[nodiscard]] const QStringList& rest() const { return m_rest; }

private:
    QMap<QString, QString> m_options;
    QStringList m_rest;
    QString m_problem;
};

/// The series that --series, --repair and --spacing name together (core::withRepair()).
/// @param repair where neither --repair nor --spacing is given; "none" stands for none
[[nodiscard]] QString seriesOf(const Arguments& arguments, const QString& repair = {});
/// What is wrong with --spacing; empty if nothing is.
[[nodiscard]] QString spacingProblem(const Arguments& arguments);
/// What --repair and --spacing say together.
[[nodiscard]] QString repairWords(const QString& repair, const QString& spacing);
/// Tells a failure in one line on stderr. @return the exit status of a command that failed
int tellFailure(const core::Error& error, const QString& about = {});
/// Tells on stderr, where it is so, that the study's images came out of a session file.
/// @param why LoadedVolume::notFromStudy
void tellNotFromStudy(const std::optional<core::Error>& why, const QString& sessionFile);
/// Tells on stderr what was noticed about a study when it was opened, a line each.
void tellProblems(const core::Volume& volume, const QString& study);
/// Tells how a command is used. @return the exit status of wrong arguments
int tellUsage(const char* command, const QString& problem);

} // namespace app
