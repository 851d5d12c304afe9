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

/// The arguments after a verb, parsed by the options of its command: options are `--name VALUE` or
/// `--name=VALUE`, each at most once; all other words may stand before, between or after them; "--"
/// ends the options.
class Arguments {
public:
    Arguments(const Command& command, const QStringList& words);

    /// Why the arguments are invalid; empty if they are valid.
    [[nodiscard]] const QString& problem() const { return m_problem; }
    /// Whether they ask for help (`--help`), which is helpText().
    [[nodiscard]] bool askForHelp() const { return m_askForHelp; }
    [[nodiscard]] const QString& helpText() const { return m_helpText; }

    [[nodiscard]] QString value(const char* option) const;
    [[nodiscard]] bool has(const char* option) const;
    /// The number of options that are given.
    [[nodiscard]] qsizetype optionCount() const { return m_options.size(); }
    [[nodiscard]] const QStringList& rest() const { return m_rest; }

private:
    QMap<QString, QString> m_options;
    QStringList m_rest;
    QString m_problem;
    QString m_helpText;
    bool m_askForHelp = false;
};

/// The options --series and --repair, and --spacing, which all verbs share that open a study.
[[nodiscard]] std::vector<Option> seriesOptions();
[[nodiscard]] std::vector<Option> spacingOption();
/// The series that --series, --repair and --spacing describe together (core::withRepair()).
/// @param repair used if neither --repair nor --spacing is given; "none" means none
[[nodiscard]] QString seriesOf(const Arguments& arguments, const QString& repair = {});
/// What is wrong with the words of --repair or --spacing; empty if nothing is.
[[nodiscard]] QString repairProblem(const Arguments& arguments);
/// Joins the values of --repair and --spacing.
[[nodiscard]] QString repairWords(const QString& repair, const QString& spacing);
/// Reports a failure in one line on stderr.
/// @return the exit status of a command that failed
int reportFailure(const core::Error& error, const QString& about = {});
/// Whether a failure lies with the machine (no memory, no room on the disk, a graphics driver) and
/// not with the request, so that a new attempt may succeed.
[[nodiscard]] bool mayPass(const core::Error& error);
/// From here on failures are also printed as lines of JSON on stdout: which kind, and whether they
/// may pass (mayPass()).
void reportFailuresAsFacts();
/// Reports on stderr if the study's images were read from a session file.
/// @param why LoadedVolume::notFromStudy
void reportNotFromStudy(const std::optional<core::Error>& why, const QString& sessionFile);
/// Reports on stderr what was noticed about a study when it was opened, one line each.
void reportProblems(const core::Volume& volume, const QString& study);
/// Reports what is wrong and how the command is used.
/// @return the exit status of wrong arguments
int reportUsageError(const char* command, const QString& problem);

} // namespace app
