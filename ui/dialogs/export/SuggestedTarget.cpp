// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/SuggestedTarget.h"

#include <QDir>
#include <QFileInfo>
#include <QObject>
#include <QStringList>

namespace ui {

namespace {

constexpr qsizetype mostNames = 3; ///< of segments
constexpr qsizetype longestName = 90; ///< letters

/// The folder that the study lies in.
QString parentOf(const core::Volume& volume)
{
    return volume.sourcePath.isEmpty() ? QString() : QFileInfo(volume.sourcePath).absolutePath();
}

QString exportsIn(const QString& parent)
{
    return QDir(parent).filePath(QStringLiteral("Burin exports"));
}

/// Without what some file system or shell takes for something else.
QString harmless(const QString& text)
{
    QString result;
    for (const QChar letter : text) {
        const bool plain = letter.isLetterOrNumber() || letter == QLatin1Char(' ')
            || letter == QLatin1Char('-') || letter == QLatin1Char('_')
            || letter == QLatin1Char(',') || letter == QLatin1Char('+');
        result += plain ? letter : QLatin1Char('_');
    }
    return result.simplified();
}

} // namespace

QString folderBeside(const core::Volume& volume, const QString& otherwise)
{
    const QString parent = parentOf(volume);
    const QFileInfo folder(parent);
    if (parent.isEmpty() || !folder.isDir() || !folder.isWritable())
        return otherwise;
    return exportsIn(parent);
}

QString exportName(
    const core::StudyIdentity& identity, const std::vector<core::Segment>& segments, bool dated)
{
    QStringList study{identity.modality};
    if (dated)
        study += identity.studyDate;
    if (!identity.seriesNumber.isEmpty())
        study += QStringLiteral("series %1").arg(identity.seriesNumber);
    study.removeAll(QString());
    QStringList names;
    for (const core::Segment& segment : segments) {
        if (names.size() < mostNames)
            names += segment.name;
    }
    QString of = names.join(QStringLiteral(", "));
    if (const qsizetype more = qsizetype(segments.size()) - names.size(); more > 0)
        of += QObject::tr(" and %1 more").arg(more);
    QStringList parts{study.join(QLatin1Char(' ')), of};
    parts.removeAll(QString());
    const QString name = harmless(parts.join(QStringLiteral(" - "))).left(longestName).trimmed();
    return name.isEmpty() ? QStringLiteral("segmentation") : name;
}

void makeFolderBeside(const core::Volume& volume, const QString& file)
{
    const QString parent = parentOf(volume);
    if (!parent.isEmpty() && QFileInfo(file).absolutePath() == exportsIn(parent))
        QDir(parent).mkdir(QStringLiteral("Burin exports"));
}

} // namespace ui
