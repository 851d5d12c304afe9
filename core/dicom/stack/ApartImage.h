// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <optional>

namespace core {

/// Why an image is not a slice of a volume.
struct ApartImage {
    Clause kind; ///< "localizer", "colour image" …
    Clause reason;
};

/// Recognises colour images, localizers, mosaics and images without a position or a scale; none for
/// a slice. Such images are listed beside the volumes and never dropped.
[[nodiscard]] std::optional<ApartImage> whyApart(const ImageHeader& image);

} // namespace core
