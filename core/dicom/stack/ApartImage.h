// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <optional>

namespace core {

/// Why an image is no slice of a volume, in words.
struct ApartImage {
    QString kind; ///< "localizer", "colour image" …
    QString reason;
};

/// Colour, localizers, mosaics and images without a place or a scale (DICOM.md 1.2); none for a
/// slice. They are listed beside the volumes, never dropped.
[[nodiscard]] std::optional<ApartImage> whyApart(const ImageHeader& image);

} // namespace core
