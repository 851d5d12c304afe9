// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/codecs/Jpeg2000.h"

#include <openjpeg.h>

#include <algorithm>
#include <cstring>
#include <memory>

namespace core {

namespace {

struct Source {
    std::span<const std::uint8_t> bytes;
    std::size_t at = 0;
};

constexpr auto endOfSource = OPJ_SIZE_T(-1);

OPJ_SIZE_T readSome(void* buffer, OPJ_SIZE_T count, void* user)
{
    auto& source = *static_cast<Source*>(user);
    const std::size_t some = std::min<std::size_t>(count, source.bytes.size() - source.at);
    if (some == 0)
        return endOfSource;
    std::memcpy(buffer, source.bytes.data() + source.at, some);
    source.at += some;
    return some;
}

OPJ_OFF_T skipSome(OPJ_OFF_T count, void* user)
{
    auto& source = *static_cast<Source*>(user);
    if (count < 0)
        return -1;
    const std::size_t some =
        std::min<std::size_t>(std::size_t(count), source.bytes.size() - source.at);
    source.at += some;
    return some > 0 || count == 0 ? OPJ_OFF_T(some) : -1;
}

OPJ_BOOL seekTo(OPJ_OFF_T position, void* user)
{
    auto& source = *static_cast<Source*>(user);
    if (position < 0 || std::size_t(position) > source.bytes.size())
        return OPJ_FALSE;
    source.at = std::size_t(position);
    return OPJ_TRUE;
}

// OpenJPEG's stream and codec are the same type, so that one deleter would not do.
struct FreeStream {
    void operator()(opj_stream_t* stream) const { opj_stream_destroy(stream); }
};
struct FreeCodec {
    void operator()(opj_codec_t* codec) const { opj_destroy_codec(codec); }
};
struct FreeImage {
    void operator()(opj_image_t* image) const { opj_image_destroy(image); }
};

bool isJp2File(std::span<const std::uint8_t> bytes)
{
    constexpr std::uint8_t signature[12] = {0, 0, 0, 12, 'j', 'P', ' ', ' ', 13, 10, 0x87, 10};
    return bytes.size() > sizeof(signature)
        && std::equal(std::begin(signature), std::end(signature), bytes.begin());
}

void copyComponent(
    const opj_image_comp_t& component, const PixelLayout& layout, std::span<std::uint8_t> cells)
{
    const std::size_t bytes = std::size_t(layout.bitsAllocated) / 8;
    // Files that say "signed" in their header only: the codestream's top bit is the sign.
    const bool addSign = layout.isSigned && component.sgnd == 0 && component.prec < 32;
    const OPJ_INT32 sign = addSign ? OPJ_INT32(1u << (component.prec - 1)) : 0;
    const std::size_t pixels = cells.size() / bytes;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        const OPJ_INT32 value =
            addSign ? (component.data[pixel] ^ sign) - sign : component.data[pixel];
        for (std::size_t byte = 0; byte < bytes; ++byte)
            cells[pixel * bytes + byte] = std::uint8_t(std::uint32_t(value) >> (8 * byte));
    }
}

} // namespace

QString decodeJpeg2000(std::span<const std::uint8_t> codestream, const PixelLayout& layout,
    std::span<std::uint8_t> cells)
{
    Source source{.bytes = codestream};
    const std::unique_ptr<opj_stream_t, FreeStream> stream(
        opj_stream_create(std::max<std::size_t>(1 << 12, codestream.size()), OPJ_TRUE));
    const std::unique_ptr<opj_codec_t, FreeCodec> codec(
        opj_create_decompress(isJp2File(codestream) ? OPJ_CODEC_JP2 : OPJ_CODEC_J2K));
    if (!stream || !codec)
        return QStringLiteral("no memory for the JPEG 2000 decoder");
    opj_stream_set_user_data(stream.get(), &source, nullptr);
    opj_stream_set_user_data_length(stream.get(), codestream.size());
    opj_stream_set_read_function(stream.get(), readSome);
    opj_stream_set_skip_function(stream.get(), skipSome);
    opj_stream_set_seek_function(stream.get(), seekTo);
    opj_dparameters_t parameters;
    opj_set_default_decoder_parameters(&parameters);
    if (!opj_setup_decoder(codec.get(), &parameters)
        || !opj_decoder_set_strict_mode(codec.get(), OPJ_TRUE)) {
        return QStringLiteral("the JPEG 2000 decoder does not start");
    }
    opj_image_t* raw = nullptr;
    const bool hasHeader = opj_read_header(stream.get(), codec.get(), &raw);
    const std::unique_ptr<opj_image_t, FreeImage> image(raw);
    if (!hasHeader || !image)
        return QStringLiteral("damaged JPEG 2000 header");
    if (image->numcomps != 1 || image->x1 - image->x0 != OPJ_UINT32(layout.columns)
        || image->y1 - image->y0 != OPJ_UINT32(layout.rows)) {
        return QStringLiteral("its JPEG 2000 image is %1 × %2 with %3 components")
            .arg(image->x1 - image->x0)
            .arg(image->y1 - image->y0)
            .arg(image->numcomps);
    }
    if (!opj_decode(codec.get(), stream.get(), image.get())
        || !opj_end_decompress(codec.get(), stream.get())) {
        return QStringLiteral("damaged JPEG 2000 data");
    }
    const opj_image_comp_t& component = image->comps[0];
    if (component.w != OPJ_UINT32(layout.columns) || component.h != OPJ_UINT32(layout.rows)
        || !component.data) {
        return QStringLiteral("its JPEG 2000 image is subsampled");
    }
    copyComponent(component, layout, cells);
    return {};
}

} // namespace core
