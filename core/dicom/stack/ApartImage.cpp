// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/stack/ApartImage.h"

namespace core {

namespace {

QString inFrames(const ImageHeader& image)
{
    return image.frames > 1 ? QStringLiteral(", %1 frames").arg(image.frames) : QString();
}

QString missingOf(const ImageHeader& image)
{
    QStringList missing;
    if (!image.position)
        missing.append(QStringLiteral("position"));
    if (!image.plane)
        missing.append(QStringLiteral("orientation"));
    return QStringLiteral("no %1 in the patient").arg(missing.join(QLatin1String(" or ")));
}

} // namespace

std::optional<ApartImage> whyApart(const ImageHeader& image)
{
    const QString& photometric = image.layout.photometric;
    if (image.layout.samplesPerPixel != 1
        || !(photometric.isEmpty() || photometric.startsWith(QLatin1String("MONOCHROME")))) {
        return ApartImage{QStringLiteral("colour image"), photometric + inFrames(image)};
    }
    const QString type = image.imageType.join(QLatin1Char('\\'));
    for (const char* word : {"LOCALIZER", "SCOUT", "TOPOGRAM", "SURVIEW", "SCANOSCOPE"}) {
        if (type.contains(QLatin1String(word)))
            return ApartImage{QStringLiteral("localizer"), type};
    }
    if (type.contains(QLatin1String("MOSAIC"))) {
        return ApartImage{QStringLiteral("mosaic"),
            QStringLiteral("Siemens mosaic: many slices tiled in one image; not read as a volume")};
    }
    if (image.framesUnplaced) {
        return ApartImage{QStringLiteral("multi-frame image"),
            QStringLiteral("nothing says where each of its %1 frames lies").arg(image.frames)};
    }
    if (!image.position || !image.plane) {
        return ApartImage{QStringLiteral("image without a place"),
            missingOf(image)
                + (image.frames > 1 ? QStringLiteral(" for its %1 frames").arg(image.frames)
                                    : QString())};
    }
    if (!image.spacing)
        return ApartImage{QStringLiteral("image without a scale"),
            QStringLiteral("no pixel spacing") + inFrames(image)};
    return std::nullopt;
}

} // namespace core
