// SPDX-License-Identifier: Apache-2.0
#include "core/delta/BrickDelta.h"

#include "core/delta/DeltaStream.h"
#include "core/delta/SeedWordPrediction.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <set>

namespace core {

namespace {

constexpr std::array<char, 4> magic{'B', 'D', 'L', '3'};
constexpr std::size_t headBytes = 8;
constexpr std::size_t wordBytes = 4;

/// Where it stands which voxels of a brick differ.
enum class Form : std::uint8_t {
    Masked = 1, ///< in a mask of its own
    MaskedAsLabels = 2, ///< they are those of the labels brick of this number and plane
};

/// One brick of a difference.
struct Entry {
    BrickKey key;
    Form form = Form::Masked;
    BrickBits mask; ///< voxels that differ
    std::size_t labels = 0; ///< MaskedAsLabels: where the labels' bytes begin among all bytes
    std::vector<std::uint8_t> bytes; ///< the XOR; none for seed words
};

/// All of it, in memory, as the stream has it.
struct Difference {
    glm::ivec2 along{1}; ///< bricks of the volume along x and y
    std::vector<Entry> entries;
    std::vector<SeedWordBrick> words; ///< of the entries of seed words
    std::vector<std::uint8_t> bytes; ///< that differ, of the other fields
};

std::size_t brickBytes(Field field)
{
    return std::size_t(bytesPerVoxel(field)) * BrickGrid::voxelsPerBrick;
}

void layOver(std::uint8_t* target, const BrickBytes& image, Field field)
{
    const std::size_t size = brickBytes(field);
    if (image.empty()) {
        for (std::size_t i = 0; i < size; ++i)
            target[i] ^= emptyByte(field);
    } else {
        const std::vector<std::uint8_t>& bytes = image.read();
        for (std::size_t i = 0; i < size; ++i)
            target[i] ^= bytes[i];
    }
}

void append(std::vector<std::uint8_t>& bytes, std::uint32_t word)
{
    for (int shift = 0; shift < 32; shift += 8)
        bytes.push_back(std::uint8_t(word >> shift));
}

std::uint32_t wordAt(const std::uint8_t* bytes)
{
    return std::uint32_t(bytes[0]) | std::uint32_t(bytes[1]) << 8 | std::uint32_t(bytes[2]) << 16
        | std::uint32_t(bytes[3]) << 24;
}

/// Which of the voxels that differ belong to a further mask, one bit each.
std::vector<std::uint8_t> packed(const BrickBits& differing, const BrickBits& further)
{
    std::vector<std::uint8_t> bits((differing.count() + 7) / 8, 0);
    std::size_t number = 0;
    differing.forEach([&](std::size_t voxel) {
        if (further.has(voxel))
            bits[number / 8] = std::uint8_t(bits[number / 8] | 1U << (number % 8));
        ++number;
    });
    return bits;
}

BrickBits unpacked(const BrickBits& differing, const std::vector<std::uint8_t>& bits)
{
    BrickBits further;
    std::size_t number = 0;
    differing.forEach([&](std::size_t voxel) {
        if ((bits[number / 8] >> (number % 8) & 1U) != 0)
            further.add(voxel);
        ++number;
    });
    return further;
}

/// XOR of the changes, each brick with what differs.
Difference differenceOf(const std::vector<BrickChange>& changes, const BrickGrid& grid)
{
    Difference all{.along = glm::ivec2(grid.bricks()), .entries = {}, .words = {}, .bytes = {}};
    struct Labels {
        BrickBits mask;
        std::size_t first;
    };
    std::map<BrickKey, Labels> labels;
    std::vector<std::uint8_t> image;
    for (const BrickChange& change : changes) {
        const Field field = change.key.field;
        image.assign(brickBytes(field), 0);
        layOver(image.data(), change.before, field);
        layOver(image.data(), change.after, field);
        Entry entry;
        entry.key = change.key;
        if (field == Field::SeedWords) {
            SeedWordBrick& brick = all.words.emplace_back();
            brick.key = change.key;
            for (std::size_t voxel = 0; voxel < brick.differences.size(); ++voxel) {
                brick.differences[voxel] = wordAt(&image[wordBytes * voxel]);
                if (brick.differences[voxel] != 0)
                    entry.mask.add(voxel);
            }
            const auto same = labels.find({Field::Labels, change.key.plane, change.key.brick});
            if (same != labels.end() && same->second.mask == entry.mask) {
                entry.form = Form::MaskedAsLabels;
                entry.labels = same->second.first;
            }
        } else {
            const std::size_t first = all.bytes.size();
            for (std::size_t voxel = 0; voxel < image.size(); ++voxel) {
                if (image[voxel] == 0)
                    continue;
                entry.mask.add(voxel);
                all.bytes.push_back(image[voxel]);
            }
            if (field == Field::Labels)
                labels.emplace(change.key, Labels{entry.mask, first});
        }
        all.entries.push_back(std::move(entry));
    }
    return all;
}

/// Seed words: which are kept, labels of those that are predicted, the kept ones by significance.
void writeWords(DeltaWriter& writer, const Difference& all)
{
    std::vector<std::uint8_t> labels;
    std::array<std::vector<std::uint8_t>, wordBytes> kept;
    auto brick = all.words.begin();
    for (const Entry& entry : all.entries) {
        if (entry.key.field != Field::SeedWords)
            continue;
        BrickBits keeps;
        std::size_t number = entry.labels;
        entry.mask.forEach([&](std::size_t voxel) {
            const std::uint32_t difference = brick->differences[voxel];
            const std::uint8_t beside =
                entry.form == Form::MaskedAsLabels ? all.bytes[number] : std::uint8_t(0);
            ++number;
            if (brick->predicted.has(voxel)) {
                labels.push_back(labelOfDifference(difference) ^ beside);
                return;
            }
            keeps.add(voxel);
            for (std::size_t byte = 0; byte < wordBytes; ++byte)
                kept[byte].push_back(std::uint8_t(difference >> (8 * byte)));
        });
        writer.add(packed(entry.mask, keeps));
        ++brick;
    }
    writer.add(labels);
    for (const std::vector<std::uint8_t>& plane : kept)
        writer.add(plane);
}

bool readWords(DeltaReader& reader, Difference& all)
{
    std::size_t predicted = 0;
    std::size_t kept = 0;
    for (const Entry& entry : all.entries) {
        if (entry.key.field != Field::SeedWords)
            continue;
        const std::size_t count = entry.mask.count();
        std::vector<std::uint8_t> bits((count + 7) / 8);
        if (!reader.fill(bits))
            return false;
        for (std::uint8_t& byte : bits)
            byte = std::uint8_t(~byte);
        SeedWordBrick& brick = all.words.emplace_back();
        brick.key = entry.key;
        brick.predicted = unpacked(entry.mask, bits);
        predicted += brick.predicted.count();
        kept += count - brick.predicted.count();
    }
    std::vector<std::uint8_t> labels(predicted);
    std::array<std::vector<std::uint8_t>, wordBytes> planes;
    if (!reader.fill(labels))
        return false;
    for (std::vector<std::uint8_t>& plane : planes) {
        plane.resize(kept);
        if (!reader.fill(plane))
            return false;
    }
    auto brick = all.words.begin();
    auto label = labels.begin();
    std::size_t word = 0;
    for (const Entry& entry : all.entries) {
        if (entry.key.field != Field::SeedWords)
            continue;
        std::size_t number = entry.labels;
        entry.mask.forEach([&](std::size_t voxel) {
            std::uint32_t& difference = brick->differences[voxel];
            const std::uint8_t beside =
                entry.form == Form::MaskedAsLabels ? all.bytes[number] : std::uint8_t(0);
            ++number;
            if (brick->predicted.has(voxel)) {
                difference = predictedDifference(*label++ ^ beside);
                return;
            }
            for (std::size_t byte = 0; byte < wordBytes; ++byte)
                difference |= std::uint32_t(planes[byte][word]) << (8 * byte);
            ++word;
        });
        ++brick;
    }
    return completePredicted(all.words, all.along);
}

/// Everything up to the masks.
bool readEntries(DeltaReader& reader, const BrickGrid& grid, Difference& all)
{
    std::array<std::uint8_t, 3 * wordBytes> sizes{};
    if (!reader.fill(sizes))
        return false;
    all.along = {int(wordAt(&sizes[0])), int(wordAt(&sizes[wordBytes]))};
    if (all.along != glm::ivec2(grid.bricks()))
        return false;
    // More than there can be is not even looked for: a stream of a megabyte may promise millions.
    constexpr std::uint64_t fieldsAndPlanes = 4 * 256;
    const std::uint32_t count = wordAt(&sizes[2 * wordBytes]);
    if (count > fieldsAndPlanes * std::uint64_t(grid.brickCount()))
        return false;
    std::set<BrickKey> keys;
    for (std::uint32_t left = count; left > 0; --left) {
        std::array<std::uint8_t, headBytes> head{};
        if (!reader.fill(head) || head[0] < 1 || head[0] > 4 || head[2] < 1 || head[2] > 2
            || head[3] != 0)
            return false;
        Entry entry;
        entry.key = {.field = Field(head[0]), .plane = head[1], .brick = wordAt(&head[4])};
        entry.form = Form(head[2]);
        if (entry.key.brick >= std::uint32_t(grid.brickCount()) || !keys.insert(entry.key).second)
            return false;
        all.entries.push_back(std::move(entry));
    }
    for (Entry& entry : all.entries) {
        if (entry.form == Form::Masked && !reader.fill(entry.mask.bits))
            return false;
    }
    return true;
}

/// Bytes of the fields of bytes; seed words learn what they have in common with labels.
bool readBytes(DeltaReader& reader, Difference& all)
{
    struct Labels {
        const Entry* entry;
        std::size_t first;
    };
    std::map<BrickKey, Labels> labels;
    for (Entry& entry : all.entries) {
        if (entry.form == Form::MaskedAsLabels) {
            const auto same = labels.find({Field::Labels, entry.key.plane, entry.key.brick});
            if (entry.key.field != Field::SeedWords || same == labels.end())
                return false;
            entry.mask = same->second.entry->mask;
            entry.labels = same->second.first;
        } else if (entry.key.field != Field::SeedWords) {
            std::vector<std::uint8_t> values(entry.mask.count());
            if (!reader.fill(values))
                return false;
            entry.bytes.resize(BrickGrid::voxelsPerBrick);
            auto value = values.begin();
            entry.mask.forEach([&](std::size_t voxel) { entry.bytes[voxel] = *value++; });
            if (entry.key.field == Field::Labels)
                labels.emplace(entry.key, Labels{&entry, all.bytes.size()});
            all.bytes.insert(all.bytes.end(), values.begin(), values.end());
        }
    }
    return true;
}

std::vector<BrickImage> imagesOf(Difference&& all)
{
    std::vector<BrickImage> images;
    images.reserve(all.entries.size());
    auto brick = all.words.begin();
    for (Entry& entry : all.entries) {
        if (entry.key.field == Field::SeedWords) {
            entry.bytes.resize(wordBytes * brick->differences.size());
            for (std::size_t i = 0; i < entry.bytes.size(); ++i)
                entry.bytes[i] =
                    std::uint8_t(brick->differences[i / wordBytes] >> (8 * (i % wordBytes)));
            ++brick;
        }
        images.push_back({entry.key, std::move(entry.bytes)});
    }
    return images;
}

tl::unexpected<Error> damaged(const Clause& reason)
{
    return failure(ErrorCode::SessionDamaged, reason);
}

} // namespace

std::size_t BrickDelta::bytes() const
{
    std::size_t sum = 0;
    for (const QByteArray& piece : pieces)
        sum += std::size_t(piece.size());
    return sum;
}

BrickDelta makeDelta(const std::vector<BrickChange>& changes, const BrickGrid& grid)
{
    if (changes.empty())
        return {};
    Difference all = differenceOf(changes, grid);
    markPredicted(all.words, all.along);
    DeltaWriter writer;
    writer.add(magic);
    std::vector<std::uint8_t> heads;
    append(heads, std::uint32_t(all.along.x));
    append(heads, std::uint32_t(all.along.y));
    append(heads, std::uint32_t(all.entries.size()));
    for (const Entry& entry : all.entries) {
        for (const std::uint8_t byte : {std::uint8_t(entry.key.field), entry.key.plane,
                 std::uint8_t(entry.form), std::uint8_t(0)})
            heads.push_back(byte);
        append(heads, entry.key.brick);
    }
    writer.add(heads);
    for (const Entry& entry : all.entries) {
        if (entry.form == Form::Masked)
            writer.add(entry.mask.bits);
    }
    writer.add(all.bytes);
    writeWords(writer, all);
    return {writer.finish()};
}

Result<std::vector<BrickImage>> expandDelta(const BrickDelta& delta, const BrickGrid& grid)
{
    if (delta.empty())
        return std::vector<BrickImage>();
    DeltaReader reader(delta);
    std::array<char, magic.size()> begin{};
    if (!reader.fill(begin))
        return damaged(Clause::saying("the difference does not begin as it should"));
    if (begin == surfaceStepMagic)
        return std::vector<BrickImage>();
    if (begin != magic)
        return damaged(Clause::saying("the difference does not begin as it should"));
    Difference all;
    if (!readEntries(reader, grid, all) || !readBytes(reader, all) || !readWords(reader, all)
        || !reader.complete())
        return damaged(Clause::saying("the difference is cut short or garbled"));
    return imagesOf(std::move(all));
}

BrickImage exclusiveOr(const BrickImage& image, const BrickImage& difference)
{
    std::vector<std::uint8_t> bytes = difference.bytes.read();
    layOver(bytes.data(), image.bytes, image.key.field);
    const std::uint8_t empty = emptyByte(image.key.field);
    const bool allEmpty = std::all_of(
        bytes.begin(), bytes.end(), [empty](std::uint8_t byte) { return byte == empty; });
    if (allEmpty)
        bytes.clear();
    return {.key = difference.key, .bytes = std::move(bytes)};
}

} // namespace core
