// SPDX-License-Identifier: Apache-2.0
#include "core/study/Decoders.h"

#include "core/dicom/codecs/FrameCodec.h"
#include "core/images/ImageCodec.h"
#include "core/images/TiffDecoder.h"

namespace core {

void readyDecoders()
{
    readyCodecs();
    readyTiff();
}

QString decodeForAll(std::span<const std::uint8_t> parameters, std::span<const std::uint8_t> bytes,
    std::span<std::uint8_t> output)
{
    return isImageRequest(parameters) ? decodeImageHere(parameters, bytes, output)
                                      : decodeHere(parameters, bytes, output);
}

} // namespace core
