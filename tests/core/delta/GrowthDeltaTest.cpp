// SPDX-License-Identifier: Apache-2.0
#include "core/delta/BrickDelta.h"
#include "core/engine/EngineCommands.h"
#include "core/growth/SeedWord.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <random>
#include <zstd.h>

namespace growthDeltaTest {

using namespace core;

namespace {

/// Several bricks each way, none of them whole at the far border.
const BrickGrid grid{{70, 55, 40}};

constexpr std::uint32_t none = 0xFFFFFFFFU;

std::vector<std::uint32_t> wordsOf(const std::vector<std::uint8_t>& bytes)
{
    std::vector<std::uint32_t> words(BrickGrid::voxelsPerBrick, bytes.empty() ? none : 0);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        words[i / 4] |= std::uint32_t(bytes[i]) << (8 * (i % 4));
    return words;
}

std::vector<std::uint8_t> bytesOf(const std::vector<std::uint32_t>& words)
{
    std::vector<std::uint8_t> bytes;
    for (const std::uint32_t word : words) {
        for (int shift = 0; shift < 32; shift += 8)
            bytes.push_back(std::uint8_t(word >> shift));
    }
    return bytes;
}

/// A study of noise in which one voxel of eight lets nothing grow.
std::vector<std::uint16_t> noise(unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<std::uint16_t> codes(std::size_t(grid.volumeSize.x) * std::size_t(grid.volumeSize.y)
        * std::size_t(grid.volumeSize.z));
    for (std::uint16_t& code : codes)
        code = random() % 8 == 0 ? 0 : std::uint16_t(100 + random() % 2);
    return codes;
}

EngineResult result(
    EditEngine& engine, EngineEdit edit, std::vector<EngineExtension> extensions = {})
{
    submitWhole(engine, std::move(edit), std::move(extensions));
    return engine.collect().back();
}

/// What bursts of growth changed, each from where the one before it stopped.
std::vector<std::vector<BrickChange>> grow(
    unsigned seed, int labels, const std::vector<int>& bursts)
{
    reference::ReferenceEngine engine;
    if (!engine.openVolume(grid.volumeSize, noise(seed)))
        return {};
    std::mt19937 random(seed);
    for (int label = 1; label <= labels; ++label) {
        SeedPlacement seeds{.label = std::uint8_t(label)};
        for (int i = 0; i < 5; ++i)
            seeds.voxels.push_back({int(random() % 70), int(random() % 55), int(random() % 40)});
        result(engine, seeds);
    }
    std::vector<std::vector<BrickChange>> changes;
    GrowBurst burst{.lowCode = 100, .highCode = 101};
    for (const int steps : bursts) {
        EngineResult grown = result(engine, burst, {GrowAdvance{steps}});
        burst.generation = grown.generation;
        changes.push_back(std::move(grown.changes));
    }
    return changes;
}

std::size_t bytesOfLabels(const std::vector<BrickChange>& changes)
{
    std::vector<BrickChange> labels;
    for (const BrickChange& change : changes) {
        if (change.key.field == Field::Labels)
            labels.push_back(change);
    }
    return makeDelta(labels, grid).bytes();
}

/// Both ways, to the bit.
bool comesBack(const std::vector<BrickChange>& changes)
{
    const Result<std::vector<BrickImage>> images = expandDelta(makeDelta(changes, grid), grid);
    if (!images || images->size() != changes.size())
        return false;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        const BrickChange& change = changes[i];
        const BrickImage& difference = (*images)[i];
        if (difference.key != change.key
            || exclusiveOr({change.key, change.before}, difference).bytes != change.after
            || exclusiveOr({change.key, change.after}, difference).bytes != change.before)
            return false;
    }
    return true;
}

QByteArray expanded(const BrickDelta& delta)
{
    const QByteArray& piece = delta.pieces.front();
    QByteArray stream(1 << 22, '\0');
    ZSTD_DCtx* context = ZSTD_createDCtx();
    stream.resize(qsizetype(ZSTD_decompressDCtx(context, stream.data(), std::size_t(stream.size()),
        piece.constData(), std::size_t(piece.size()))));
    ZSTD_freeDCtx(context);
    return stream;
}

/// Sound for zstd, whatever stands in it.
BrickDelta packed(const QByteArray& stream)
{
    QByteArray piece(qsizetype(ZSTD_compressBound(std::size_t(stream.size()))), '\0');
    piece.resize(qsizetype(ZSTD_compress(piece.data(), std::size_t(piece.size()),
        stream.constData(), std::size_t(stream.size()), 1)));
    return {{piece}};
}

} // namespace

class GrowthDeltaTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void growthTakesLittleMoreThanItsLabels_data()
    {
        QTest::addColumn<int>("labels");
        QTest::addColumn<std::vector<int>>("bursts");
        QTest::addColumn<double>("most"); // times the bytes of the labels alone
        QTest::newRow("one segment to closure") << 1 << std::vector<int>{-1} << 1.1;
        QTest::newRow("three segments to closure") << 3 << std::vector<int>{-1} << 1.1;
        // The first ring of a later burst has its parents in an earlier difference.
        QTest::newRow("one segment in bursts") << 1 << std::vector<int>{8, 9, -1} << 2.0;
        QTest::newRow("three segments in bursts") << 3 << std::vector<int>{7, 6, -1} << 2.0;
    }
    void growthTakesLittleMoreThanItsLabels()
    {
        QFETCH(int, labels);
        QFETCH(std::vector<int>, bursts);
        QFETCH(double, most);
        const auto all = grow(11, labels, bursts);
        QCOMPARE(all.size(), bursts.size());
        for (const std::vector<BrickChange>& changes : all) {
            QVERIFY(changes.size() > 10);
            QVERIFY(comesBack(changes));
            const std::size_t bytes = makeDelta(changes, grid).bytes();
            const std::size_t least = bytesOfLabels(changes);
            QVERIFY2(double(bytes) < most * double(least) + 60,
                qPrintable(QStringLiteral("%1 bytes, labels %2").arg(bytes).arg(least)));
        }
    }

    /// The same bytes without labels beside them, and a mask of their own.
    void wordsAloneComeBack()
    {
        const std::vector<BrickChange> changes = grow(12, 2, {-1}).front();
        std::vector<BrickChange> words;
        for (const BrickChange& change : changes) {
            if (change.key.field == Field::SeedWords)
                words.push_back(change);
        }
        QVERIFY(words.size() > 5);
        QVERIFY(comesBack(words));
    }

    /// Bits that no growth would set so: in whom nothing is predicted, and in those beside them.
    void wordsThatContradictComeBack_data()
    {
        QTest::addColumn<int>("oneOf");
        QTest::newRow("one word of 500") << 500;
        QTest::newRow("one word of 20") << 20;
        QTest::newRow("every other word") << 2;
    }
    void wordsThatContradictComeBack()
    {
        QFETCH(int, oneOf);
        for (unsigned seed = 0; seed < 6; ++seed) {
            std::mt19937 random(seed);
            std::vector<BrickChange> changes = grow(seed, 1 + int(seed % 3), {5, -1}).back();
            for (BrickChange& change : changes) {
                if (change.key.field != Field::SeedWords)
                    continue;
                std::vector<std::uint32_t> before = wordsOf(change.before.read());
                std::vector<std::uint32_t> after = wordsOf(change.after.read());
                for (std::size_t i = 0; i < after.size(); ++i) {
                    if (random() % unsigned(oneOf) != 0)
                        continue;
                    switch (random() % 7) {
                    case 0: // another generation, near or at the ends of its range
                        after[i] = seedWord::member((seedWord::generation(after[i]) + random() % 5)
                                & seedWord::maxGeneration,
                            seedWord::label(after[i]), seedWord::direction(after[i]));
                        break;
                    case 1:
                        after[i] = seedWord::member(random() % 2 ? seedWord::maxGeneration : 0,
                            seedWord::label(after[i]), random() % 32);
                        break;
                    case 2:
                        after[i] ^= 1U << random() % 32;
                        break;
                    case 3:
                        after[i] = seedWord::pendingSeed(random() % 256);
                        break;
                    case 4:
                        before[i] = seedWord::pendingSeed(random() % 4);
                        break;
                    case 5:
                        std::swap(before[i], after[i]);
                        break;
                    default:
                        after[i] = std::uint32_t(random());
                    }
                }
                change.before = bytesOf(before);
                change.after = bytesOf(after);
            }
            const Result<std::vector<BrickImage>> images =
                expandDelta(makeDelta(changes, grid), grid);
            QVERIFY(images);
            for (std::size_t i = 0; i < changes.size(); ++i) {
                const std::vector<std::uint32_t> difference = wordsOf(images->at(i).bytes.read());
                if (changes[i].key.field != Field::SeedWords)
                    continue;
                std::vector<std::uint32_t> expected = wordsOf(changes[i].before.read());
                const std::vector<std::uint32_t> after = wordsOf(changes[i].after.read());
                for (std::size_t voxel = 0; voxel < after.size(); ++voxel)
                    expected[voxel] ^= after[voxel];
                QVERIFY(difference == expected);
            }
        }
    }

    /// Members of few generations and labels, without any growth behind them.
    void anyWordsComeBack()
    {
        for (unsigned seed = 0; seed < 12; ++seed) {
            std::mt19937 random(seed);
            const unsigned generations = 1 + seed % 4;
            const unsigned labels = 1 + seed % 3;
            std::vector<BrickChange> changes;
            for (std::uint32_t brick = 0; brick < std::uint32_t(grid.brickCount()); ++brick) {
                if (random() % 3 == 0)
                    continue;
                std::vector<std::uint32_t> words;
                for (int voxel = 0; voxel < BrickGrid::voxelsPerBrick; ++voxel)
                    words.push_back(random() % 4 == 0 ? none
                                                      : seedWord::member(random() % generations,
                                                          1 + random() % labels, random() % 6));
                changes.push_back({.key = {Field::SeedWords, std::uint8_t(seed % 2), brick},
                    .before = {},
                    .after = bytesOf(words)});
            }
            QVERIFY(comesBack(changes));
        }
    }

    void streamsThatCannotBeAreRefused_data()
    {
        QTest::addColumn<qsizetype>("at");
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("another form") << qsizetype(3) << QByteArray("9");
        QTest::newRow("no bricks along x") << qsizetype(4) << QByteArray(4, '\0');
        QTest::newRow("fewer than none along y") << qsizetype(8) << QByteArray(4, '\xFF');
        QTest::newRow("more bricks than bytes") << qsizetype(12) << QByteArray(4, '\xFF');
        QTest::newRow("a field that is none") << qsizetype(16) << QByteArray("\x04");
        QTest::newRow("a form that is none") << qsizetype(18) << QByteArray("\x03");
        QTest::newRow("labels as labels") << qsizetype(18) << QByteArray("\x02");
        QTest::newRow("a byte that is 0") << qsizetype(19) << QByteArray("\x01");
        QTest::newRow("a brick twice") << qsizetype(28) << QByteArray(1, '\0');
    }
    void streamsThatCannotBeAreRefused()
    {
        QFETCH(qsizetype, at);
        QFETCH(QByteArray, bytes);
        const auto changes = grow(13, 2, {-1}).front();
        QVERIFY((changes[0].key == BrickKey{Field::Labels, 0, 0}));
        QVERIFY((changes[1].key == BrickKey{Field::Labels, 0, 1}));
        QByteArray stream = expanded(makeDelta(changes, grid));
        QVERIFY(expandDelta(packed(stream), grid));
        stream.replace(at, bytes.size(), bytes);
        const Result<std::vector<BrickImage>> images = expandDelta(packed(stream), grid);
        QVERIFY(!images);
        QCOMPARE(images.error().code, ErrorCode::SessionDamaged);
    }

    void streamsOfAnotherLengthAreRefused()
    {
        const QByteArray stream = expanded(makeDelta(grow(13, 2, {-1}).front(), grid));
        QVERIFY(stream.size() > 1000);
        for (qsizetype length = 0; length < stream.size(); length += 1 + length / 9)
            QVERIFY(!expandDelta(packed(stream.left(length)), grid));
        QVERIFY(!expandDelta(packed(stream.left(stream.size() - 1)), grid));
        QVERIFY(!expandDelta(packed(stream + '\0'), grid));
    }

    /// All predicted, and nothing to predict it from.
    void wordsThatFollowFromNothingAreRefused()
    {
        std::vector<std::uint32_t> words(BrickGrid::voxelsPerBrick, none);
        words[0] = seedWord::member(7, 1, seedWord::seedDirection);
        words[1] = seedWord::member(8, 1, 0);
        const BrickChange change{
            .key = {Field::SeedWords, 0, 0}, .before = {}, .after = bytesOf(words)};
        QByteArray stream = expanded(makeDelta({change}, grid));
        QVERIFY(expandDelta(packed(stream), grid));
        const qsizetype kept = 16 + 8 + 512;
        QCOMPARE(stream.at(kept), '\x01');
        stream[kept] = '\0';
        stream.chop(3); // one label more, four bytes of a word less
        QVERIFY(!expandDelta(packed(stream), grid));
        // Beyond the last generation there is none.
        words[0] = seedWord::member(seedWord::maxGeneration, 1, seedWord::seedDirection);
        words[1] = seedWord::member(0, 1, 0);
        QVERIFY(
            comesBack({{.key = {Field::SeedWords, 0, 0}, .before = {}, .after = bytesOf(words)}}));
    }

    void noiseInAStreamDoesNoHarm()
    {
        const QByteArray stream = expanded(makeDelta(grow(14, 2, {-1}).front(), grid));
        std::mt19937 random(5);
        int refused = 0;
        constexpr int times = 200;
        for (int i = 0; i < times; ++i) {
            QByteArray noisy = stream;
            for (int flips = 1 + i % 5; flips > 0; --flips) {
                const auto at = qsizetype(random() % std::uint32_t(noisy.size()));
                noisy[at] = char(random());
            }
            const Result<std::vector<BrickImage>> images = expandDelta(packed(noisy), grid);
            refused += images ? 0 : 1;
            for (std::size_t image = 0; images && image < images->size(); ++image) {
                const BrickImage& whole = (*images)[image];
                QCOMPARE(whole.bytes.size(),
                    std::size_t(bytesPerVoxel(whole.key.field)) * BrickGrid::voxelsPerBrick);
            }
        }
        QVERIFY(refused > times / 2);
    }
};

BURIN_TEST(GrowthDeltaTest)

} // namespace growthDeltaTest

#include "GrowthDeltaTest.moc"
