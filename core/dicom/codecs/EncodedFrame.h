// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/DicomElement.h"
#include "core/dicom/base/TransferSyntax.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// The bytes of one frame from encapsulated pixel data. Fragments are not frames (PS3.5 A.4): a
/// frame may consist of several. If there are as many fragments as frames, each is one frame;
/// otherwise JPEG frames begin where a codestream begins. Offset tables are not used, since many
/// files have none.
///
/// @param frame of @p frames, 0-based
/// @return none if the fragments cannot be assigned to frames
[[nodiscard]] std::optional<std::vector<std::uint8_t>> encodedFrame(
    const std::vector<DicomBytes>& fragments, int frame, int frames, PixelCoding coding);

} // namespace core
