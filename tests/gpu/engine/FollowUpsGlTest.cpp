// SPDX-License-Identifier: Apache-2.0
#include "core/engine/EngineCommands.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/faults/RefusingGl.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <optional>
#include <vector>

namespace followUpsGlTest {

using namespace core;
using test::RefusingGl;

/// What follows from edits is worked out between them. Where there is no memory for it, that is
/// tried again for a while.
class FollowUpsGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void othersDoNotUseThePatienceUp();
    void whatWaitsIsDoneInTheEnd();

private:
    /// A volume with a seed, whose brick is looked through for barriers when its growth is shown.
    void open()
    {
        const std::vector<std::uint16_t> codes(std::size_t(24 * 24 * 24), 7);
        QVERIFY(m_gpu.engine().openVolume({24, 24, 24}, codes));
        m_gpu.showGrowth(0);
        submitWhole(
            m_gpu.engine(), SeedPlacement{.plane = 0, .label = 1, .voxels = {{12, 12, 12}}});
        QVERIFY(!test::lastResult(m_gpu.engine()).error);
        m_gpu.rest();
    }
    /// Has the brick looked through anew.
    void lookAgain()
    {
        m_gpu.showGrowth(1);
        m_gpu.showGrowth(0);
    }
    [[nodiscard]] bool answers()
    {
        m_gpu.engine().submit(ReadBricks{{{Field::SeedWords, 0, 0}}});
        return !test::lastResult(m_gpu.engine()).error;
    }

    // Only a kernel needs memory to look through a brick.
    test::EditEngineFixture m_gpu{gpu::WorkBy::Kernels};
};

/// The engine's thread turns all the time while pictures are drawn: it has more turns than it tries
/// things, but hardly any time has passed.
void FollowUpsGlTest::othersDoNotUseThePatienceUp()
{
    open();
    constexpr int turns = 60;
    {
        const RefusingGl refusing(1, RefusingGl::From::OnAndOn);
        lookAgain();
        for (int turn = 0; turn < turns; ++turn)
            m_gpu.showGrowth(0);
        QVERIFY(refusing.refused() > 0);
    }
    QVERIFY(answers());
}

void FollowUpsGlTest::whatWaitsIsDoneInTheEnd()
{
    open();
    lookAgain();
    m_gpu.rest();
    int calls = 0;
    {
        std::optional<RefusingGl> refusing(std::in_place, 0);
        lookAgain();
        m_gpu.rest();
        calls = refusing->calls();
        refusing.reset();
        refusing.emplace(1);
        lookAgain();
        // Nothing else wakes the thread.
        QTRY_COMPARE(refusing->calls(), 1 + calls);
        QCOMPARE(refusing->refused(), 1);
        m_gpu.rest();
    }
    QVERIFY(calls > 0);
    QVERIFY(answers());
}

BURIN_TEST(FollowUpsGlTest)

} // namespace followUpsGlTest

#include "FollowUpsGlTest.moc"
