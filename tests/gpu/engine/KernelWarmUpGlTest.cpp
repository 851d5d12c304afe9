// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/KernelWarmUp.h"

#include "gpu/engine/EditPrograms.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace kernelWarmUpGlTest {

using namespace gpu;

/// Which kernels are compiled before an edit needs them.
class KernelWarmUpGlTest : public test::FrameTest {
    Q_OBJECT

private Q_SLOTS:
    void init() { m_fixture.emplace(); }

    /// Those that leave some voxels alone are a warm-up of their own, and no other kernel is in it.
    void editableRangesHaveTheirOwn()
    {
        EditPrograms programs(m_fixture->shaders);
        const auto areReady = [&programs](bool editable) {
            int ready = 0;
            for (const char* rule : {"RELABELLED", "OUTLINED", "THRESHOLD", "SCISSORS"})
                ready += programs.label.isReady(rule, editable);
            return ready;
        };
        QVERIFY(!programs.capsule.isReady(false, true) && !programs.capsule.isReady(true, true));
        KernelWarmUp within(programs, m_fixture->fieldPrograms,
            KernelWarmUp::sizeLike({100, 90, 80}), KernelWarmUp::Of::EditableRanges);
        QVERIFY(within.runNext()); // brushes
        QVERIFY(programs.capsule.isReady(false, true) && programs.capsule.isReady(true, true));
        QCOMPARE(areReady(true), 0);
        QVERIFY(!within.runNext());
        QCOMPARE(areReady(true), 4);
        QCOMPARE(areReady(false), 0);
        QVERIFY(!programs.capsule.isReady(true, false));
        QVERIFY(!within.runNext()); // that was all
    }
};

BURIN_TEST(KernelWarmUpGlTest)

} // namespace kernelWarmUpGlTest

#include "KernelWarmUpGlTest.moc"
