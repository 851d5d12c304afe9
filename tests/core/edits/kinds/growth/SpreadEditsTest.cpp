// SPDX-License-Identifier: Apache-2.0
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/sessions/SmallDocument.h"

#include <QTest>

namespace spreadEditsTest {

using namespace core;

class SpreadEditsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void growingFromSeedsIsToldInCodes()
    {
        Document document = test::smallDocument();
        document.volumes.front().minimum = -1000.0;
        document.volumes.front().maximum = 1000.0;
        Result<SpreadLabels> spread = spreadLabels(GrowFromSeeds{}, document);
        QVERIFY(spread);
        QCOMPARE(spread->seeds.count(), std::size_t(3));
        QVERIFY(!spread->box);
        // 2 a millimetre are 8 codes of 0.25, 32 quarters of them; voxels are 0.5 × 0.5 × 2 mm.
        QCOMPARE(int(spread->differenceWeight), 4);
        QCOMPARE(int(spread->lengths[0]), 16);
        QCOMPARE(int(spread->lengths[2]), 64);
        QCOMPARE(int(spread->lengths[3]), 23); // across: 0.707 mm
        GrowFromSeeds edit;
        edit.lengthCost = 0.0;
        edit.segments = {1, 3};
        edit.overwriteUnlocked = true;
        edit.box = GrowBox{{95.1, -50.2, 30}, {99, -45, 1000}};
        spread = spreadLabels(edit, document);
        QVERIFY(spread);
        QCOMPARE(int(spread->lengths[12]), 1); // no step costs nothing
        QVERIFY(spread->seeds[1] && !spread->seeds[2] && spread->overwritable[2]);
        QVERIFY(!spread->overwritable[1]);
        QVERIFY(spread->box->minimum == glm::ivec3(2, 0, 0));
        QVERIFY(spread->box->maximum == glm::ivec3(11, 11, 1));
        QVERIFY(isSound(*spread, document.volumes.front().geometry.size));
        document.segment(2)->locked = true;
        QVERIFY(!spreadLabels(edit, document)->overwritable[2]);
        document.segment(1)->locked = true;
        QCOMPARE(spreadLabels(edit, document).error().code, ErrorCode::SegmentLocked);
        QCOMPARE(spreadLabels(GrowFromSeeds{}, document).error().code, ErrorCode::InvalidField);
    }
};

BURIN_TEST(SpreadEditsTest)

} // namespace spreadEditsTest

#include "SpreadEditsTest.moc"
