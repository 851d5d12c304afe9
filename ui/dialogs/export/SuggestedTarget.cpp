// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/SuggestedTarget.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QObject>
#include <QRegularExpression>
#include <QSettings>
#include <QStandardPaths>
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

/// The first ending of a part of a filter: "csv" of "Tables (*.csv *.txt)".
QString endingIn(const QString& filter)
{
    static const QRegularExpression ending(QStringLiteral("\\*\\.(\\w+)"));
    return ending.match(filter).captured(1);
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

QString exportName(const core::StudyIdentity& identity, const std::vector<core::Segment>& segments,
    bool dated, int point)
{
    QStringList names;
    for (const core::Segment& segment : segments) {
        if (names.size() < mostNames)
            names += segment.name;
    }
    QString of = names.join(QStringLiteral(", "));
    if (const qsizetype more = qsizetype(segments.size()) - names.size(); more > 0)
        of += QObject::tr(" and %1 more").arg(more);
    return exportName(identity, of, dated, point);
}

QString exportName(const core::StudyIdentity& identity, const QString& of, bool dated, int point)
{
    QStringList study{identity.modality};
    if (dated)
        study += identity.studyDate;
    if (!identity.seriesNumber.isEmpty())
        study += QStringLiteral("series %1").arg(identity.seriesNumber);
    if (point > 0)
        study += QStringLiteral("point %1").arg(point);
    study.removeAll(QString());
    QStringList parts{study.join(QLatin1Char(' ')), of};
    parts.removeAll(QString());
    const QString name = harmless(parts.join(QStringLiteral(" - "))).left(longestName).trimmed();
    return name.isEmpty() ? QStringLiteral("segmentation") : name;
}

int pointOf(const core::Volume& volume)
{
    const core::SeriesAlternatives* series = volume.alternatives.get();
    return series && series->times.size() > 1 ? series->time + 1 : 0;
}

bool makeFolderBeside(const core::Volume& volume, const QString& file)
{
    const QString parent = parentOf(volume);
    return !parent.isEmpty() && QFileInfo(file).absolutePath() == exportsIn(parent)
        && QDir(parent).mkdir(QStringLiteral("Burin exports"));
}

QString suggestedFolder(const core::Volume* volume)
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return volume ? folderBeside(*volume, documents) : documents;
}

QString exportFolderKey()
{
    return QStringLiteral("export/folder");
}

QString rememberedFolder(const QString& key, const QString& suggested)
{
    return QSettings().value(key, suggested).toString();
}

void rememberFolder(const QString& key, const QString& suggested, const QString& file)
{
    const QString chosen = QFileInfo(file).absolutePath();
    if (chosen == QFileInfo(suggested).absoluteFilePath())
        QSettings().remove(key);
    else
        QSettings().setValue(key, chosen);
}

std::optional<ChosenTarget> askForTarget(
    const TargetQuestion& question, const core::Volume* volume, QWidget* parent)
{
    const QString suggested = suggestedFolder(volume);
    const QString folder = rememberedFolder(exportFolderKey(), suggested);
    const QString name = exportName(volume ? volume->identity : core::StudyIdentity(), question.of,
                             true, volume ? pointOf(*volume) : 0)
        + question.ending;
    // A file dialog opens in no folder that is not there.
    const bool made = volume && makeFolderBeside(*volume, QDir(folder).filePath(name));
    QFileDialog dialog(parent, question.title, folder, question.filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(endingIn(dialog.selectedNameFilter()));
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
        [&dialog](const QString& filter) { dialog.setDefaultSuffix(endingIn(filter)); });
    dialog.selectFile(name);
    ChosenTarget chosen;
    if (dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty())
        chosen = {dialog.selectedFiles().first(), dialog.selectedNameFilter()};
    if (made && QFileInfo(chosen.file).absolutePath() != QFileInfo(folder).absoluteFilePath())
        QDir().rmdir(folder);
    if (chosen.file.isEmpty())
        return std::nullopt;
    rememberFolder(exportFolderKey(), suggested, chosen.file);
    return chosen;
}

} // namespace ui
