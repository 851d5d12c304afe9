// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/AddSegment.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/tools/growth/ShrinkPreview.h"
#include "ui/tools/growth/ShrinkTool.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/Workspace.h"

#include <QtTest>

#include <functional>

namespace shrinkPreviewUiTest {

/// The Shrink tool in the real window, with the real engine: what it would take is hatched in the
/// pictures while the pen is down, and only then.
class ShrinkPreviewUiTest : public QObject {
    Q_OBJECT

private:
    /// Pixels in the colours that mark what would go.
    static int hatched(ui::ImageView& view)
    {
        const QImage picture = view.grab().toImage();
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QColor colour = picture.pixelColor(x, y);
                count += colour.red() > 90 && colour.red() > 2 * colour.green()
                        && colour.blue() > 2 * colour.green() && colour.blue() > 80
                    ? 1
                    : 0;
            }
        }
        return count;
    }
    static bool wait(const std::function<bool()>& condition)
    {
        return QTest::qWaitFor(condition, test::ApplicationFixture::patience);
    }

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void itIsHatchedWhileThePenIsDown_data()
    {
        QTest::addColumn<bool>("inVolume");
        QTest::newRow("slice") << false;
        QTest::newRow("3D") << true;
    }
    void itIsHatchedWhileThePenIsDown()
    {
        QFETCH(bool, inVolume);
        test::ApplicationFixture fixture;
        fixture.open(fixture.path("case/ct"));
        core::AddSegment bone = test::addSegment("Bone").get<core::AddSegment>();
        bone.rgb = 0x40C040;
        fixture.edit(bone);
        fixture.edit(test::seedInBone(1));
        fixture.edit(test::growBone());
        auto* tool = fixture.window().findChild<ui::ShrinkTool*>();
        QVERIFY(tool);
        tool->setRest(3600 * 1000); // the pen is held still only to look at pictures
        fixture.workspace().setActiveTool(tool);
        ui::ViewGrid& views = fixture.window().views();
        const auto drawn = [&] {
            return test::waitUntilDrawn(fixture.window(), fixture.workspace());
        };
        // Through the shell's front, which the 3D view looks at.
        const glm::dvec3 place = test::pointsInBone().front() + glm::dvec3(3.0, 0.0, 0.0);
        fixture.workspace().setCrosshairLps(place);
        QVERIFY(drawn());
        ui::ImageView& where =
            inVolume ? static_cast<ui::ImageView&>(views.volume()) : views.axial();
        QCOMPARE(hatched(views.axial()), 0);
        QCOMPARE(hatched(views.volume()), 0);
        const std::size_t rows = fixture.session().history().rows().size();
        const QByteArray grown = fixture.session().stateHash();

        const QPoint at = where.context().toPixel(place).toPoint();
        const QPoint end(60, 0);
        const auto sketch = [&] {
            QTest::mousePress(&where, Qt::LeftButton, Qt::NoModifier, at);
            for (int x = 0; x <= end.x(); x += 10)
                QTest::mouseMove(&where, at + QPoint(x, 0));
            return wait([&] { return tool->previewIsWhole(); });
        };
        QVERIFY(sketch());
        const std::int64_t voxels = tool->preview().voxels().value_or(0);
        QVERIFY(voxels > 0);
        QVERIFY(wait([&] { return hatched(views.axial()) > 20 && hatched(views.volume()) > 20; }));
        test::look(fixture.window().grab(), inVolume ? "shrink-3d.png" : "shrink-slice.png");
        QCOMPARE(fixture.session().history().rows().size(), rows);
        QTest::keyClick(&where, Qt::Key_Escape);
        QTest::mouseRelease(&where, Qt::LeftButton, Qt::NoModifier, at + end);
        QVERIFY(drawn());
        QVERIFY(wait([&] { return hatched(views.axial()) == 0 && hatched(views.volume()) == 0; }));
        QCOMPARE(fixture.session().stateHash(), grown);
        QCOMPARE(fixture.session().history().rows().size(), rows);

        QVERIFY(sketch());
        QCOMPARE(tool->preview().voxels().value_or(0), voxels);
        QTest::mouseRelease(&where, Qt::LeftButton, Qt::NoModifier, at + end);
        QVERIFY(wait([&] { return fixture.session().history().rows().size() == rows + 1; }));
        QCOMPARE(fixture.session().history().rows().back().statistics.voxelsChanged, voxels);
        QVERIFY(drawn());
        QVERIFY(wait([&] { return hatched(views.axial()) == 0 && hatched(views.volume()) == 0; }));
        test::look(fixture.window().grab(), inVolume ? "shrunk-3d.png" : "shrunk-slice.png");
    }
};

BURIN_WINDOW_TEST(ShrinkPreviewUiTest)

} // namespace shrinkPreviewUiTest

#include "ShrinkPreviewUiTest.moc"
