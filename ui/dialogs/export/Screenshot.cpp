// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/Screenshot.h"

#include "core/base/files/StagedFile.h"

#include "core/export/common/MaskSelection.h"
#include "ui/dialogs/export/ExportRun.h"
#include "ui/dialogs/export/SuggestedTarget.h"
#include "ui/workspace/Workspace.h"

#include <QBuffer>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QPixmap>
#include <QWidget>

#include <algorithm>
#include <array>
#include <optional>

namespace ui {

bool isDicomPicture(const QString& file)
{
    return file.endsWith(QLatin1String(".dcm"), Qt::CaseInsensitive);
}

core::Clause pictureNameObstacle(const QString& file)
{
    static constexpr std::array others{
        "jpg", "jpeg", "bmp", "gif", "tif", "tiff", "webp", "svg", "pdf"};
    const QString ending = QFileInfo(file).suffix().toLower();
    const bool isOther = std::any_of(others.begin(), others.end(),
        [&ending](const char* other) { return ending == QLatin1String(other); });
    return isOther ? core::Clause::saying("the name of a picture of the window ends in .png, or in "
                                          ".dcm for a DICOM one")
                   : core::Clause();
}

core::Result<core::ExportReport> savePicture(
    const QImage& picture, const core::Volume* volume, const QString& file)
{
    if (volume && core::isSourceFile(*volume, file))
        return core::failure(core::ErrorCode::FileUnwritable, file,
            core::Clause::saying("it is a file of the study itself"));
    if (const core::Clause obstacle = pictureNameObstacle(file); !obstacle.isEmpty())
        return core::failure(core::ErrorCode::UnsupportedFormat, file, obstacle);
    if (!isDicomPicture(file)) {
        auto staged = core::StagedFile::create(file, true);
        if (!staged)
            return tl::unexpected(staged.error());
        // Qt's own writer does not notice a disk that fills up at the end.
        QBuffer png;
        QFile written(staged->path());
        if (!png.open(QIODevice::WriteOnly) || !picture.save(&png, "PNG"))
            return core::failure(core::ErrorCode::FileUnwritable, file);
        if (!written.open(QIODevice::WriteOnly | QIODevice::Truncate)
            || written.write(png.data()) != png.data().size() || !written.flush())
            return core::failure(core::ErrorCode::FileUnwritable, file, written.errorString());
        if (const core::Result<void> placed = staged->commit(); !placed)
            return tl::unexpected(placed.error());
        core::ExportReport report;
        report.file = file;
        report.written +=
            core::ReportSentence{core::ReportCode::PngPicture, {picture.width(), picture.height()}};
        return report;
    }
    if (!volume)
        return core::failure(core::ErrorCode::UnsupportedFormat, file,
            core::Clause::saying("no study is open, which a DICOM picture would belong to"));
    // Rows without the padding that images have.
    const QImage rows = picture.convertToFormat(QImage::Format_RGB888);
    std::vector<std::uint8_t> rgb;
    for (int y = 0; y < rows.height(); ++y) {
        const std::uint8_t* row = rows.constScanLine(y);
        rgb.insert(rgb.end(), row, row + std::ptrdiff_t(rows.width()) * 3);
    }
    return core::exportScreenshot(*volume,
        {.file = file,
            .force = true,
            .picture = {.width = rows.width(), .height = rows.height(), .rgb = rgb}},
        core::Progress());
}

QString askAndSavePicture(Workspace& workspace, QWidget& window)
{
    const QImage picture = window.grab().toImage();
    // Whose picture it is does not depend on what is open once the dialog has been answered.
    std::optional<core::Volume> shown;
    if (workspace.volume())
        shown = *workspace.volume();
    const core::Volume* volume = shown ? &*shown : nullptr;
    const bool isDicom = volume && core::dicomSegObstacle(*volume).isEmpty();
    const QString png = QObject::tr("PNG picture (*.png)");
    const QString dicom = QObject::tr("DICOM Secondary Capture, of this patient (*.dcm)");
    const auto chosen =
        askForTarget({.title = QObject::tr("Save picture of the window"),
                         .of = QObject::tr("window"),
                         .ending = QStringLiteral(".png"),
                         .filter = isDicom ? png + QStringLiteral(";;") + dicom : png},
            volume, &window);
    if (!chosen)
        return {};
    QString file = chosen->file;
    // The kind counts where the name was left as it was suggested.
    if (chosen->filter == dicom && file.endsWith(QLatin1String(".png"), Qt::CaseInsensitive)) {
        file = file.chopped(4) + QStringLiteral(".dcm");
        if (QFileInfo::exists(file) && !mayReplace(file, &window))
            return {};
    }
    const auto saved = savePicture(picture, volume, file);
    if (!saved) {
        workspace.fail(saved.error());
        return {};
    }
    return saved->checked.isEmpty()
        ? QObject::tr("%1 is saved.").arg(file)
        : QObject::tr("%1 is saved, and was read again and checked. SHA-256: %2")
              .arg(file, saved->sha256);
}

} // namespace ui
