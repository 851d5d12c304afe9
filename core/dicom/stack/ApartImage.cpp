// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/stack/ApartImage.h"

namespace core {

namespace {

Clause inFrames(const Clause& reason, const ImageHeader& image)
{
    return image.frames > 1 ? Clause::saying("%1, %2 frames", reason, image.frames) : reason;
}

Clause missingOf(const ImageHeader& image)
{
    if (image.position)
        return Clause::saying("no orientation in the patient");
    return image.plane ? Clause::saying("no position in the patient")
                       : Clause::saying("no position or orientation in the patient");
}

} // namespace

std::optional<ApartImage> whyApart(const ImageHeader& image)
{
    const QString& photometric = image.layout.photometric;
    if (image.layout.samplesPerPixel != 1
        || !(photometric.isEmpty() || photometric.startsWith(QLatin1String("MONOCHROME")))) {
        return ApartImage{Clause::saying("colour image"), inFrames(photometric, image)};
    }
    const QString type = image.imageType.join(QLatin1Char('\\'));
    for (const char* word : {"LOCALIZER", "SCOUT", "TOPOGRAM", "SURVIEW", "SCANOSCOPE"}) {
        if (type.contains(QLatin1String(word)))
            return ApartImage{Clause::saying("localizer"), type};
    }
    if (type.contains(QLatin1String("MOSAIC"))) {
        return ApartImage{Clause::saying("mosaic"),
            Clause::saying("Siemens mosaic: many slices tiled in one image; not read as a volume")};
    }
    if (image.framesUnplaced) {
        // One frame is claimed, or groups for frames without any.
        return ApartImage{Clause::saying("multi-frame image"),
            image.frames > 1
                ? Clause::saying("nothing says where each of its %1 frames lies", image.frames)
                : Clause::saying("nothing says where its frames lie")};
    }
    if (image.framesWithoutGroup > 0) {
        return ApartImage{Clause::saying("image without a place"),
            Clause::saying("no position in the patient for %1 of its %2 frames",
                image.framesWithoutGroup, image.frames)};
    }
    if (!image.position || !image.plane) {
        return ApartImage{Clause::saying("image without a place"),
            image.frames > 1
                ? Clause::saying("%1 for its %2 frames", missingOf(image), image.frames)
                : missingOf(image)};
    }
    if (!image.spacing)
        return ApartImage{Clause::saying("image without a scale"),
            inFrames(Clause::saying("no pixel spacing"), image)};
    return std::nullopt;
}

} // namespace core
