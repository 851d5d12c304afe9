// SPDX-License-Identifier: Apache-2.0
#include "core/delta/BrickDelta.h"
#include "tests/support/program/TestProgram.h"

#include <QFile>
#include <QTest>

#include <random>
#include <sys/resource.h>
#include <zstd.h>

namespace brickDeltaTest {

using namespace core;

namespace {

const BrickGrid grid{glm::ivec3(4096)};

std::vector<std::uint8_t> randomBytes(std::mt19937& random, Field field, int palette)
{
    std::vector<std::uint8_t> bytes(std::size_t(bytesPerVoxel(field)) * BrickGrid::voxelsPerBrick);
    for (std::uint8_t& byte : bytes)
        byte = std::uint8_t(random() % unsigned(palette));
    return bytes;
}

/// Changes with every kind of image: full, absent before, absent after.
std::vector<BrickChange> randomChanges(unsigned seed, int count, int palette)
{
    std::mt19937 random(seed);
    std::vector<BrickChange> changes;
    for (Field field : {Field::Coverage, Field::Labels, Field::SeedWords, Field::Overwritten}) {
        for (int i = 0; i < count; ++i) {
            BrickChange change;
            change.key = {.field = field,
                .plane = std::uint8_t(random() % 3),
                .brick = std::uint32_t(random() % 0xFFFFFF)};
            if (i % 3 != 1)
                change.before = randomBytes(random, field, palette);
            if (i % 3 != 2)
                change.after = randomBytes(random, field, palette);
            changes.push_back(std::move(change));
        }
    }
    return changes;
}

/// The first bytes of every difference, as one that is made has them.
QByteArray deltaBegin()
{
    const BrickDelta delta = makeDelta(randomChanges(1, 1, 2), grid);
    QByteArray begin(4, '\0');
    ZSTD_DCtx* context = ZSTD_createDCtx();
    const QByteArray& first = delta.pieces.front();
    ZSTD_inBuffer in{first.constData(), std::size_t(first.size()), 0};
    ZSTD_outBuffer out{begin.data(), std::size_t(begin.size()), 0};
    while (out.pos < out.size && in.pos < in.size
        && ZSTD_isError(ZSTD_decompressStream(context, &out, &in)) == 0) { }
    ZSTD_freeDCtx(context);
    return begin;
}

/// A front of words in one brick and its labels, with holes.
std::vector<BrickChange> frontInNoise()
{
    std::mt19937 random(4);
    std::vector<BrickChange> changes(2);
    changes[0].key = {.field = Field::Labels, .plane = 2, .brick = 77};
    changes[1].key = {.field = Field::SeedWords, .plane = 2, .brick = 77};
    for (std::uint32_t voxel = 0; voxel < BrickGrid::voxelsPerBrick; ++voxel) {
        const bool hole = random() % 50 == 0;
        const std::uint32_t generation =
            9 + voxel % 16 + voxel / 16 % 16 + voxel / 256 + (random() % 90 == 0 ? 2 : 0);
        const std::uint32_t direction = voxel % 16 != 0 ? 0 : voxel / 16 % 16 != 0 ? 2 : 4;
        const std::uint32_t word = hole ? 0xFFFFFFFFU : generation << 13 | 7U << 5 | direction;
        changes[0].after.write().push_back(hole ? 0 : 7);
        for (int shift = 0; shift < 32; shift += 8)
            changes[1].after.write().push_back(std::uint8_t(word >> shift));
    }
    return changes;
}

} // namespace

class BrickDeltaTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void leadsThereAndBack()
    {
        const std::vector<BrickChange> changes = randomChanges(1, 20, 7);
        const Result<std::vector<BrickImage>> images = expandDelta(makeDelta(changes, grid), grid);
        QVERIFY(images);
        QCOMPARE(images->size(), changes.size());
        for (std::size_t i = 0; i < changes.size(); ++i) {
            const BrickChange& change = changes[i];
            const BrickImage& difference = (*images)[i];
            QVERIFY(difference.key == change.key);
            QVERIFY(exclusiveOr({change.key, change.before}, difference).bytes == change.after);
            QVERIFY(exclusiveOr({change.key, change.after}, difference).bytes == change.before);
        }
    }

    void nothingChangedNeedsNoBytes()
    {
        QVERIFY(makeDelta({}, grid).empty());
        QVERIFY(expandDelta({}, grid)->empty());
    }

    void piecesStaySmall()
    {
        // Random bytes do not compress: about 12 MB in pieces.
        const std::vector<BrickChange> changes = randomChanges(2, 500, 256);
        const BrickDelta delta = makeDelta(changes, grid);
        QVERIFY(delta.pieces.size() > 1);
        for (const QByteArray& piece : delta.pieces)
            QVERIFY(std::size_t(piece.size()) <= BrickDelta::maxPieceBytes);
        const Result<std::vector<BrickImage>> images = expandDelta(delta, grid);
        QVERIFY(images);
        QCOMPARE(images->size(), changes.size());
        const BrickChange& last = changes.back();
        QVERIFY(exclusiveOr({last.key, last.before}, images->back()).bytes == last.after);
    }

    void growthCompressesWell()
    {
        // A front of words whose generation differs by one from brick row to brick row.
        BrickChange change;
        change.key = {.field = Field::SeedWords, .plane = 0, .brick = 5};
        for (std::uint32_t voxel = 0; voxel < BrickGrid::voxelsPerBrick; ++voxel) {
            const std::uint32_t word = (40 + voxel / 256) << 13 | 1u << 5 | voxel % 6;
            for (int shift = 0; shift < 32; shift += 8)
                change.after.write().push_back(std::uint8_t(word >> shift));
        }
        QVERIFY(makeDelta({change}, grid).bytes() < change.after.size() / 20);
    }

    /// A front through noise that no engine grew: labels and seed words change in the same voxels,
    /// with holes.
    void wordsInNoiseComeBack()
    {
        const std::vector<BrickChange> changes = frontInNoise();
        const BrickDelta together = makeDelta(changes, grid);
        QVERIFY(together.bytes() < 1200);
        QVERIFY(together.bytes() + 100
            < makeDelta({changes[0]}, grid).bytes() + makeDelta({changes[1]}, grid).bytes());
        const Result<std::vector<BrickImage>> images = expandDelta(together, grid);
        QVERIFY(images);
        for (std::size_t i = 0; i < changes.size(); ++i)
            QVERIFY(exclusiveOr({changes[i].key, {}}, images->at(i)).bytes == changes[i].after);
    }

    void damageIsNoticed_data()
    {
        QTest::addColumn<int>("damage");
        QTest::newRow("a flipped byte") << 0;
        QTest::newRow("cut short") << 1;
        QTest::newRow("not a delta") << 2;
        QTest::newRow("a piece is missing") << 3;
    }
    void damageIsNoticed()
    {
        QFETCH(int, damage);
        BrickDelta delta = makeDelta(randomChanges(3, 500, 256), grid);
        QByteArray& first = delta.pieces.front();
        if (damage == 0)
            first[first.size() / 2] = char(first[first.size() / 2] ^ 1);
        else if (damage == 1)
            delta.pieces.back().chop(10);
        else if (damage == 2)
            first = QByteArray("no zstd at all");
        else
            delta.pieces.pop_back();
        const Result<std::vector<BrickImage>> images = expandDelta(delta, grid);
        QVERIFY(!images);
        QCOMPARE(images.error().code, ErrorCode::SessionDamaged);
    }

    /// A difference that promises far more bricks than the volume has is refused before any memory
    /// is taken for them, however small it is itself.
    void bricksThatTheVolumeLacksAreRefused()
    {
        const BrickGrid small{glm::ivec3(64)};
        struct Promise {
            std::uint32_t entries;
            std::uint32_t bricks; ///< that they name in turn
        };
        // More than there can be, bricks outside the volume, and one brick again and again.
        for (const Promise promise :
            {Promise{1U << 20, 1U << 20}, Promise{60'000, 60'000}, Promise{60'000, 1}}) {
            QByteArray plain;
            const auto append = [&plain](std::uint32_t number) {
                for (int byte = 0; byte < 4; ++byte)
                    plain += char(number >> (8 * byte) & 0xFFU);
            };
            plain += deltaBegin();
            append(std::uint32_t(small.bricks().x));
            append(std::uint32_t(small.bricks().y));
            append(promise.entries);
            for (std::uint32_t number = 0; number < promise.entries; ++number) {
                plain += QByteArrayLiteral("\x02\x00\x01\x00"); // labels of plane 0, with a mask
                append(number % promise.bricks);
            }
            QByteArray packed(qsizetype(ZSTD_compressBound(std::size_t(plain.size()))), '\0');
            const std::size_t bytes = ZSTD_compress(packed.data(), std::size_t(packed.size()),
                plain.constData(), std::size_t(plain.size()), 1);
            QVERIFY(ZSTD_isError(bytes) == 0);
            packed.truncate(qsizetype(bytes));
            BrickDelta delta;
            delta.pieces.push_back(packed);

            rusage before{};
            getrusage(RUSAGE_SELF, &before);
            const Result<std::vector<BrickImage>> images = expandDelta(delta, small);
            rusage after{};
            getrusage(RUSAGE_SELF, &after);
            QVERIFY(!images);
            QCOMPARE(images.error().code, ErrorCode::SessionDamaged);
            QVERIFY2(after.ru_maxrss - before.ru_maxrss < 100'000, // KiB; masks alone: 512 MiB
                qPrintable(QString::number(after.ru_maxrss - before.ru_maxrss)));
        }
    }
};

BURIN_TEST(BrickDeltaTest)

} // namespace brickDeltaTest

#include "BrickDeltaTest.moc"
