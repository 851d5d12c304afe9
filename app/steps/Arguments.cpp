// SPDX-License-Identifier: Apache-2.0
#include "app/steps/Arguments.h"

#include "core/repair/SeriesRepair.h"
#include "ui/base/ErrorText.h"

#include <cstdio>

namespace app {

Arguments::Arguments(const QStringList& words, const QStringList& valued, const QStringList& flags)
{
    for (qsizetype i = 0; i < words.size() && m_problem.isEmpty(); ++i) {
        const QString& word = words[i];
        if (!word.startsWith(QLatin1String("--"))) {
            m_rest.append(word);
            continue;
        }
        const QString option = word.mid(2);
        if (m_options.contains(option))
            m_problem = QStringLiteral("%1 is given twice").arg(word);
        else if (flags.contains(option))
            m_options.insert(option, {});
        else if (!valued.contains(option))
            m_problem = QStringLiteral("unknown option %1").arg(word);
        else if (i + 1 == words.size() || words[i + 1].isEmpty())
            m_problem = QStringLiteral("%1 needs a value").arg(word);
        else
            m_options.insert(option, words[++i]);
    }
}

QString Arguments::value(const char* option) const
{
    return m_options.value(QLatin1String(option));
}

bool Arguments::has(const char* option) const
{
    return m_options.contains(QLatin1String(option));
}

QString seriesOf(const Arguments& arguments, const QString& repair)
{
    const bool isSaid = arguments.has("repair") || arguments.has("spacing");
    return core::withRepair(arguments.value("series"),
        isSaid ? repairWords(arguments.value("repair"), arguments.value("spacing"))
               : repairWords(repair, {}));
}

QString spacingProblem(const Arguments& arguments)
{
    QString why;
    if (arguments.has("spacing") && !core::spacingWord(arguments.value("spacing"), &why))
        return QStringLiteral("--spacing: %1").arg(why);
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

int tellFailure(const core::Error& error, const QString& about)
{
    const QString prefix = about.isEmpty() ? QString() : about + QStringLiteral(": ");
    std::fprintf(stderr, "burin: %s\n", qUtf8Printable(prefix + ui::errorText(error)));
    return 1;
}

void tellNotFromStudy(const std::optional<core::Error>& why, const QString& sessionFile)
{
    if (!why)
        return;
    const QString reason = why->code == core::ErrorCode::StudyMissing
        ? QStringLiteral("its study is no longer at %1").arg(why->arguments.value(1))
        : ui::errorText(*why);
    std::fprintf(stderr, "%s: %s; the images that the session holds are used\n",
        qUtf8Printable(sessionFile), qUtf8Printable(reason));
}

void tellProblems(const core::Volume& volume, const QString& study)
{
    for (const core::VolumeProblem& problem : volume.problems) {
        const QString repaired = problem.repairedBy.isEmpty()
            ? QString()
            : QStringLiteral(" Repaired: %1.").arg(problem.repairedBy);
        std::fprintf(stderr, "%s: %s%s\n", qUtf8Printable(study), qUtf8Printable(problem.text),
            qUtf8Printable(repaired));
    }
}

int tellUsage(const char* command, const QString& problem)
{
    std::fprintf(stderr, "burin %s: %s (burin --help)\n", command, qUtf8Printable(problem));
    return 2;
}

} // namespace app
