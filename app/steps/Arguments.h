// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"
#include "core/base/Error.h"
#include "core/volume/Volume.h"

#include <QMap>
#include <QString>
#include <QStringList>

#include <optional>

namespace app {

/// The words after a verb, read by the options that it has: `--name VALUE` or `--name=VALUE`, each
/// once, and the rest, before, between or behind them; "--" ends the options.
class Arguments {
public:
    Arguments(const Command& command, const QStringList& words);

    /// Why the words cannot be understood; empty if they can.
    [[nodiscard]] const QString& problem() const { return m_problem; }
    /// Whether they ask what the verb is and takes (`--help`); helpText() says it.
    [[nodiscard]] bool askForHelp() const { return m_askForHelp; }
    [[nodiscard]] const QString& helpText() const { return m_helpText; }

    [[nodiscard]] QString value(const char* option) const;
    [[nodiscard]] bool has(const char* option) const;
    /// How many options are given.
    [[nodiscard]] qsizetype optionCount() const { return m_options.size(); }
    [[nodiscard]] const QStringList& rest() const { return m_rest; }

private:
    QMap<QString, QString> m_options;
    QStringList m_rest;
    QString m_problem;
    QString m_helpText;
    bool m_askForHelp = false;
};

/// --series and --repair, --spacing: of every verb that opens a study.
[[nodiscard]] std::vector<Option> seriesOptions();
[[nodiscard]] std::vector<Option> spacingOption();
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
