// SPDX-License-Identifier: Apache-2.0
#include "core/brick/BrickDelta.h"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <new>

namespace core {

namespace {

constexpr std::array<char, 4> magic{'B', 'D', 'L', '1'};
constexpr std::size_t keyBytes = 8;
/// zstd's default: strokes and growths shrink 50 to 500 times, higher levels gain a few percent.
constexpr int compressionLevel = 3;

std::size_t brickBytes(Field field)
{
    return std::size_t(bytesPerVoxel(field)) * BrickGrid::voxelsPerBrick;
}

/// Words a0 a1 a2 a3, b0 b1 … become a0 b0 … a1 b1 …: equal bytes come to lie beside each other.
void shuffle(const std::uint8_t* words, std::uint8_t* planes)
{
    for (int voxel = 0; voxel < BrickGrid::voxelsPerBrick; ++voxel) {
        for (int byte = 0; byte < 4; ++byte)
            planes[byte * BrickGrid::voxelsPerBrick + voxel] = words[voxel * 4 + byte];
    }
}

void unshuffle(const std::uint8_t* planes, std::uint8_t* words)
{
    for (int voxel = 0; voxel < BrickGrid::voxelsPerBrick; ++voxel) {
        for (int byte = 0; byte < 4; ++byte)
            words[voxel * 4 + byte] = planes[byte * BrickGrid::voxelsPerBrick + voxel];
    }
}

void layOver(std::uint8_t* target, const std::vector<std::uint8_t>& image, const BrickKey& key)
{
    const std::size_t size = brickBytes(key.field);
    const std::uint8_t empty = emptyByte(key.field);
    for (std::size_t i = 0; i < size; ++i)
        target[i] ^= image.empty() ? empty : image[i];
}

/// Compressed bytes cut into pieces as they come.
class Compressor {
public:
    Compressor()
        : m_stream(ZSTD_createCStream())
    {
        if (!m_stream)
            throw std::bad_alloc();
        ZSTD_CCtx_setParameter(m_stream.get(), ZSTD_c_compressionLevel, compressionLevel);
        ZSTD_CCtx_setParameter(m_stream.get(), ZSTD_c_checksumFlag, 1);
    }
    void add(const void* data, std::size_t size) { feed({data, size, 0}, ZSTD_e_continue); }
    std::vector<QByteArray> finish()
    {
        feed({nullptr, 0, 0}, ZSTD_e_end);
        m_pieces.back().resize(qsizetype(m_filled));
        m_pieces.back().squeeze();
        return std::move(m_pieces);
    }

private:
    struct Deleter {
        void operator()(ZSTD_CStream* stream) const { ZSTD_freeCStream(stream); }
    };

    void feed(ZSTD_inBuffer input, ZSTD_EndDirective directive)
    {
        while (true) {
            if (m_pieces.empty() || m_filled == BrickDelta::maxPieceBytes) {
                m_pieces.emplace_back(qsizetype(BrickDelta::maxPieceBytes), Qt::Uninitialized);
                m_filled = 0;
            }
            ZSTD_outBuffer output{m_pieces.back().data(), BrickDelta::maxPieceBytes, m_filled};
            const std::size_t left =
                ZSTD_compressStream2(m_stream.get(), &output, &input, directive);
            if (ZSTD_isError(left))
                throw std::bad_alloc();
            m_filled = output.pos;
            if (directive == ZSTD_e_end ? left == 0 : input.pos == input.size)
                return;
        }
    }

    std::unique_ptr<ZSTD_CStream, Deleter> m_stream;
    std::vector<QByteArray> m_pieces;
    std::size_t m_filled = 0;
};

class Expander {
public:
    explicit Expander(const BrickDelta& delta)
        : m_delta(delta)
        , m_stream(ZSTD_createDStream())
    {
    }
    /// @return the number of bytes that there were, up to @p size
    std::size_t take(void* data, std::size_t size)
    {
        ZSTD_outBuffer output{data, size, 0};
        while (output.pos < output.size && !m_complete) {
            if (m_input.pos == m_input.size && m_piece < m_delta.pieces.size()) {
                const QByteArray& piece = m_delta.pieces[m_piece++];
                m_input = {piece.constData(), std::size_t(piece.size()), 0};
            }
            const std::size_t before = output.pos;
            const std::size_t inputBefore = m_input.pos;
            const std::size_t status = ZSTD_decompressStream(m_stream.get(), &output, &m_input);
            if (ZSTD_isError(status)) {
                m_failed = true;
                break;
            }
            m_complete = status == 0;
            const bool stuck = output.pos == before && m_input.pos == inputBefore;
            if (stuck && m_piece == m_delta.pieces.size())
                break;
        }
        return output.pos;
    }
    bool failed() const { return m_failed; }
    bool complete() const { return m_complete; }

private:
    struct Deleter {
        void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
    };

    const BrickDelta& m_delta;
    std::unique_ptr<ZSTD_DStream, Deleter> m_stream;
    ZSTD_inBuffer m_input{nullptr, 0, 0};
    std::size_t m_piece = 0;
    bool m_failed = false;
    bool m_complete = false;
};

tl::unexpected<Error> damaged(const char* reason)
{
    return failure(ErrorCode::SessionDamaged, QString(QLatin1String(reason)));
}

} // namespace

std::size_t BrickDelta::bytes() const
{
    std::size_t sum = 0;
    for (const QByteArray& piece : pieces)
        sum += std::size_t(piece.size());
    return sum;
}

BrickDelta makeDelta(const std::vector<BrickChange>& changes)
{
    if (changes.empty())
        return {};
    Compressor compressor;
    compressor.add(magic.data(), magic.size());
    std::vector<std::uint8_t> difference;
    std::vector<std::uint8_t> shuffled;
    for (const BrickChange& change : changes) {
        const BrickKey& key = change.key;
        const std::array<std::uint8_t, keyBytes> head{std::uint8_t(key.field), key.plane, 0, 0,
            std::uint8_t(key.brick), std::uint8_t(key.brick >> 8), std::uint8_t(key.brick >> 16),
            std::uint8_t(key.brick >> 24)};
        compressor.add(head.data(), head.size());
        difference.assign(brickBytes(key.field), 0);
        layOver(difference.data(), change.before, key);
        layOver(difference.data(), change.after, key);
        if (bytesPerVoxel(key.field) == 4) {
            shuffled.resize(difference.size());
            shuffle(difference.data(), shuffled.data());
            difference.swap(shuffled);
        }
        compressor.add(difference.data(), difference.size());
    }
    return {compressor.finish()};
}

Result<std::vector<BrickImage>> expandDelta(const BrickDelta& delta)
{
    std::vector<BrickImage> images;
    if (delta.empty())
        return images;
    Expander expander(delta);
    std::array<char, magic.size()> head{};
    if (expander.take(head.data(), head.size()) != head.size() || head != magic)
        return damaged("the difference does not begin as it should");
    std::vector<std::uint8_t> shuffled;
    while (true) {
        std::array<std::uint8_t, keyBytes> key{};
        const std::size_t got = expander.take(key.data(), key.size());
        if (got == 0 && expander.complete() && !expander.failed())
            return images;
        const bool known = key[0] >= 1 && key[0] <= 3 && key[2] == 0 && key[3] == 0;
        if (got != key.size() || !known)
            return damaged("the difference is cut short or garbled");
        BrickImage image;
        image.key = {.field = Field(key[0]),
            .plane = key[1],
            .brick = std::uint32_t(key[4]) | std::uint32_t(key[5]) << 8
                | std::uint32_t(key[6]) << 16 | std::uint32_t(key[7]) << 24};
        image.bytes.resize(brickBytes(image.key.field));
        if (expander.take(image.bytes.data(), image.bytes.size()) != image.bytes.size())
            return damaged("the difference is cut short or garbled");
        if (bytesPerVoxel(image.key.field) == 4) {
            shuffled.resize(image.bytes.size());
            unshuffle(image.bytes.data(), shuffled.data());
            image.bytes.swap(shuffled);
        }
        images.push_back(std::move(image));
    }
}

BrickImage exclusiveOr(const BrickImage& image, const BrickImage& difference)
{
    BrickImage result = difference;
    layOver(result.bytes.data(), image.bytes, image.key);
    const std::uint8_t empty = emptyByte(image.key.field);
    const bool allEmpty = std::all_of(result.bytes.begin(), result.bytes.end(),
        [empty](std::uint8_t byte) { return byte == empty; });
    if (allEmpty)
        result.bytes.clear();
    return result;
}

} // namespace core
