// SPDX-License-Identifier: Apache-2.0
#include "core/brick/BrickDelta.h"

#include "core/brick/SeedWordForecast.h"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cstring>
#include <map>
#include <memory>
#include <new>

namespace core {

namespace {

constexpr std::array<char, 4> magic{'B', 'D', 'L', '2'};
constexpr std::array<char, 4> firstMagic{'B', 'D', 'L', '1'}; ///< whole bricks only
constexpr std::size_t keyBytes = 8;
/// Growths shrink a fifth further than at zstd's default; a stroke costs a millisecond either way.
constexpr int compressionLevel = 9;

/// How a brick's difference stands in the stream.
enum class Form : std::uint8_t {
    Whole = 0, ///< every voxel
    Masked = 1, ///< which voxels differ, then these
    MaskedAsLabels = 2, ///< the same voxels as in the labels brick of this number and plane
};

using Mask = std::array<std::uint8_t, BrickGrid::voxelsPerBrick / 8>;

bool isSet(const Mask& mask, std::size_t voxel)
{
    return (mask[voxel / 8] >> (voxel % 8) & 1U) != 0;
}

Mask maskOf(const std::vector<std::uint8_t>& difference, std::size_t bytesPerVoxel)
{
    Mask mask{};
    for (std::size_t i = 0; i < difference.size(); ++i) {
        const std::size_t voxel = i / bytesPerVoxel;
        if (difference[i] != 0)
            mask[voxel / 8] = std::uint8_t(mask[voxel / 8] | 1U << (voxel % 8));
    }
    return mask;
}

std::size_t brickBytes(Field field)
{
    return std::size_t(bytesPerVoxel(field)) * BrickGrid::voxelsPerBrick;
}

/// a0 b0 … a1 b1 … become the words a0 a1 a2 a3, b0 b1 …
void unshuffle(const std::uint8_t* planes, std::uint8_t* words)
{
    for (int voxel = 0; voxel < BrickGrid::voxelsPerBrick; ++voxel) {
        for (int byte = 0; byte < 4; ++byte)
            words[voxel * 4 + byte] = planes[byte * BrickGrid::voxelsPerBrick + voxel];
    }
}

/// The seed words of a brick with generations as distances from their forecast, and back.
void forecast(std::vector<std::uint8_t>& bytes, WordDifferences (*change)(const WordDifferences&))
{
    WordDifferences words{};
    for (std::size_t i = 0; i < bytes.size(); ++i)
        words[i / 4] |= std::uint32_t(bytes[i]) << (8 * (i % 4));
    words = change(words);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = std::uint8_t(words[i / 4] >> (8 * (i % 4)));
}

/// Bytes of the voxels that differ, by significance: equal ones come to lie beside each other.
std::vector<std::uint8_t> gathered(
    const std::vector<std::uint8_t>& difference, const Mask& mask, std::size_t bytesPerVoxel)
{
    std::vector<std::uint8_t> values;
    for (std::size_t byte = 0; byte < bytesPerVoxel; ++byte) {
        for (std::size_t voxel = 0; voxel < BrickGrid::voxelsPerBrick; ++voxel) {
            if (isSet(mask, voxel))
                values.push_back(difference[voxel * bytesPerVoxel + byte]);
        }
    }
    return values;
}

void scatter(const std::vector<std::uint8_t>& values, const Mask& mask, std::size_t bytesPerVoxel,
    std::vector<std::uint8_t>& difference)
{
    auto value = values.begin();
    for (std::size_t byte = 0; byte < bytesPerVoxel; ++byte) {
        for (std::size_t voxel = 0; voxel < BrickGrid::voxelsPerBrick; ++voxel) {
            if (isSet(mask, voxel))
                difference[voxel * bytesPerVoxel + byte] = *value++;
        }
    }
}

std::size_t countOf(const Mask& mask)
{
    std::size_t count = 0;
    for (const std::uint8_t bits : mask)
        count += std::bitset<8>(bits).count();
    return count;
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
    std::map<BrickKey, Mask> labels;
    std::vector<std::uint8_t> difference;
    for (const BrickChange& change : changes) {
        const BrickKey& key = change.key;
        const auto wide = std::size_t(bytesPerVoxel(key.field));
        difference.assign(brickBytes(key.field), 0);
        layOver(difference.data(), change.before, key);
        layOver(difference.data(), change.after, key);
        const Mask mask = maskOf(difference, wide);
        Form form = Form::Masked;
        if (key.field == Field::Labels)
            labels.emplace(key, mask);
        if (key.field == Field::SeedWords) {
            const auto same = labels.find({Field::Labels, key.plane, key.brick});
            if (same != labels.end() && same->second == mask)
                form = Form::MaskedAsLabels;
            forecast(difference, withForecast);
        }
        const std::array<std::uint8_t, keyBytes> head{std::uint8_t(key.field), key.plane,
            std::uint8_t(form), 0, std::uint8_t(key.brick), std::uint8_t(key.brick >> 8),
            std::uint8_t(key.brick >> 16), std::uint8_t(key.brick >> 24)};
        compressor.add(head.data(), head.size());
        if (form == Form::Masked)
            compressor.add(mask.data(), mask.size());
        const std::vector<std::uint8_t> values = gathered(difference, mask, wide);
        compressor.add(values.data(), values.size());
    }
    return {compressor.finish()};
}

Result<std::vector<BrickImage>> expandDelta(const BrickDelta& delta)
{
    std::vector<BrickImage> images;
    if (delta.empty())
        return images;
    Expander expander(delta);
    const auto fill = [&expander](auto& bytes) {
        return expander.take(bytes.data(), bytes.size()) == bytes.size();
    };
    std::array<char, magic.size()> begin{};
    if (!fill(begin) || (begin != magic && begin != firstMagic))
        return damaged("the difference does not begin as it should");
    std::map<BrickKey, Mask> labels;
    while (true) {
        std::array<std::uint8_t, keyBytes> head{};
        const std::size_t got = expander.take(head.data(), head.size());
        if (got == 0 && expander.complete() && !expander.failed())
            return images;
        const bool known = head[0] >= 1 && head[0] <= 3 && head[2] <= 2 && head[3] == 0;
        if (got != head.size() || !known)
            return damaged("the difference is cut short or garbled");
        BrickImage image;
        image.key = {.field = Field(head[0]),
            .plane = head[1],
            .brick = std::uint32_t(head[4]) | std::uint32_t(head[5]) << 8
                | std::uint32_t(head[6]) << 16 | std::uint32_t(head[7]) << 24};
        const auto wide = std::size_t(bytesPerVoxel(image.key.field));
        image.bytes.resize(brickBytes(image.key.field));
        bool sound = true;
        if (Form(head[2]) == Form::Whole) {
            std::vector<std::uint8_t> bytes(image.bytes.size());
            sound = fill(bytes);
            if (wide == 4)
                unshuffle(bytes.data(), image.bytes.data());
            else
                image.bytes.swap(bytes);
        } else {
            Mask mask{};
            const auto same = labels.find({Field::Labels, image.key.plane, image.key.brick});
            if (Form(head[2]) == Form::Masked)
                sound = fill(mask);
            else if (same != labels.end())
                mask = same->second;
            else
                sound = false;
            std::vector<std::uint8_t> values(countOf(mask) * wide);
            sound = sound && fill(values);
            scatter(values, mask, wide, image.bytes);
            if (image.key.field == Field::SeedWords)
                forecast(image.bytes, withoutForecast);
            if (image.key.field == Field::Labels)
                labels.emplace(image.key, mask);
        }
        if (!sound)
            return damaged("the difference is cut short or garbled");
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
