// SPDX-License-Identifier: Apache-2.0
#include "ui/report/AuditTexts.h"

#include "core/repair/SeriesRepair.h"
#include "ui/base/NumberText.h"
#include "ui/report/AuditSegments.h"
#include "ui/texts/ClauseText.h"
#include "ui/texts/SessionTexts.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>

namespace ui {

namespace {

using Standing = core::AuditStep::Standing;
constexpr int shortHash = 10; // digits; enough to tell states of one session apart

QString tr(const char* text)
{
    return QCoreApplication::translate("ui::AuditTexts", text);
}

QString timeText(const QDateTime& at)
{
    return at.toUTC().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

/// A number's groups stay on one line.
QString unbroken(QString text)
{
    static const QRegularExpression gap(QStringLiteral("(?<=\\d) (?=\\d{3})"));
    return text.replace(gap, QString(QChar::Nbsp));
}

/// "1 step", "41 steps".
QString counted(qlonglong count, const char* one, const char* many)
{
    return countText(count) + u' ' + (count == 1 ? tr(one) : tr(many));
}

QString sizeText(std::size_t bytes)
{
    return QLocale::c().formattedDataSize(qint64(bytes), 1, QLocale::DataSizeTraditionalFormat);
}

int count(const core::AuditReport& report, Standing standing)
{
    return int(std::count_if(report.steps.begin(), report.steps.end(),
        [standing](const core::AuditStep& step) { return step.standing == standing; }));
}

/// Distinct texts in the order in which they first appear.
template <typename Text> QStringList distinct(const core::AuditReport& report, Text text)
{
    QStringList list;
    for (const core::AuditStep& step : report.steps) {
        const QString value = text(step.row.origin);
        if (!value.isEmpty() && !list.contains(value))
            list += value;
    }
    return list;
}

std::vector<AuditTexts::Fact> studyFacts(const core::SessionSource& source)
{
    const auto known = [](const QString& text) { return text.isEmpty() ? tr("none") : text; };
    const glm::dmat4& matrix = source.indexToWorld;
    const auto spacing = [&matrix](int axis) {
        return QString::number(glm::length(glm::dvec3(matrix[axis])), 'g', 4);
    };
    QStringList series{source.seriesDescription, source.modality, source.studyDate};
    series.removeAll(QString());
    std::vector<AuditTexts::Fact> facts{
        {tr("Series"), known(series.join(QStringLiteral(" · ")))},
        {tr("Study UID"), known(source.studyUid)},
        {tr("Series UID"), known(source.seriesUid)},
        {tr("Size"),
            tr("%1 × %2 × %3 voxels of %4 × %5 × %6 mm, %7")
                .arg(source.size.x)
                .arg(source.size.y)
                .arg(source.size.z)
                .arg(spacing(0), spacing(1), spacing(2), source.format)},
        {tr("Voxels, SHA-256"),
            source.voxelsSha256.isEmpty() ? tr("not known")
                                          : QString::fromLatin1(source.voxelsSha256),
            !source.voxelsSha256.isEmpty()},
    };
    if (const auto repair = core::SeriesRepair::fromText(source.repair);
        repair && !repair->isNone())
        facts.push_back({tr("Repaired on loading"),
            QStringLiteral("%1 (%2)").arg(clauseText(repair->inWords()), source.repair)});
    return facts;
}

QString periodText(const core::AuditReport& report)
{
    QDateTime first;
    QDateTime last;
    for (const core::AuditStep& step : report.steps) {
        const QDateTime& at = step.row.origin.at;
        if (!at.isValid())
            continue;
        first = first.isValid() ? std::min(first, at) : at;
        last = last.isValid() ? std::max(last, at) : at;
    }
    if (!first.isValid())
        return tr("not recorded");
    const QString end = first.toUTC().date() == last.toUTC().date()
        ? last.toUTC().toString(QStringLiteral("HH:mm:ss"))
        : timeText(last);
    return tr("%1 to %2 UTC").arg(timeText(first), end);
}

QString stepsText(const core::AuditReport& report)
{
    QStringList parts{counted(count(report, Standing::Done), "stands", "stand")};
    const auto add = [&](Standing standing, const char* words) {
        if (const int steps = count(report, standing))
            parts += countText(steps) + u' ' + tr(words);
    };
    add(Standing::TakenBack, "taken back by a later one");
    add(Standing::Undone, "undone");
    add(Standing::OtherBranch, "on old futures");
    return tr("%1: %2").arg(
        counted(qlonglong(report.steps.size()), "step", "steps"), parts.join(QStringLiteral(", ")));
}

std::vector<AuditTexts::Fact> sessionFacts(const core::AuditReport& report)
{
    const QStringList authors =
        distinct(report, [](const core::RowOrigin& origin) { return origin.author; });
    const QStringList programs =
        distinct(report, [](const core::RowOrigin& origin) { return origin.program; });
    const bool nameless = std::any_of(report.steps.begin(), report.steps.end(),
        [](const core::AuditStep& step) { return step.row.origin.author.isEmpty(); });
    QString who = authors.join(QStringLiteral(", "));
    if (nameless)
        who = who.isEmpty() ? tr("nobody is named") : tr("%1; some steps name nobody").arg(who);
    return {
        {tr("File"), report.file},
        {tr("By"), who},
        {tr("Period"), periodText(report)},
        {tr("Program"),
            programs.isEmpty() ? tr("not recorded") : programs.join(QStringLiteral(", "))},
        {tr("History"), stepsText(report)},
    };
}

QString verdictText(const core::AuditReport& report)
{
    if (!report.damage.empty())
        return tr("This history is damaged");
    const auto rows = int(report.steps.size());
    return report.sealed == rows ? tr("This history is whole")
                                 : tr("This history is whole; its last steps are not sealed");
}

QString explanationText(const core::AuditReport& report)
{
    const auto rows = qlonglong(report.steps.size());
    QStringList sentences{
        tr("Every hash was computed again for this report. The chain that binds each step to the "
           "one before it, and the first to the study, is unbroken over %1.")
            .arg(counted(rows, "step", "steps"))};
    sentences += tr("%1 of %2 sealed: the voxels changed and the state reached are as they were "
                    "recorded.")
                     .arg(countText(report.sealed),
                         rows == 1 ? tr("1 step is") : tr("%1 steps are").arg(countText(rows)));
    const auto open = qlonglong(std::count_if(report.steps.begin(), report.steps.end(),
        [](const core::AuditStep& step) { return step.row.stateHash.isEmpty(); }));
    if (open > 0)
        sentences += tr("%1 written down but not finished when the session was left; it is carried "
                        "out again when the session is opened.")
                         .arg(open == 1 ? tr("1 step was") : tr("%1 steps were").arg(open));
    // Where the file lies is nobody's business here: folders are named after patients.
    for (const core::Error& error : report.damage)
        sentences += tr("Damaged: %1.").arg(damageText(error));
    return sentences.join(u' ');
}

/// Where a step of an old future hangs: the branch that lists it, and the step before its first.
QString branchText(const core::AuditReport& report, core::RowId row)
{
    for (const core::HistoryBranch& branch : report.branches) {
        if (std::find(branch.rows.begin(), branch.rows.end(), row) == branch.rows.end())
            continue;
        return branch.forksAt == 0
            ? tr("old future, from the beginning")
            : tr("old future, behind step %1").arg(qlonglong(branch.forksAt));
    }
    return tr("old future");
}

QString noteText(const core::AuditReport& report, const core::AuditStep& step)
{
    switch (step.standing) {
    case Standing::Done:
        return step.revisedBy == 0 ? QString()
                                   : tr("revised by step %1").arg(qlonglong(step.revisedBy));
    case Standing::TakenBack:
        return tr("taken back by step %1").arg(qlonglong(step.takenBackBy));
    case Standing::Undone:
        return tr("undone");
    case Standing::OtherBranch:
        return branchText(report, step.row.id);
    }
    return {};
}

AuditTexts::Step stepTexts(const core::AuditReport& report, const core::AuditStep& step)
{
    const core::HistoryRow& row = step.row;
    const bool told = row.origin.at.isValid();
    QString howMuch = row.statistics.voxelsChanged == 0
        ? QStringLiteral("—")
        : counted(row.statistics.voxelsChanged, "voxel", "voxels");
    if (row.deltaBytes > 0)
        howMuch += QStringLiteral("\n") + sizeText(row.deltaBytes);
    return {.number = QString::number(row.id),
        .when = told ? timeText(row.origin.at) : tr("not recorded"),
        .who = row.origin.author.isEmpty() ? QStringLiteral("—") : row.origin.author,
        .what = unbroken(row.name),
        .note = noteText(report, step),
        .howMuch = unbroken(howMuch),
        .hash = row.stateHash.isEmpty() ? tr("not finished")
                                        : QString::fromLatin1(row.stateHash.left(shortHash)),
        .stands = step.standing == Standing::Done};
}

AuditTexts::Picture pictureTexts(const core::AuditReport& report, const core::Keyframe& keyframe)
{
    const auto hash = QCryptographicHash::hash(keyframe.png, QCryptographicHash::Sha256).toHex();
    QString caption = tr("The study as it was opened");
    if (keyframe.row > 0 && keyframe.row <= core::RowId(report.steps.size())) {
        const core::AuditStep& step = report.steps[std::size_t(keyframe.row - 1)];
        caption = tr("Step %1: %2").arg(QString::number(keyframe.row), unbroken(step.row.name));
        if (step.standing != Standing::Done)
            caption += QStringLiteral(" (%1)").arg(noteText(report, step));
    }
    return {.caption = caption, .sha256 = QString::fromLatin1(hash), .png = keyframe.png};
}

QString millilitresText(double millilitres)
{
    return tr("%1 mL").arg(millilitres, 0, 'f', millilitres < 10.0 ? 2 : 1);
}

/// @param isCounted no volume is told
AuditTexts::Segment segmentTexts(const core::SegmentStatistics& measured, bool isCounted)
{
    const QString voxels = unbroken(counted(qlonglong(measured.voxels), "voxel", "voxels"));
    AuditTexts::Segment texts{.name = measured.segment.name,
        .size = measured.voxels == 0 ? tr("no voxel")
            : isCounted
            ? voxels
            : QStringLiteral("%1, %2").arg(millilitresText(measured.millilitres), voxels),
        .change = {}};
    const auto& change = measured.sinceImport;
    if (change && isCounted)
        texts.change = tr("imported; Dice %1 with what it was").arg(change->dice, 0, 'f', 3);
    else if (change)
        texts.change = tr("imported; %1 added and %2 taken since, Dice %3")
                           .arg(millilitresText(change->addedMl), millilitresText(change->takenMl))
                           .arg(change->dice, 0, 'f', 3);
    return texts;
}

void addSegments(AuditTexts& texts, const AuditSegments& segments)
{
    if (segments.areUnknown) {
        texts.aboutSegments = tr("They were not measured: the study could not be read.");
        return;
    }
    for (const AuditSegments::One& one : segments.segments) {
        texts.segments.push_back(segmentTexts(one.measured, segments.areCounted));
        if (one.changes.isEmpty())
            continue;
        const auto hash = QCryptographicHash::hash(one.changes, QCryptographicHash::Sha256).toHex();
        texts.changes.push_back(
            {.caption = tr("%1, slice %2").arg(one.measured.segment.name).arg(one.slice + 1),
                .sha256 = QString::fromLatin1(hash),
                .png = one.changes});
    }
    texts.aboutSegments = segments.position == 0
        ? tr("As the study was opened.")
        : tr("As they stand after step %1.").arg(qlonglong(segments.position));
    texts.aboutChanges =
        tr("Imported masks against the segments as they stand, each in the slice with the most "
           "changes: added green, taken red, unchanged blue.");
}

} // namespace

AuditTexts AuditTexts::of(const core::AuditReport& report, const AuditSegments* segments)
{
    AuditTexts texts{.title = tr("Audit report"),
        .subtitle = tr("What was done in this session, step by step, as its file recorded it."),
        .study = studyFacts(report.source),
        .session = sessionFacts(report),
        .sound = report.damage.empty(),
        .verdict = verdictText(report),
        .explanation = explanationText(report),
        .noSteps = tr("Nothing was done yet."),
        .aboutPictures =
            tr("What the 3D view showed, without its annotations. Pictures are no part "
               "of the chain: they illustrate, the hashes prove."),
        .noPictures = tr("The session holds no picture."),
        .footer = tr("Made by %1 on %2 UTC · research use, not a medical device")
                      .arg(report.made.program, timeText(report.made.at))};
    texts.session.push_back({tr("Chain ends at"), report.chainEnd, true});
    for (const core::AuditStep& step : report.steps)
        texts.steps.push_back(stepTexts(report, step));
    if (segments)
        addSegments(texts, *segments);
    for (const core::Keyframe& keyframe : report.keyframes)
        texts.pictures.push_back(pictureTexts(report, keyframe));
    return texts;
}

} // namespace ui
