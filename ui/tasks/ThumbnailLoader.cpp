// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/ThumbnailLoader.h"

#include "core/images/ImagePage.h"
#include "core/repair/SeriesRepair.h"
#include "core/study/StudyLoader.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {

QImage thumbnail(const core::LoadedVolume& volume, int size)
{
    const glm::ivec3 voxels = volume.volume.geometry.size;
    const std::size_t slice = std::size_t(voxels.x) * std::size_t(voxels.y);
    if (slice == 0 || volume.codes.size() < slice * std::size_t(voxels.z))
        return {};
    const std::uint16_t* codes = volume.codes.data() + slice * std::size_t(voxels.z / 2);
    const core::WindowLevel window = volume.volume.defaultWindow;
    const double lowest = window.centre - 0.5 * window.width;
    QImage grey(voxels.x, voxels.y, QImage::Format_Grayscale8);
    for (int y = 0; y < voxels.y; ++y) {
        uchar* line = grey.scanLine(y);
        for (int x = 0; x < voxels.x; ++x) {
            const double value = volume.volume.encoding.value(*codes++);
            const double share = std::clamp((value - lowest) / window.width, 0.0, 1.0);
            line[x] = uchar(255.0 * (volume.volume.displayInverted ? 1.0 - share : share));
        }
    }
    const glm::dvec3 spacing = volume.volume.geometry.spacingMm();
    const QSizeF millimetres(voxels.x * spacing.x, voxels.y * spacing.y);
    const QSizeF shown = millimetres.scaled(size, size, Qt::KeepAspectRatio);
    QImage picture(size, size, QImage::Format_RGB32);
    picture.fill(Qt::black);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF((size - shown.width()) / 2, (size - shown.height()) / 2, shown.width(),
                          shown.height()),
        grey.scaled(shown.toSize().expandedTo(QSize(1, 1)), Qt::IgnoreAspectRatio,
            Qt::SmoothTransformation));
    return picture;
}

ThumbnailLoader::ThumbnailLoader(const QStringList& files, int size)
{
    for (int index = 0; index < files.size(); ++index) {
        m_worker.start(
            this,
            [size, file = files[index]]() -> core::Result<QImage> {
                // Of pictures any spacing will do for a thumbnail, not so for a volume.
                const QString series = core::isImageName(file)
                    ? core::withRepair(QString(), QStringLiteral("spacing=1x1x1"))
                    : QString();
                return core::loadVolume(file, series).map([size](const core::LoadedVolume& volume) {
                    return thumbnail(volume, size);
                });
            },
            [this, index](const core::Result<QImage>& picture) {
                if (picture)
                    Q_EMIT ready(index, *picture);
            });
    }
}

} // namespace ui
