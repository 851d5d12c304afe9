// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace takenVoxelsTest {

using namespace core;

/// What a growth takes from a painted segment, through rows, undo and a session file.
class TakenVoxelsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void shrinkingReturnsThemInAReopenedSession();
    void aNarrowerIntervalReturnsThem();
    void shrinkingHereReturnsThem();
    void undoBringsBackWhatIsRememberedOfADeletedSegment();

private:
    void run(const Edit& edit);
    [[nodiscard]] std::vector<std::uint8_t> labels() const
    {
        return *m_session->questions().labels(0);
    }
    [[nodiscard]] std::int64_t voxels(int label) const
    {
        const std::vector<std::uint8_t> all = labels();
        return std::count(all.begin(), all.end(), label);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<reference::ReferenceEngine> m_engine;
    std::unique_ptr<EditSession> m_session;
    std::vector<std::uint8_t> m_before; ///< any growth
    std::int64_t m_painted = 0;
};

namespace {

constexpr int painted = 1;
constexpr int grown = 2;

const GrowCriteria takingAll{.lower = 0, .upper = 100, .overwriteUnlocked = true};

} // namespace

void TakenVoxelsTest::init()
{
    test::failOnUnexpectedMessages();
    m_session.reset();
    m_folder = std::make_unique<QTemporaryDir>();
    m_engine = std::make_unique<reference::ReferenceEngine>();
    m_session = *EditSession::create(
        *m_engine, test::smallStudy(), {.file = m_folder->filePath(QStringLiteral("a.burin"))});
    const Edit seed = test::seedInBrain(grown);
    run(test::addSegment("Painted"));
    run(test::addSegment("Grown"));
    run(test::paintAt(painted, {test::pointsInBrain().back() + glm::dvec3(5.0, 0, 0)}, 3.0));
    m_before = labels();
    m_painted = voxels(painted);
    QVERIFY(m_painted > 50);
    run(seed);
    run(test::growBy(takingAll));
    QCOMPARE(voxels(painted), 0);
}

void TakenVoxelsTest::run(const Edit& edit)
{
    const Result<void> applied = m_session->apply(edit);
    QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
    QVERIFY(m_session->settle());
}

void TakenVoxelsTest::shrinkingReturnsThemInAReopenedSession()
{
    const QByteArray hash = m_session->stateHash();
    m_session.reset();
    m_engine = std::make_unique<reference::ReferenceEngine>();
    auto opened = EditSession::open(
        *m_engine, test::smallStudy(), m_folder->filePath(QStringLiteral("a.burin")));
    QVERIFY(opened);
    m_session = *std::move(opened);
    QVERIFY(m_session->settle());
    QCOMPARE(m_session->stateHash(), hash);

    run(ShrinkSteps{});
    QCOMPARE(voxels(painted), m_painted);
    QCOMPARE(voxels(grown), 2); // the seeds
    std::vector<std::uint8_t> now = labels();
    std::replace(now.begin(), now.end(), std::uint8_t(grown), std::uint8_t(0));
    QVERIFY(now == m_before);
    QVERIFY(m_session->undo());
    QVERIFY(m_session->settle());
    QCOMPARE(m_session->stateHash(), hash);
    QCOMPARE(voxels(painted), 0);
}

void TakenVoxelsTest::aNarrowerIntervalReturnsThem()
{
    ChangeInterval narrow{.criteria = takingAll};
    narrow.criteria.lower = narrow.criteria.upper = 99.0;
    const std::int64_t all = voxels(grown);
    run(narrow);
    QVERIFY(labels() == m_before);
    // What returns to another segment is lost to this one.
    QString digits;
    for (const QChar each : m_session->history().rows().back().name)
        digits += each.isDigit() || each == u'−' || each == u'+' ? QString(each) : QString();
    QVERIFY2(digits.endsWith(QStringLiteral("9999−%1").arg(all)), qPrintable(digits));
    ChangeInterval wide{.criteria = takingAll};
    run(wide);
    QCOMPARE(voxels(painted), 0);
}

void TakenVoxelsTest::shrinkingHereReturnsThem()
{
    const VolumeGeometry& geometry = m_session->document().volumes.front().geometry;
    ShrinkAt here{.onlyHere = true, .barrier = false};
    for (std::size_t i = 0; i < m_before.size(); ++i) {
        const glm::ivec3& size = geometry.size;
        const glm::dvec3 voxel(int(i) % size.x, int(i) / size.x % size.y, int(i) / size.x / size.y);
        if (m_before[i] == painted)
            here.pointsLps.push_back(geometry.toWorld(voxel));
    }
    run(here);
    QCOMPARE(voxels(painted), m_painted);
}

void TakenVoxelsTest::undoBringsBackWhatIsRememberedOfADeletedSegment()
{
    const QByteArray hash = m_session->stateHash();
    run(RemoveSegment{.segment = painted});
    QVERIFY(m_session->undo());
    QVERIFY(m_session->settle());
    QCOMPARE(m_session->stateHash(), hash);
    run(ShrinkSteps{});
    QCOMPARE(voxels(painted), m_painted);
    for (int i = 0; i < 2; ++i)
        QVERIFY(i == 0 ? m_session->undo() : m_session->redo());
    QVERIFY(m_session->settle());
    QVERIFY(m_session->undo());
    QVERIFY(m_session->settle());
    run(RemoveSegment{.segment = painted});
    run(ShrinkSteps{});
    QCOMPARE(voxels(painted), 0);
}

BURIN_TEST(TakenVoxelsTest)

} // namespace takenVoxelsTest

#include "TakenVoxelsTest.moc"
