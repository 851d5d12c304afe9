// SPDX-License-Identifier: Apache-2.0
#include "app/steps/Arguments.h"

#include "app/steps/JsonLine.h"
#include "core/base/files/SystemFile.h"
#include "core/repair/SeriesRepair.h"
#include "ui/base/ErrorText.h"
#include "ui/texts/ProblemTexts.h"

#include <QCommandLineParser>
#include <QRegularExpression>

#include <algorithm>
#include <cerrno>
#include <cstdio>

namespace app {

namespace {

/// What QCommandLineParser did not understand, in our words.
QString problemOf(const QCommandLineParser& parser, const QStringList& words)
{
    if (const QStringList unknown = parser.unknownOptionNames(); !unknown.isEmpty()) {
        const QString& name = unknown.first();
        const bool isShort = words.contains(QLatin1Char('-') + name);
        return QStringLiteral("unknown option %1%2")
            .arg(isShort ? QStringLiteral("-") : QStringLiteral("--"), name);
    }
    static const QRegularExpression missing(QStringLiteral("^Missing value after '([^']+)'"));
    if (const auto match = missing.match(parser.errorText()); match.hasMatch())
        return QStringLiteral("%1 needs a value").arg(match.captured(1));
    return parser.errorText();
}

bool failuresAreFacts = false; ///< told as lines of JSON too; set before any thread is started

/// In the words of the system, or of SQLite.
bool tellsOfFullDisk(const core::Error& error)
{
    const QString reason = error.arguments.mid(1).join(u' ');
    const QStringList words{core::systemReason(ENOSPC), core::systemReason(EDQUOT),
        QStringLiteral("database or disk is full")};
    return std::any_of(words.begin(), words.end(),
        [&reason](const QString& each) { return reason.contains(each); });
}

/// Qt's, but for its first line, which would have options before the verb.
QString helpOf(const QCommandLineParser& parser, const Command& command)
{
    QString usage = QStringLiteral("Usage: burin %1").arg(QLatin1String(command.name));
    if (*command.words != '\0')
        usage += QLatin1Char(' ') + QLatin1String(command.words);
    const QString text = parser.helpText();
    return usage + QStringLiteral(" [options]") + text.mid(text.indexOf(QLatin1Char('\n')));
}

} // namespace

Arguments::Arguments(const Command& command, const QStringList& words)
{
    QCommandLineParser parser;
    parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
    parser.setApplicationDescription(QString::fromUtf8(command.summary));
    const QCommandLineOption help(QStringLiteral("help"), QStringLiteral("shows this help"));
    parser.addOption(help);
    for (const Option& option : command.options) {
        const QLatin1String name(option.name);
        const QString text = QString::fromUtf8(option.help);
        parser.addOption(option.value ? QCommandLineOption(name, text, QLatin1String(option.value))
                                      : QCommandLineOption(name, text));
    }
    const bool isUnderstood = parser.parse(QStringList(QStringLiteral("burin")) + words);
    m_askForHelp = parser.isSet(help);
    if (m_askForHelp) {
        m_helpText = helpOf(parser, command);
        return;
    }
    if (!isUnderstood) {
        m_problem = problemOf(parser, words);
        return;
    }
    const QStringList given = parser.optionNames();
    for (const Option& option : command.options) {
        const QLatin1String name(option.name);
        if (!parser.isSet(name))
            continue;
        const QString value = option.value ? parser.value(name) : QString();
        if (given.count(name) > 1)
            m_problem = QStringLiteral("--%1 is given twice").arg(name);
        else if (option.value && value.isEmpty())
            m_problem = QStringLiteral("--%1 needs a value").arg(name);
        if (!m_problem.isEmpty())
            return;
        m_options.insert(name, value);
    }
    m_rest = parser.positionalArguments();
}

QString Arguments::value(const char* option) const
{
    return m_options.value(QLatin1String(option));
}

bool Arguments::has(const char* option) const
{
    return m_options.contains(QLatin1String(option));
}

std::vector<Option> seriesOptions()
{
    return {{"series", "UID", "which series or volume of the study"},
        {"repair", "REPAIRS",
            "how the series is repaired on loading: tilt, spacing=even, gap=fill, "
            "gap=split:NUMBER, duplicates=first or duplicates=last, separated by commas; none "
            "repairs nothing"}};
}

std::vector<Option> spacingOption()
{
    return {{"spacing", "COLUMNS,ROWS,SLICES",
        "how many mm the voxels of PNG and TIFF pictures are apart"}};
}

QString seriesOf(const Arguments& arguments, const QString& repair)
{
    const bool isSaid = arguments.has("repair") || arguments.has("spacing");
    return core::withRepair(arguments.value("series"),
        isSaid ? repairWords(arguments.value("repair"), arguments.value("spacing"))
               : repairWords(repair, {}));
}

QString repairProblem(const Arguments& arguments)
{
    core::Clause why;
    if (arguments.has("spacing") && !core::spacingWord(arguments.value("spacing"), &why))
        return QStringLiteral("--spacing: %1").arg(why);
    const QString words = repairWords(arguments.value("repair"), arguments.value("spacing"));
    if (!core::SeriesRepair::fromText(words, &why))
        return QStringLiteral("--repair: %1").arg(why);
    return {};
}

QString repairWords(const QString& repair, const QString& spacing)
{
    QStringList words;
    if (!repair.isEmpty() && repair != QLatin1String("none"))
        words += repair;
    if (const auto word = core::spacingWord(spacing))
        words += *word;
    return words.join(u',');
}

bool mayPass(const core::Error& error)
{
    using core::ErrorCode;
    return error.code == ErrorCode::OutOfMemory || error.code == ErrorCode::GraphicsUnavailable
        || error.code == ErrorCode::ContextLost || error.code == ErrorCode::EngineLost
        || error.code == ErrorCode::SessionUnwritten
        || (error.code == ErrorCode::FileUnwritable && tellsOfFullDisk(error));
}

int reportFailure(const core::Error& error, const QString& about)
{
    const QString prefix = about.isEmpty() ? QString() : about + QStringLiteral(": ");
    std::fprintf(stderr, "burin: %s\n", qUtf8Printable(prefix + ui::errorText(error)));
    if (failuresAreFacts)
        printJsonLine({{QStringLiteral("failure"), prefix + ui::errorText(error)},
            {QStringLiteral("mayBeTransient"), mayPass(error)}});
    return 1;
}

void reportFailuresAsFacts()
{
    failuresAreFacts = true;
}

void reportNotFromStudy(const std::optional<core::Error>& why, const QString& sessionFile)
{
    if (!why)
        return;
    const QString reason = why->code == core::ErrorCode::StudyMissing
        ? QStringLiteral("its study is no longer at %1").arg(why->arguments.value(1))
        : ui::errorText(*why);
    std::fprintf(stderr, "%s: %s; the images that the session holds are used\n",
        qUtf8Printable(sessionFile), qUtf8Printable(reason));
}

void reportProblems(const core::Volume& volume, const QString& study)
{
    for (const core::VolumeProblem& problem : volume.problems) {
        const QString repaired = problem.repairedBy.isEmpty()
            ? QString()
            : QStringLiteral(" Repaired: %1.").arg(problem.repairedBy);
        std::fprintf(stderr, "%s: %s%s\n", qUtf8Printable(study),
            qUtf8Printable(ui::problemText(problem.said)), qUtf8Printable(repaired));
    }
}

int reportUsageError(const char* command, const QString& problem)
{
    std::fprintf(
        stderr, "burin %s: %s (burin %s --help)\n", command, qUtf8Printable(problem), command);
    return 2;
}

} // namespace app
