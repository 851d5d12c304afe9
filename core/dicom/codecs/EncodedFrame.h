// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/DicomElement.h"
#include "core/dicom/base/TransferSyntax.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// The bytes of one frame out of encapsulated pixel data. Fragments are not frames (PS3.5 A.4): a
/// frame may be torn into several. Where there are as many as frames each is one; else JPEG frames
/// begin where a codestream begins. No offset table is trusted, many files have none.
///
/// @param frame of @p frames, 0-based
/// @return none where the fragments cannot be told apart
[[nodiscard]] std::optional<std::vector<std::uint8_t>> encodedFrame(
    const std::vector<DicomBytes>& fragments, int frame, int frames, PixelCoding coding);

} // namespace core
