// SPDX-License-Identifier: Apache-2.0
#include "core/edits/sculpt/SculptEdits.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace sculptEditsTest {

using namespace core;

/// What of an older cut can be revised.
class SculptEditsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void masksOfAnyShapeAreResized()
    {
        DrillStroke stroke;
        stroke.mask = {.kind = ToolMask::Kind::Square, .widthMm = 10.0, .heightMm = 4.0};
        QCOMPARE(parametersOf(stroke).sideMm, std::optional<double>(10.0));
        QVERIFY(!parametersOf(stroke).radiusMm);
        Result<SculptEdit> now = revised(stroke, {.row = 1, .sideMm = 6.0});
        QVERIFY(now);
        QCOMPARE(now->get<DrillStroke>().mask.widthMm, 6.0);
        QVERIFY(!revised(stroke, {.row = 1, .widthMm = 6.0}));
        QVERIFY(!revised(stroke, {.row = 1, .factor = 2.0}));

        for (const ToolMask::Kind kind :
            {ToolMask::Kind::Ellipse, ToolMask::Kind::Rectangle, ToolMask::Kind::Rounded}) {
            stroke.mask.kind = kind;
            now = revised(stroke, {.row = 1, .widthMm = 7.0, .heightMm = 5.0});
            QVERIFY(now);
            QCOMPARE(now->get<DrillStroke>().mask.widthMm, 7.0);
            QCOMPARE(now->get<DrillStroke>().mask.heightMm, 5.0);
            QVERIFY(!revised(stroke, {.row = 1, .radiusMm = 6.0}));
        }

        LaserStroke laser;
        laser.mask.polygonMm = {{0, 0}, {4, 0}, {0, 6}};
        QCOMPARE(parametersOf(laser).factor, std::optional<double>(1.0));
        now = revised(laser, {.row = 1, .factor = 1.5});
        QVERIFY(now);
        QCOMPARE(now->get<LaserStroke>().mask.polygonMm->at(1), glm::dvec2(6, 0));
        QVERIFY(!revised(laser, {.row = 1, .radiusMm = 6.0}));
    }

    /// About the middle of what it spans.
    void outlinesAreResized()
    {
        const std::vector<glm::dvec2> outline{{10, 10}, {14, 10}, {14, 12}, {10, 12}};
        const std::vector<glm::dvec2> twice{{8, 9}, {16, 9}, {16, 13}, {8, 13}};
        for (const SculptEdit& cut : {SculptEdit(PeelCut{.polygonMm = outline}),
                 SculptEdit(ScissorsCut{.polygonMm = outline})}) {
            const Result<SculptEdit> now = revised(cut, {.row = 1, .factor = 2.0});
            QVERIFY(now);
            if (const auto* peel = now->as<PeelCut>())
                QCOMPARE(peel->polygonMm, twice);
            else
                QCOMPARE(now->get<ScissorsCut>().polygonMm, twice);
        }
    }
};

BURIN_TEST(SculptEditsTest)

} // namespace sculptEditsTest

#include "SculptEditsTest.moc"
