// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRuns.h"
#include "core/chunks/ChunkMap.h"
#include "core/chunks/ProbabilityMap.h"
#include "core/edits/EditJson.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/session/EditSession.h"
#include "core/session/SessionChunks.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/sessionfile/HistoryListing.h"
#include "core/sessionfile/SessionFile.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/reference/RefusingEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/TestVolumes.h"
#include "tests/support/series/SessionFiles.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

namespace chunksTest {

using namespace core;

namespace {

constexpr glm::ivec3 size(46, 34, 30); // no multiple of a brick along any axis
using Mode = ChunkToggle::Mode;

/// Two lobes side by side and an organ below them, in something darker; with noise.
struct Lobes {
    LoadedVolume volume;
    std::vector<std::uint8_t> truth; ///< 1 and 2: the lobes, 3: the organ

    Lobes()
    {
        test::Random random(3);
        volume.volume.geometry.size = size;
        volume.volume.maximum = 65535.0;
        volume.volume.voxelsSha256 = "not looked at here";
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    const glm::dvec3 at(x, y, z);
                    const auto within = [&at](const glm::dvec3& middle, double radius) {
                        return glm::dot(at - middle, at - middle) <= radius * radius;
                    };
                    const int organ = within({14, 14, 15}, 8.5)                   ? 1
                        : within({31, 14, 15}, 7.5)                               ? 2
                        : y >= 24 && y < 31 && x > 4 && x < 40 && z > 4 && z < 26 ? 3
                                                                                  : 0;
                    constexpr std::array<int, 4> values{700, 2000, 2100, 3000};
                    truth.push_back(std::uint8_t(organ));
                    volume.codes.push_back(std::uint16_t(
                        values[std::size_t(organ)] + test::randomInt(random, -60, 60)));
                }
            }
        }
    }
    /// An edit that makes segments of some of it: each a list of organs.
    [[nodiscard]] Edit mask(const std::vector<std::vector<int>>& segments) const
    {
        std::vector<test::MaskPart> parts;
        for (const std::vector<int>& organs : segments) {
            VoxelRuns runs;
            for (std::size_t at = 0; at < truth.size(); ++at) {
                if (std::find(organs.begin(), organs.end(), int(truth[at])) != organs.end())
                    runs.append(at, 1);
            }
            parts.push_back({QStringLiteral("S%1").arg(parts.size() + 1), runs, 5});
        }
        return test::maskImport(QStringLiteral("organs.nii"), size, parts);
    }
};

ChunkToggle click(std::initializer_list<glm::dvec3> places, int chunks, Mode mode = Mode::Toggle)
{
    // Its voxels are of one millimetre.
    return {.segment = 1, .chunks = chunks, .mode = mode, .pointsLps = places};
}

constexpr glm::dvec3 inFirst(14, 14, 15);
constexpr glm::dvec3 inSecond(31, 14, 15);
constexpr glm::dvec3 inOrgan(20, 27, 15);

struct Bench {
    explicit Bench(const QString& file = {})
        : session(*EditSession::create(engine, lobes.volume, {.file = file}))
    {
    }
    /// @return why it was refused, at once or later; empty if it was not
    QString tried(const Edit& edit) const
    {
        Result<void> done = session->apply(edit);
        if (done)
            done = session->settle();
        return done ? QString() : done.error().arguments.join(QStringLiteral(": "));
    }
    [[nodiscard]] const std::vector<HistoryRow>& rows() const { return session->history().rows(); }
    [[nodiscard]] std::vector<std::uint8_t> labels() const
    {
        return *session->questions().labels(0);
    }
    /// How much of an organ a label has, in per cent.
    [[nodiscard]] int shareOf(int organ, int label) const
    {
        const std::vector<std::uint8_t> held = labels();
        std::int64_t all = 0;
        std::int64_t own = 0;
        for (std::size_t at = 0; at < held.size(); ++at) {
            all += lobes.truth[at] == organ ? 1 : 0;
            own += lobes.truth[at] == organ && held[at] == label ? 1 : 0;
        }
        return int(100 * own / all);
    }
    [[nodiscard]] std::shared_ptr<const ChunkMap> map() const
    {
        std::shared_ptr<const ChunkMap> found;
        const auto there = [&] {
            found = session->chunks().map();
            if (!found)
                session->poll();
            return found != nullptr;
        };
        static_cast<void>(QTest::qWaitFor(there, 60000));
        return found;
    }

    Lobes lobes;
    reference::ReferenceEngine engine;
    std::unique_ptr<EditSession> session;
};

} // namespace

/// Edits that divide into chunks and click on them, as a session carries them out.
class ChunksTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void dividingIsARow()
    {
        Bench bench;
        QCOMPARE(bench.tried(bench.lobes.mask({{1}, {3}})), QString());
        const QByteArray before = bench.session->stateHash();
        QVERIFY(!bench.session->chunks().map());
        int told = 0;
        bench.session->setListener([&told](const DocumentChange& change) {
            told += change.what == DocumentChange::What::Chunks ? 1 : 0;
        });
        QCOMPARE(bench.tried(DivideSegment{.segment = 1, .marginMm = 12.0}), QString());
        QCOMPARE(
            bench.rows().back().name, QStringLiteral("Divide around 'S1' into chunks, 12.0 mm"));
        QCOMPARE(bench.session->document().chunks->segment, 1);
        QVERIFY(bench.session->stateHash() != before);
        QCOMPARE(told, 1);
        const auto& divided = bench.rows().back().edit.get<DivideSegment>();
        QCOMPARE(divided.owners->size(), std::size_t(2));
        QCOMPARE(divided.owners->back().label, 2);

        // The same again is nothing; once something is different it is a division of its own.
        QCOMPARE(bench.tried(DivideSegment{.segment = 1, .marginMm = 12.0}), QString());
        QCOMPARE(bench.rows().size(), std::size_t(2));
        QCOMPARE(bench.tried(DivideSegment{.segment = 1, .marginMm = 11.0}), QString());
        QCOMPARE(bench.session->document().chunks->id, 2);

        // Its chunks are those of codes and labels in the box.
        const auto map = bench.map();
        QVERIFY(map);
        QCOMPARE(told, 3);
        std::vector<std::uint16_t> codes;
        std::vector<std::uint8_t> owners;
        const std::vector<std::uint8_t> labels = bench.labels();
        const VoxelBox box =
            *ChunkMap::boxAround(labels, 1, bench.lobes.volume.volume.geometry, 11.0);
        QCOMPARE(map->box().minimum, box.minimum);
        QCOMPARE(map->box().maximum, box.maximum);
        for (int z = box.minimum.z; z < box.maximum.z; ++z) {
            for (int y = box.minimum.y; y < box.maximum.y; ++y) {
                for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                    const auto at = std::size_t((z * size.y + y) * size.x + x);
                    codes.push_back(bench.lobes.volume.codes[at]);
                    owners.push_back(labels[at]);
                }
            }
        }
        const auto tree = ChunkTree::of(
            {.size = box.maximum - box.minimum, .codes = codes, .owners = owners}, {});
        QCOMPARE(map->tree().finest(), tree->finest());
        for (const int count : {2, 40, 5000}) {
            for (std::size_t voxel = 0; voxel < codes.size(); voxel += 17)
                QCOMPARE(map->tree().chunkAt(voxel, count), tree->chunkAt(voxel, count));
        }
    }

    /// A map that calls the second lobe likely: the row holds it, and one click adds the lobe.
    void aProbabilityMapIsPartOfTheRow()
    {
        QTemporaryDir folder;
        Bench bench(folder.filePath(QStringLiteral("a.burin")));
        QCOMPARE(bench.tried(bench.lobes.mask({{1}})), QString());
        std::vector<std::uint8_t> map;
        for (const std::uint8_t organ : bench.lobes.truth)
            map.push_back(organ == 1 ? 250 : organ == 2 ? 110 : 2);
        DivideSegment division{.segment = 1, .marginMm = 25.0};
        division.probabilities = ProbabilityMap::packed(map);
        const QByteArray before = bench.session->stateHash();
        QCOMPARE(bench.tried(division), QString());
        QCOMPARE(bench.rows().back().name,
            QStringLiteral("Divide around 'S1' into chunks by a probability map, 25.0 mm"));
        QCOMPARE(
            *bench.rows().back().edit.get<DivideSegment>().probabilities, *division.probabilities);
        const auto chunks = bench.map();
        QVERIFY(chunks);
        const auto likelihood = [&](const glm::ivec3& at) {
            return chunks->tree().likelihood(*chunks->chunkAt(at, 8));
        };
        QVERIFY(likelihood(glm::ivec3(inFirst)) > 200);
        QVERIFY(likelihood(glm::ivec3(inSecond)) < 100);
        QVERIFY(likelihood(glm::ivec3(inOrgan)) > 200);
        QCOMPARE(bench.tried(click({inSecond}, 8)), QString());
        QVERIFY(bench.shareOf(2, 1) >= 95);
        const QByteArray after = bench.session->stateHash();
        QVERIFY(bench.session->undo() && bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), before);
        QVERIFY(bench.session->redo() && bench.session->redo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), after);
        // As JSON and back.
        const Edit kept(bench.rows()[1].edit);
        const auto read = editFromJson(editToJson(kept));
        QVERIFY(read && read->get<DivideSegment>() == kept.get<DivideSegment>());

        // The map is part of what makes a division another one.
        QCOMPARE(bench.tried(DivideSegment{.segment = 1, .marginMm = 25.0}), QString());
        QVERIFY(!bench.rows().back().edit.get<DivideSegment>().probabilities);

        // What cannot be: of another volume, damaged, not read.
        const std::size_t rows = bench.rows().size();
        division.probabilities = ProbabilityMap::packed(std::vector<std::uint8_t>(8, 1));
        QVERIFY(bench.tried(division).contains(QLatin1String("of another volume")));
        division.probabilities = ProbabilityMap::packed(map);
        division.probabilities->chop(3);
        QVERIFY(bench.tried(division).contains(QLatin1String("damaged")));
        division.probabilities.reset();
        division.probabilityFile = QStringLiteral("map.nii.gz");
        QVERIFY(bench.tried(division).contains(QLatin1String("has not been read")));
        QCOMPARE(bench.rows().size(), rows);
    }

    void whatCannotBe()
    {
        Bench bench;
        QCOMPARE(bench.tried(bench.lobes.mask({{1}, {3}})), QString());
        QVERIFY(bench.tried(DivideSegment{.segment = 7}).contains(QLatin1Char('7')));
        QVERIFY(bench.tried(click({inFirst}, 10)).contains(QStringLiteral("nothing is divided")));
        QCOMPARE(bench.tried(test::newSegment(QStringLiteral("Empty"), 1)), QString());
        QVERIFY(bench.tried(DivideSegment{.segment = 3}).contains(QStringLiteral("no voxels")));
        QVERIFY(!bench.tried(DivideSegment{.segment = 1, .marginMm = -1.0}).isEmpty());
        DivideSegment damaged{.segment = 1};
        damaged.owners = {{.label = 1, .voxels = "rubbish"}};
        QVERIFY(bench.tried(damaged).contains(QStringLiteral("damaged")));
        VoxelRuns other;
        other.append(3, 9);
        damaged.owners = {{.label = 2, .voxels = packedRuns(other)}};
        QVERIFY(bench.tried(damaged).contains(QStringLiteral("not among them")));
        QCOMPARE(bench.rows().size(), std::size_t(2));

        QCOMPARE(bench.tried(DivideSegment{.segment = 1, .marginMm = 4.0}), QString());
        QVERIFY(bench.tried(click({{-20, 0, 0}}, 10)).contains(QStringLiteral("outside")));
        QVERIFY(!bench.tried(click({}, 10)).isEmpty());
        QVERIFY(!bench.tried(click({inFirst}, 0)).isEmpty());
        QCOMPARE(bench.tried(click({{45, 33, 29}}, 10)), QString()); // beside the box
        QCOMPARE(bench.rows().size(), std::size_t(3));
        QCOMPARE(bench.tried(test::lockSegment(1)), QString());
        QVERIFY(bench.tried(click({inFirst}, 10)).contains(QStringLiteral("S1")));
        QCOMPARE(bench.rows().size(), std::size_t(4));

        QCOMPARE(bench.tried(test::lockSegment(1, false)), QString());
        QCOMPARE(bench.tried(RemoveSegment{.segment = 1}), QString());
        QVERIFY(!bench.session->document().chunks);
        ChunkToggle toTheOther = click({inFirst}, 10);
        toTheOther.segment = 2;
        QVERIFY(bench.tried(toTheOther).contains(QStringLiteral("nothing is divided")));
        QCOMPARE(bench.tried(DivideSegment{.segment = 2}), QString());
        QCOMPARE(bench.session->document().chunks->id, 2);
    }

    /// What cannot be worked out is told once, and to whoever clicks; then it may be tried again.
    void whatFailsIsTold()
    {
        const Lobes lobes;
        reference::RefusingEngine engine;
        const auto session = *EditSession::create(engine, lobes.volume, {});
        QStringList told;
        session->setErrorListener(
            [&told](const Error& error) { told += error.arguments.join(QLatin1Char(' ')); });
        QVERIFY(session->apply(lobes.mask({{1}, {3}})) && session->settle());
        QVERIFY(session->apply(DivideSegment{.segment = 1, .marginMm = 9.0}) && session->settle());
        SessionChunks& chunks = session->chunks();
        QVERIFY(!chunks.stage() && !chunks.whyNot());
        QVERIFY(!chunks.map());
        QVERIFY(chunks.stage());
        QVERIFY(!session->settle());
        QCOMPARE(told, QStringList{QStringLiteral("no room for codes")});
        QVERIFY(!chunks.stage() && chunks.whyNot());
        QVERIFY(!chunks.map());
        QVERIFY(session->settle());
        QCOMPARE(told.size(), 1);

        QVERIFY(session->apply(click({inSecond}, 8)));
        const Result<void> clicked = session->settle();
        QVERIFY(!clicked && clicked.error().code == ErrorCode::OutOfMemory);
        QCOMPARE(told.size(), 2);
        engine.refuses = false;
        QVERIFY(session->apply(click({inSecond}, 8)) && session->settle());
        QVERIFY(chunks.map());
        QCOMPARE(session->history().rows().size(), std::size_t(3));
        QCOMPARE(told.size(), 2);
    }

    void whatIsCalledOffIsNotTold()
    {
        const Bench bench;
        QCOMPARE(bench.tried(bench.lobes.mask({{1}, {3}})), QString());
        QCOMPARE(bench.tried(DivideSegment{.segment = 1, .marginMm = 9.0}), QString());
        SessionChunks& chunks = bench.session->chunks();
        QVERIFY(!chunks.map() && chunks.stage());
        chunks.cancel();
        QVERIFY(!chunks.stage());
        QVERIFY(bench.session->settle());
        QVERIFY(!chunks.map());
        chunks.forgetFailure();
        QVERIFY(bench.map());
        // Who waits for it is told.
        chunks.forgetFailure();
        QCOMPARE(bench.tried(DivideSegment{.segment = 1, .marginMm = 10.0}), QString());
        QVERIFY(bench.session->apply(click({inOrgan}, 8)));
        chunks.cancel();
        const Result<void> clicked = bench.session->settle();
        QVERIFY(!clicked && clicked.error().code == ErrorCode::Cancelled);
    }

    /// The paper's first stage: a lobe that was missed comes with a click, a leak goes with one.
    void aMissedLobeAndALeak()
    {
        Bench bench;
        QCOMPARE(bench.tried(bench.lobes.mask({{1, 3}})), QString());
        QCOMPARE(bench.tried(DivideSegment{.segment = 1, .marginMm = 20.0}), QString());
        const int few = 8;
        QCOMPARE(bench.tried(click({inSecond}, few)), QString());
        qInfo("the lobe comes: %d %%", bench.shareOf(2, 1));
        QVERIFY(bench.shareOf(2, 1) >= 95);
        QVERIFY(bench.shareOf(0, 1) <= 5);
        QVERIFY(bench.rows().back().name.startsWith(QStringLiteral("Add chunks to 'S1', +")));
        QCOMPARE(bench.tried(click({inOrgan}, few)), QString());
        qInfo("the leak goes: %d %% are left", bench.shareOf(3, 1));
        QVERIFY(bench.shareOf(3, 1) <= 5);
        QVERIFY(bench.shareOf(1, 1) >= 95);
        QVERIFY(bench.rows().back().name.startsWith(QStringLiteral("Take chunks from 'S1', −")));
        // Both at once, and back.
        const std::vector<std::uint8_t> repaired = bench.labels();
        QCOMPARE(bench.tried(click({inSecond, inOrgan}, few)), QString());
        QVERIFY(bench.rows().back().name.startsWith(QStringLiteral("Toggle chunks of 'S1', +")));
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.labels(), repaired);
    }

    /// Random clicks do what ChunkMap says.
    void clicksAreThoseOfTheMap()
    {
        test::Random random(12);
        Bench bench;
        QCOMPARE(bench.tried(bench.lobes.mask({{1}, {3}})), QString());
        QCOMPARE(bench.tried(DivideSegment{.segment = 1, .marginMm = 9.0}), QString());
        const auto map = bench.map();
        for (int round = 0; round < 40; ++round) {
            ChunkToggle edit = click({}, test::randomInt(random, 1, 400));
            std::vector<glm::ivec3> voxels;
            for (int i = test::randomInt(random, 1, 4); i > 0; --i) {
                voxels.push_back(test::randomVoxel(random, size));
                edit.pointsLps.emplace_back(voxels.back());
            }
            edit.mode = Mode(random() % 3);
            edit.overwriteUnlocked = random() % 2;
            std::vector<std::uint8_t> expected = bench.labels();
            ChunkChange change = map->toggled(voxels, edit.chunks, expected, 1);
            if (edit.mode == Mode::Add)
                change = {.given = united(change.given, change.taken), .taken = {}};
            else if (edit.mode == Mode::Remove)
                change = {.given = {}, .taken = united(change.given, change.taken)};
            for (const VoxelRun& run : change.given.runs()) {
                for (std::uint64_t at = run.first; at < run.first + run.count; ++at) {
                    if (expected[at] == 0 || edit.overwriteUnlocked)
                        expected[at] = 1;
                }
            }
            for (const VoxelRun& run : change.taken.runs()) {
                for (std::uint64_t at = run.first; at < run.first + run.count; ++at) {
                    if (expected[at] == 1)
                        expected[at] = 0;
                }
            }
            const std::size_t rows = bench.rows().size();
            const bool same = expected == bench.labels();
            QCOMPARE(bench.tried(edit), QString());
            QCOMPARE(bench.labels(), expected);
            QCOMPARE(bench.rows().size(), same ? rows : rows + 1);
        }
    }

    /// Chunks are those of the newest division on the way to where the history stands.
    void walkingBackBringsTheOlderDivisionBack()
    {
        Bench bench;
        QCOMPARE(bench.tried(bench.lobes.mask({{1}, {3}})), QString());
        QCOMPARE(bench.tried(DivideSegment{.segment = 1, .marginMm = 3.0}), QString());
        const VoxelBox narrow = bench.map()->box();
        QCOMPARE(bench.tried(DivideSegment{.segment = 2, .marginMm = 6.0}), QString());
        QVERIFY(bench.map()->box().minimum != narrow.minimum);
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.map()->box().minimum, narrow.minimum);
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QVERIFY(!bench.session->chunks().map());
        QVERIFY(bench.session->goTo(3));
        QVERIFY(bench.session->settle());
        QVERIFY(bench.map()->box().minimum != narrow.minimum);
    }

    /// The program ended between the two halves of a row: it is carried out again, and what is told
    /// afterwards goes by a division that nobody has worked out yet.
    void afterACrash_data()
    {
        QTest::addColumn<QString>("lost");
        QTest::newRow("nothing") << QString();
        QTest::newRow("the click") << QStringLiteral("=3");
        QTest::newRow("the division") << QStringLiteral(">=2");
        QTest::newRow("all") << QStringLiteral(">=1");
    }
    void afterACrash()
    {
        QFETCH(QString, lost);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.burin"));
        QByteArray hash;
        QByteArray later;
        {
            Bench bench(file);
            QCOMPARE(bench.tried(bench.lobes.mask({{1, 3}})), QString());
            QCOMPARE(bench.tried(DivideSegment{.segment = 1, .marginMm = 20.0}), QString());
            QCOMPARE(bench.tried(click({inSecond}, 8)), QString());
            hash = bench.session->stateHash();
            QCOMPARE(bench.tried(click({inOrgan}, 8)), QString());
            later = bench.session->stateHash();
            QVERIFY(bench.session->undo());
            QVERIFY(bench.session->settle());
        }
        if (!lost.isEmpty()) {
            QVERIFY(test::runSql(file,
                QStringLiteral(
                    "UPDATE row SET stateHash=NULL, deltaSha256=NULL, seal=NULL WHERE id")
                    + lost));
            QVERIFY(test::runSql(file, QStringLiteral("DELETE FROM delta WHERE row") + lost));
        }
        const Lobes lobes;
        reference::ReferenceEngine inner;
        reference::DelayedEngine engine(inner, 5);
        const auto session = EditSession::open(engine, lobes.volume, file);
        QVERIFY(session);
        QCOMPARE((*session)->stateHash(), hash);
        QVERIFY((*session)->apply(click({inOrgan}, 8)));
        QVERIFY((*session)->settle());
        QCOMPARE((*session)->stateHash(), later);
    }

    /// Other clicks are no reason against it, clicks on the same place are.
    void undoOnlyAClick()
    {
        Bench bench;
        QCOMPARE(bench.tried(bench.lobes.mask({{1, 3}})), QString());
        QCOMPARE(bench.tried(DivideSegment{.segment = 1, .marginMm = 20.0}), QString());
        const std::vector<std::uint8_t> before = bench.labels();
        QCOMPARE(bench.tried(click({inOrgan}, 8)), QString());
        // In bricks above the organ's.
        QCOMPARE(bench.tried(click({{14, 8, 12}}, 1000)), QString());
        QVERIFY(
            bench.tried(test::revertRows({2})).contains(QStringLiteral("no voxel, only what is")));
        const auto& chunk = bench.rows().back().edit.get<ChunkToggle>();
        QVERIFY(!chunk.bricks->empty() && chunk.bricks->size() <= 8);
        QCOMPARE(bench.tried(test::revertRows({3})), QString());
        std::vector<std::uint8_t> expected = bench.labels();
        for (std::size_t at = 0; at < before.size(); ++at) {
            if (bench.lobes.truth[at] == 3)
                QCOMPARE(expected[at], before[at]);
        }
        QCOMPARE(bench.tried(click({inOrgan}, 8)), QString());
        QVERIFY(bench.tried(test::revertRows({5})).contains(QStringLiteral("the same place")));
    }

    /// A recipe says what was clicked, and comes to the same.
    void asARecipe()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.burin"));
        QByteArray hash;
        {
            Bench bench(file);
            QCOMPARE(bench.tried(bench.lobes.mask({{1, 3}})), QString());
            QCOMPARE(bench.tried(DivideSegment{.segment = 1, .marginMm = 20.0}), QString());
            QCOMPARE(bench.tried(click({inSecond}, 8, Mode::Add)), QString());
            hash = bench.session->stateHash();
        }
        const auto opened = SessionFile::open(file, SessionFile::Access::PrivateCopy);
        QVERIFY(opened);
        const QJsonArray edits =
            historyAsRecipe((*opened)->contents())[QStringLiteral("edits")].toArray();
        QCOMPARE(edits[1].toObject().keys(),
            (QStringList{
                QStringLiteral("edit"), QStringLiteral("marginMm"), QStringLiteral("segment")}));
        QVERIFY(!edits[2].toObject().contains(QStringLiteral("bricks")));
        QCOMPARE(edits[2].toObject()[QStringLiteral("mode")].toString(), QStringLiteral("add"));
        Bench again;
        for (const QJsonValue& edit : edits)
            QCOMPARE(again.tried(*editFromJson(edit)), QString());
        QCOMPARE(again.session->stateHash(), hash);
    }
};

BURIN_TEST(ChunksTest)

} // namespace chunksTest

#include "ChunksTest.moc"
